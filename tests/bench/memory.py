#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Peak memory of force, energy, contact-radius and collision against the number of atoms: a table in Markdown.

    memory.py MDANA [ATOMS ...] [--folder DIR] [--memory MB]

Writes made-up dumps of three frames (approach, contact, separation; 70 bytes an atom and frame), one at a time."""

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

HALF_CELL = 0.771  # of a fcc lattice, neighbours 1.09 apart
COLUMNS = "id type x y z vx vy vz fx fy fz c_pe"
COMMANDS = {
    "force": [],
    "energy": [],
    "contact-radius": ["--layer", "2"],
    "collision": ["--layer", "2"],
}
CHUNK = 1_000_000  # atoms written at a time


def radius_of(atoms):
    return (2 * atoms * 3 / (4 * np.pi))**(1 / 3) * HALF_CELL


def ball(atoms):
    """Sites of a fcc lattice nearest to the origin, about so many, plane by plane along x."""
    radius = radius_of(atoms)
    half = int(radius / HALF_CELL) + 1
    side = np.arange(-half, half + 1)
    j, k = (grid.ravel() for grid in np.meshgrid(side, side, indexing="ij"))
    for i in side:
        inside = ((i + j + k) % 2 == 0) & ((i * i + j * j + k * k) * HALF_CELL**2 <= radius * radius)
        yield HALF_CELL * np.column_stack([np.full(inside.sum(), i), j[inside], k[inside]])


def digits(values, width):
    """Whole numbers as rows of bytes, with a sign, zeros and three decimals: -0012.500."""
    rest = np.abs(values)
    text = np.empty((len(values), width), dtype=np.uint8)
    text[:, 0] = np.where(values < 0, ord("-"), ord("0"))
    for k in range(width - 1, 0, -1):
        if k == width - 4:
            text[:, k] = ord(".")
            continue
        text[:, k] = ord("0") + rest % 10
        rest //= 10
    return text


def numbers(values, width):
    text = np.empty((len(values), width), dtype=np.uint8)
    for k in range(width - 1, -1, -1):
        text[:, k] = ord("0") + values % 10
        values = values // 10
    return text


def constant(text, rows):
    return np.tile(np.frombuffer(text.encode(), dtype=np.uint8), (rows, 1))


def write_body(file, sites, body, first_id, shift, velocity, force):
    tail = f" {velocity:.6g} 0 0 {force:.6g} 0 0 -5.5\n"
    for plane in sites:
        for start in range(0, len(plane), CHUNK):
            part = plane[start:start + CHUNK]
            rows = len(part)
            columns = [numbers(np.arange(first_id, first_id + rows), 9), constant(f" {body} ", rows)]
            for axis in range(3):
                moved = part[:, axis] + (shift if axis == 0 else 0)
                columns += [digits(np.rint(1000 * moved).astype(np.int64), 9), constant(" ", rows)]
            file.write(np.hstack([*columns[:-1], constant(tail, rows)]).tobytes())
            first_id += rows
    return first_id


def write_dump(path, atoms):
    """A bounce with e = 1/2 of two balls. Returns the atoms and the radius."""
    half = atoms // 2
    count = sum(len(plane) for plane in ball(half))
    radius = radius_of(half)
    with open(path, "wb") as file:
        for step, (gap, speed, force) in enumerate([(2.0, 0.1, 0.0), (-0.8, 0.0, 1e-3), (2.0, -0.05, 0.0)]):
            file.write(f"ITEM: UNITS\nlj\nITEM: TIME\n{50.0 * step}\nITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n"
                       f"{2 * count}\nITEM: BOX BOUNDS ff ff ff\n-1000 1000\n-1000 1000\n-1000 1000\n"
                       f"ITEM: ATOMS {COLUMNS}\n".encode())
            next_id = write_body(file, ball(half), 1, 1, -radius - gap / 2, speed / 2, -force)
            write_body(file, ball(half), 2, next_id, radius + gap / 2, -speed / 2, force)
    return 2 * count, radius


def peak(command):
    """Greatest resident memory of the command in MB."""
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
        error = process.stderr.read()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        sys.exit(f"{' '.join(command)}: exit {process.returncode}: {error.decode()}")
    return used.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mdana")
    parser.add_argument("atoms", nargs="*", type=float, default=[1e5, 1e6, 1e7])
    parser.add_argument("--folder", help="where the dumps are written (default: a temporary one)")
    parser.add_argument("--memory", default="16", help="MB for atoms that are looked at twice (default: %(default)s)")
    parser.add_argument("--threads", default="2")
    args = parser.parse_args()
    print(f"Peak resident memory in MB, --memory {args.memory}, --threads {args.threads}; printed by tests/bench/memory.py\n")
    print("| atoms | dump, GB | " + " | ".join(COMMANDS) + " |")
    print("|---:" * (2 + len(COMMANDS)) + "|")
    for atoms in args.atoms:
        with tempfile.TemporaryDirectory(prefix="mdana-bench-", dir=args.folder) as folder:
            dump = Path(folder) / "dump.lammpstrj"
            count, radius = write_dump(dump, int(atoms))
            size = dump.stat().st_size / 1e9
            common = [str(dump), "--radius", f"{radius:.6g}", "--memory", args.memory, "--threads", args.threads]
            cells = [f"{peak([args.mdana, name, *common, *extra]):.0f}" for name, extra in COMMANDS.items()]
        print(f"| {count} | {size:.2f} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
