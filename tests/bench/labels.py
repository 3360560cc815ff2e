#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed of the labels: mdana's kernels against LAMMPS' compute cna/atom on one frame of a fcc ball, one thread.

    tests/bench/labels.py build-bench [--radius 29.2] [--noise 0.02]

build-bench is a build with -DMDANA_BENCHMARKS=ON. CPU seconds an atom, the best of three; compare ratios, since
machines differ.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy

EDGE = 1.5429  # of the cube of Lennard-Jones fcc [sigma]
REPEATS = 10

INPUT = """units lj
boundary s s s
read_data {data}
pair_style zero 2.5 nocoeff
pair_coeff * *
mass * 1
neighbor 0.3 bin
compute cna all cna/atom 1.317
compute sum all reduce sum c_cna
thermo_style custom step {column}
thermo 1
run {repeats}
"""


def ball(radius, noise):
    n = int(radius / EDGE) + 2
    grid = numpy.arange(-n, n)
    cells = numpy.stack(numpy.meshgrid(grid, grid, grid, indexing="ij"), -1).reshape(-1, 3)
    places = numpy.concatenate([EDGE * (cells + b) for b in ([0, 0, 0], [.5, .5, 0], [.5, 0, .5], [0, .5, .5])])
    places = places[(places**2).sum(1) < radius**2]
    return places + numpy.random.default_rng(1).normal(0, noise, places.shape)


def lammps(places, folder, column):
    """CPU seconds of a step."""
    low, high = places.min(0) - 1, places.max(0) + 1
    lines = ["atoms", "", f"{len(places)} atoms", "1 atom types", ""]
    lines += [f"{a} {b} {n}lo {n}hi" for a, b, n in zip(low, high, "xyz")] + ["", "Atoms", ""]
    lines += [f"{k + 1} 1 {x:.9g} {y:.9g} {z:.9g}" for k, (x, y, z) in enumerate(places)]
    (folder / "atoms.data").write_text("\n".join(lines) + "\n")
    (folder / "in.lmp").write_text(INPUT.format(data=folder / "atoms.data", column=column, repeats=REPEATS))
    done = subprocess.run(["lmp", "-in", folder / "in.lmp", "-log", "none"], capture_output=True, text=True, check=True)
    share = float(re.search(r"([\d.]+)% CPU use", done.stdout)[1]) / 100
    return float(re.search(r"Loop time of ([\d.e+-]+)", done.stdout)[1]) * share / REPEATS


def kernels(build, noise):
    done = subprocess.run([build / "tests/bench/bench_labels", "--benchmark_format=json", "--benchmark_repetitions=3",
                           f"--benchmark_filter=/{0 if noise < 0.025 else 5}$"], capture_output=True, text=True, check=True)
    times = {}
    for entry in json.loads(done.stdout)["benchmarks"]:
        if entry.get("run_type") == "iteration":
            name = entry["name"].split("/")[0]
            times[name] = min(times.get(name, 9), entry["atom"])
    return times


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--radius", type=float, default=29.2)
    parser.add_argument("--noise", type=float, default=0.02)
    args = parser.parse_args()
    places = ball(args.radius, args.noise)
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        bare, labelled = (min(lammps(places, folder, column) for _ in range(3)) for column in ("pe", "c_sum"))
    cna = (labelled - bare) / len(places)
    print(f"{len(places)} atoms, noise {args.noise}")
    print(f"LAMMPS cna/atom: {1e9 * cna:.0f} ns an atom, its neighbour list included")
    times = kernels(args.build, args.noise)
    cells = times["spacing and cells"]
    print(f"spacing and cells: {1e9 * cells:.0f} ns an atom")
    for name, seconds in times.items():
        if name == "spacing and cells":
            continue
        whole = seconds + cells if name.startswith("kernel") else seconds
        print(f"{name}{' with cells' if name.startswith('kernel') else ''}: {1e9 * whole:.0f} ns an atom, "
              f"{cna / whole:.1f} times as fast")


if __name__ == "__main__":
    sys.exit(main())
