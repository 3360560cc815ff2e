#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two threads and two MPI processes against one, and where the time of one goes: two tables in Markdown.

    scaling.py MDANA [--atoms N] [--repeat N] [--folder DIR] [DUMP]

Without a dump: three made-up frames of two fcc balls (tests/bench/memory.py). Wants a machine that does nothing else."""

import argparse
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from memory import write_dump

COMMANDS = {"force": [], "energy": [], "contact-radius": ["--layer", "2"], "defects": []}
MPIRUN = ["mpirun", "--oversubscribe", "--allow-run-as-root", "--bind-to", "none"]
WAYS = {"2 threads": (2, 1), "2 processes": (1, 2)}


def timed(command):
    """Wall and processor seconds, and standard error."""
    before = os.times()
    start = time.monotonic()
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
    wall = time.monotonic() - start
    after = os.times()
    if done.returncode not in (0, 3):
        sys.exit(f"{' '.join(command)}: exit {done.returncode}: {done.stderr}")
    return wall, after.children_user + after.children_system - before.children_user - before.children_system, done.stderr


def median(command, repeat):
    runs = [timed(command) for _ in range(repeat)]
    return statistics.median(run[0] for run in runs), statistics.median(run[1] for run in runs)


def timings(command):
    """Seconds by stage, of one thread."""
    _, _, error = timed([*command, "--timings"])
    found = re.findall(r"^(.+?)\s+([\d.]+) s\s+[\d.]+ %$", error, re.M)
    return {name.split(":")[0].split(",")[0]: float(seconds) for name, seconds in found}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mdana")
    parser.add_argument("dump", nargs="?")
    parser.add_argument("--atoms", type=float, default=2e6)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--folder", help="where the made-up dump is written (default: a temporary one)")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="mdana-bench-", dir=args.folder) as folder:
        dump, radius = args.dump, []
        if not dump:
            dump = str(Path(folder) / "dump.lammpstrj")
            radius = ["--radius", f"{write_dump(dump, int(args.atoms))[1]:.6g}"]
        scaling, stages = [], []
        for name, extra in COMMANDS.items():
            bodies = radius if name != "defects" or not radius else ["--bodies", "type"]
            command = [args.mdana, name, dump, *bodies, *extra, "--threads"]
            wall, cpu = median([*command, "1"], args.repeat)
            cells = [f"{wall:.2f} s", f"{Path(dump).stat().st_size / wall / 1e6:.0f} MB/s", f"{cpu / wall:.2f}"]
            for threads, processes in WAYS.values():
                start = [] if processes == 1 else [*MPIRUN, "-n", str(processes)]
                other, _ = median([*start, *command, str(threads)], args.repeat)
                cells.append(f"{wall / other:.2f}, {100 * wall / other / 2:.0f} %")
            cells.append("compute" if cpu / wall > 0.8 else "input and output")
            scaling.append(f"| {name} | " + " | ".join(cells) + " |")
            seconds = timings([*command, "1"])
            total = seconds.pop("in all")
            parallel = seconds["numbers converted and analysed"] + seconds["whole frames analysed (neighbours)"]
            stages.append((name, {stage: s / total for stage, s in seconds.items()}, 1 - parallel / total))
    print("Wall time, medians; speed-up and efficiency of two against one; printed by tests/bench/scaling.py\n")
    print("| command | one thread | text | processor / wall | " + " | ".join(WAYS) + " | bound by |")
    print("|---|---:|---:|---:|---:|---:|---|")
    print("\n".join(scaling))
    print("\n| share of one thread's time | " + " | ".join(name for name, _, _ in stages) + " |\n|---" + "|---:" * len(stages) + "|")
    for stage in stages[0][1]:
        print(f"| {stage} | " + " | ".join(f"{100 * shares[stage]:.0f} %" for _, shares, _ in stages) + " |")
    print("| one after the other | " + " | ".join(f"{100 * serial:.0f} %" for _, _, serial in stages) + " |")
    print("| most that threads can gain (Amdahl) | " + " | ".join(f"{1 / serial:.0f} x" for _, _, serial in stages) + " |")


if __name__ == "__main__":
    main()
