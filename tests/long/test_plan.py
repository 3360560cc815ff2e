#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What mdana plan estimates against what is then measured: real runs of a Hertz scene, of an adhesive one with its defects,
and of aggregates, made by LAMMPS. Processor time and peak memory are to be right within a factor of 2; so is the time by the
clock, if the machine does nothing else.

With MDANA_LONG_RUNS=DIR the runs are kept in DIR, and taken from there if they are there."""

import os
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "oracles"))

import lammps
import running
from measuring import measured

FACTOR = 2
RUNS = {
    "hertz_r10_s1": ("hertz", "--radius", 10, "--velocity", "0.3", "--seed", 1),
    "defects_r10_v05": ("adhesive", "--radius", 10, "--velocity", "0.5", "--seed", 1),
    "aggregate_v5": ("aggregate", "--radius", 20, "--velocity", 5),
}
COMMANDS = (("hertz_r10_s1", "collision"), ("hertz_r10_s1", "report"), ("defects_r10_v05", "defects"),
            ("defects_r10_v05", "collision"), ("aggregate_v5", "compress"), ("aggregate_v5", "network"))


def least(arguments_of):
    """Seconds by the clock and of processors, and peak memory in bytes: each the least of two runs, the first of which also
    fills the page cache."""
    runs = [measured([running.program, *arguments_of(repetition)], codes=(0, 4))[1:] for repetition in range(2)]
    return [min(values) for values in zip(*runs)]


class Estimates(running.Case):
    @classmethod
    def setUpClass(cls):
        cls.folder = lammps.kept_runs(cls)
        for name, arguments in RUNS.items():
            if not (cls.folder / name / "scene.toml").is_file():
                lammps.generate(*arguments, "--ranks", lammps.ranks(), "-o", cls.folder / name, timeout=3600)

    def arguments(self, command, folder, repetition):
        if command != "report":
            return [command, folder / "dump.lammpstrj.gz"]
        study = self.dir / "study.toml"
        study.write_text(f'schema = 1\n[[run]]\nname = "run"\nscene = "{folder / "scene.toml"}"\n', encoding="utf-8")
        return ["report", study, "-o", self.dir / f"report-{repetition}", "--jobs", 1]

    def test_time_and_memory(self):
        print("\n| run | command | processor time, s: plan | measured | ratio | by the clock, s: plan | measured | ratio "
              "| memory, MB: plan | measured | ratio | planned in |\n" + "|---" * 12 + "|")
        for name, command in COMMANDS:
            folder = self.folder / name
            start = time.monotonic()
            estimate = self.document("plan", folder / "dump.lammpstrj.gz", "--for", command)["estimate"]
            planned = time.monotonic() - start
            idle = os.getloadavg()[0] < 0.5
            clock, processors, memory = least(lambda repetition: self.arguments(command, folder, repetition))
            cells, checked = [name, command], []
            for what, found, unit, matters in (("processor_seconds", processors, 1, True), ("seconds", clock, 1, idle),
                                               ("bytes", memory, 1e6, True)):
                ratio = estimate[what] / found
                cells += [f"{estimate[what] / unit:.3g}", f"{found / unit:.3g}", f"{ratio:.2f}"]
                checked += [(what, ratio)] if matters else []
            print("| " + " | ".join(cells) + f" | {planned:.2f} s |", flush=True)
            for what, ratio in checked:
                with self.subTest(run=name, command=command, what=what):
                    self.assertLess(max(ratio, 1 / ratio), FACTOR)


if __name__ == "__main__":
    running.main()
