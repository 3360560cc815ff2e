#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What mdana plan estimates against what is then measured: real runs of a Hertz scene, of an adhesive one with its defects,
and of aggregates, made by LAMMPS. Time and peak memory are to be right within a factor of 2.

With MDANA_LONG_RUNS=DIR the runs are kept in DIR, and taken from there if they are there."""

import os
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "oracles"))

import lammps
import running

FACTOR = 2
RUNS = {
    "hertz_r10_s1": ("hertz", "--radius", 10, "--velocity", "0.3", "--seed", 1),
    "defects_r10_v05": ("adhesive", "--radius", 10, "--velocity", "0.5", "--seed", 1),
    "aggregate_v5": ("aggregate", "--radius", 20, "--velocity", 5),
}
COMMANDS = (("hertz_r10_s1", "collision"), ("hertz_r10_s1", "report"), ("defects_r10_v05", "defects"),
            ("defects_r10_v05", "collision"), ("aggregate_v5", "compress"), ("aggregate_v5", "network"))


def measured(arguments):
    """Seconds and peak memory in bytes; both the least of two runs, the first of which also fills the page cache."""
    results = []
    for _ in range(2):
        start = time.monotonic()
        with subprocess.Popen([running.program, *map(str, arguments)], stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE) as process:
            error = process.stderr.read()
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode not in (0, 4):
            raise AssertionError(error.decode())
        results.append((time.monotonic() - start, 1024 * used.ru_maxrss))
    return min(seconds for seconds, _ in results), min(memory for _, memory in results)


class Estimates(running.Case):
    @classmethod
    def setUpClass(cls):
        cls.folder = lammps.kept_runs(cls)
        for name, arguments in RUNS.items():
            if not (cls.folder / name / "scene.toml").is_file():
                lammps.generate(*arguments, "--ranks", lammps.ranks(), "-o", cls.folder / name, timeout=3600)

    def of_a_report(self, folder):
        """The seconds that the analysis of the run took, as the report tells them, and the peak of its process."""
        place = self.dir / "report"
        start = self.dir / "runs"
        start.mkdir()
        (start / "run").symlink_to(folder)
        scene = start / "study.toml"
        scene.write_text(f'schema = 1\n[[run]]\nname = "run"\nscene = "{folder}/scene.toml"\n', encoding="utf-8")
        done = self.mdana("report", scene, "-o", place, timeout=3600)
        said = [line for line in done.stderr.splitlines() if " done in " in line][0]
        return float(said.split(" done in ")[1].split(" s")[0]), None

    def test_time_and_memory(self):
        print("\n| run | command | time, s: plan | measured | ratio | memory, MB: plan | measured | ratio | planned in |")
        print("|---|---|---|---|---|---|---|---|---|")
        for name, command in COMMANDS:
            folder = self.folder / name
            dump = folder / "dump.lammpstrj.gz"
            start = time.monotonic()
            estimate = self.document("plan", dump, "--for", command)["estimate"]
            planned = time.monotonic() - start
            seconds, memory = self.of_a_report(folder) if command == "report" else measured([command, dump])
            ratio = estimate["seconds"] / seconds
            cells = [name, command, f"{estimate['seconds']:.2f}", f"{seconds:.2f}", f"{ratio:.2f}"]
            cells += [f"{estimate['bytes'] / 1e6:.0f}"]
            cells += [f"{memory / 1e6:.0f}", f"{estimate['bytes'] / memory:.2f}"] if memory else ["", ""]
            print("| " + " | ".join(cells) + f" | {planned:.2f} s |", flush=True)
            with self.subTest(run=name, command=command):
                self.assertLess(max(ratio, 1 / ratio), FACTOR)
                if memory:
                    self.assertLess(max(estimate["bytes"] / memory, memory / estimate["bytes"]), FACTOR)


if __name__ == "__main__":
    running.main()
