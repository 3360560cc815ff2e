#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames larger than memory: time and memory against the number of atoms, under a limit of the address space; and what
that comes to for more atoms. Two tables in Markdown.

    large_frames.py MDANA [ATOMS ...] [--limit MB] [--memory MB] [--threads N] [--to ATOMS] [--folder DIR]

Writes made-up dumps of three frames of two fcc balls (tests/bench/memory.py), one at a time; 4.2 GB for 2e7 atoms."""

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from memory import write_dump

FRAMES = 3
COMMANDS = {
    "force": [],
    "energy": [],
    "contact-radius": ["--layer", "2"],
    "defects": [],
}


def run(command, limit):
    """Seconds of wall and processor time, and the peak of resident memory [MB]."""
    def limited():
        resource.setrlimit(resource.RLIMIT_AS, (limit << 20, limit << 20))
    start = time.monotonic()
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, preexec_fn=limited) as process:
        error = process.stderr.read()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        sys.exit(f"{' '.join(command)}: exit {process.returncode}: {error.decode()}")
    return time.monotonic() - start, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def measure(args, atoms):
    """Of each command."""
    with tempfile.TemporaryDirectory(prefix="mdana-bench-", dir=args.folder) as folder:
        dump = Path(folder) / "dump.lammpstrj"
        count, radius = write_dump(dump, int(atoms))
        size = dump.stat().st_size
        common = [str(dump), "--memory", f"{args.memory}M", "--threads", str(args.threads)]
        by_command = {}
        for name, extra in COMMANDS.items():
            bodies = ["--radius", f"{radius:.6g}"] if name != "defects" else ["--bodies", "type"]
            by_command[name] = run([args.mdana, name, *common, *bodies, *extra], args.limit)
    return count, size, by_command


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mdana")
    parser.add_argument("atoms", nargs="*", type=float, default=[1e5, 1e6, 5e6, 2e7])
    parser.add_argument("--limit", type=int, default=1000, help="MB of address space (default: %(default)s)")
    parser.add_argument("--memory", type=int, default=256, help="MB as mdana is told (default: %(default)s)")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--to", type=float, default=2e8, help="atoms of the estimate (default: %(default)s)")
    parser.add_argument("--folder", help="where the dumps are written (default: a temporary one)")
    args = parser.parse_args()
    print(f"At most {args.limit} MB of address space, --memory {args.memory}M, --threads {args.threads}: seconds (wall) for {FRAMES} "
          "frames, processor time in µs an atom and frame, peak resident MB; printed by tests/bench/large_frames.py\n")
    print("| atoms | dump, GB | " + " | ".join(COMMANDS) + " |")
    print("|---:" * (2 + len(COMMANDS)) + "|")
    seen = {name: [] for name in COMMANDS}
    for atoms in args.atoms:
        count, size, by_command = measure(args, atoms)
        cells = []
        for name, (wall, cpu, memory) in by_command.items():
            seen[name].append((count, wall / FRAMES, memory))
            cells.append(f"{wall:.1f} s, {1e6 * cpu / count / FRAMES:.2f} µs, {memory:.0f} MB")
        print(f"| {count} | {size / 1e9:.2f} | " + " | ".join(cells) + " |", flush=True)
    if len(args.atoms) < 3:
        return
    print(f"\n| for {args.to:g} atoms, at most | seconds a frame | growth of time so far | MB |\n|---|---:|---:|---:|")
    for name, rows in seen.items():  # time and memory grow on in proportion to the atoms, or as they did if that is faster
        n, wall, memory = np.array(rows[-3:]).T
        power = np.polyfit(np.log(n), np.log(wall), 1)[0]
        slope = max(0.0, (memory[-1] - memory[-2]) / (n[-1] - n[-2]))
        print(f"| {name} | {wall[-1] * (args.to / n[-1])**max(1.0, power):.0f} | atoms^{power:.2f} | {memory[-1] + slope * (args.to - n[-1]):.0f} |")


if __name__ == "__main__":
    main()
