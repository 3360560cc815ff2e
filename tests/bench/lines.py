#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Dislocation lines: seconds and memory of mdana defects on a million atoms, cold and warm, and of a collision.

    tests/bench/lines.py build/mdana [COLLISION_DUMP ATOMS FRAMES]

CPU time an atom of labels (with --no-lines), and of labels with lines, less what mdana check takes to read the dump;
two threads against one, with lines. Memory of an atom of the zone, by making all atoms zone.
"""
import concurrent.futures
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np

MDANA = pathlib.Path(sys.argv[1]).resolve()


def ball_with_partial(path, noise, radius=60):
    edge = 1.55
    n = int(radius / edge) + 2
    cells = np.array(np.meshgrid(*[np.arange(-n, n + 1)] * 3, indexing="ij")).reshape(3, -1).T
    atoms = edge * np.concatenate([cells + b for b in ([0, 0, 0], [.5, .5, 0], [.5, 0, .5], [0, .5, .5])])
    atoms = atoms[np.einsum("ij,ij->i", atoms, atoms) < radius**2]
    slip = 0.5 + np.arctan(atoms @ np.array([1, 1, -2]) / 6**.5) / np.pi
    side = np.where(atoms @ np.ones(3) / 3**.5 > edge / 12**.5, .5, -.5)
    atoms += np.outer(side * slip, edge / 6 * np.array([1, 1, -2])) + np.random.default_rng(1).normal(0, noise, atoms.shape)
    with open(path, "w") as file:
        file.write(f"ITEM: UNITS\nlj\nITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{len(atoms)}\nITEM: BOX BOUNDS ff ff ff\n" + "-70 70\n" * 3)
        file.write("ITEM: ATOMS id type x y z\n")
        np.savetxt(file, np.column_stack([np.arange(1, len(atoms) + 1), np.ones(len(atoms)), atoms]), fmt="%d %d %.9g %.9g %.9g")
    return len(atoms)


def run(*arguments):
    """CPU seconds, wall seconds and megabytes: the least of three."""
    best = None
    for _ in range(3):
        start, begin = time.perf_counter(), resource.getrusage(resource.RUSAGE_CHILDREN)
        with subprocess.Popen([MDANA, *arguments], stdout=subprocess.DEVNULL) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = status
        assert status == 0, arguments
        found = (usage.ru_utime + usage.ru_stime, time.perf_counter() - start, usage.ru_maxrss / 1024)
        best = found if best is None else tuple(map(min, best, found))
    return best


def compare(name, dump, atoms, frames=1):
    read = run("check", dump, "--threads", "1")[0]
    defects = ["defects", dump, "--no-surface", *([] if frames > 1 else ["--bodies", "type"]), "--threads"]
    labels, lines, two = run(*defects, "1", "--no-lines"), run(*defects, "1"), run(*defects, "2")
    each = 1e6 / atoms / frames
    print(f"| {name} | {atoms} | {(labels[0] - read) * each:.2f} | {(lines[0] - read) * each:.2f} | {lines[1] / two[1]:.2f} | "
          f"{labels[2]:.0f} | {lines[2]:.0f} |")


def memory_of_zone(dump, atoms):
    defects = ["defects", dump, "--no-surface", "--bodies", "type", "--threads", "1"]
    more = run(*defects, "--lines-everywhere")[2] - run(*defects, "--no-lines")[2]
    print(f"\n{more * 1024 / atoms:.2f} kB an atom of the zone ({atoms} atoms, all of them zone)")


def made(*arguments):
    """A ball, made in another process: what this one holds would count as memory of those that it starts."""
    with concurrent.futures.ProcessPoolExecutor(1) as pool:
        return pool.submit(ball_with_partial, *arguments).result()


print("| case | atoms | labels, us/atom | with lines | two threads | MB, labels | MB, lines |\n|---|---|---|---|---|---|---|")
with tempfile.TemporaryDirectory() as directory:
    for name, noise in (("one partial, cold", 0), ("one partial, noise 0.05 sigma", 0.05)):
        dump = pathlib.Path(directory) / "ball.dump"
        compare(name, dump, made(dump, noise))
    if len(sys.argv) > 2:
        compare("collision", sys.argv[2], int(sys.argv[3]), int(sys.argv[4]))
    memory_of_zone(dump, made(dump, 0, 30))
