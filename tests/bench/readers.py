#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed of reading: one run in several encodings, by mdana and by other programs, in MB of text a second.

    tests/bench/readers.py build-bench [--atoms 227295] [--frames 10] [--markdown]

build-bench is a build with -DMDANA_BENCHMARKS=ON. Made-up numbers as of a cold sphere, printed by %.10g. Every
way is run several times and the best counts; compare ratios, since machines differ. Other programs are
used if they are installed (Debian: python3-mdanalysis, python3-ase, lammps).
"""
import argparse
import gzip
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import time

import numpy

COLUMNS = "id type x y z vx vy vz c_pe"


def frames(atoms, count):
    random = numpy.random.default_rng(1)
    for _ in range(count):
        yield numpy.column_stack([
            numpy.arange(1, atoms + 1), 1 + numpy.arange(atoms) % 2, random.uniform(-30, 30, (atoms, 3)),
            random.normal(0, 1e-3, (atoms, 3)), random.uniform(-9, -4, atoms)])


def write_text(path, atoms, count):
    line = "%d %d" + " %.10g" * 7 + " \n"
    with open(path, "w") as file:
        for step, table in enumerate(frames(atoms, count)):
            file.write(f"ITEM: TIMESTEP\n{100 * step}\nITEM: NUMBER OF ATOMS\n{atoms}\n"
                       "ITEM: BOX BOUNDS ff ff ff\n-31 31\n-31 31\n-31 31\n"
                       f"ITEM: ATOMS {COLUMNS}\n")
            file.writelines(line % tuple(row) for row in table.tolist())


def write_binary(path, atoms, count):
    with open(path, "wb") as file:
        for step, table in enumerate(frames(atoms, count)):
            file.write(struct.pack("<q", -10) + b"DUMPCUSTOM" + struct.pack("<iiqq", 1, 2, 100 * step, atoms))
            file.write(struct.pack("<i6i6d", 0, *[1] * 6, *[-31, 31] * 3))
            file.write(struct.pack("<ii", 9, 0) + b"\0" + struct.pack("<i", len(COLUMNS)) + COLUMNS.encode())
            file.write(struct.pack("<ii", 1, 9 * atoms))
            file.write(numpy.ascontiguousarray(table).tobytes())


def make(folder, program, atoms, count):
    text, binary = folder / "text.lammpstrj", folder / "binary.bin"
    write_text(text, atoms, count)
    write_binary(binary, atoms, count)
    with open(text, "rb") as plain, gzip.open(folder / "text.lammpstrj.gz", "wb", 6) as packed:
        shutil.copyfileobj(plain, packed)
    files = [text, folder / "text.lammpstrj.gz", binary]
    for name in ("text.lammpstrj.zst", "h5md.h5"):
        if subprocess.run([program, "convert", text, "-o", folder / name], capture_output=True).returncode == 0:
            files.append(folder / name)
    return files


MDANALYSIS = """
import sys, time, warnings
warnings.simplefilter("ignore")
import MDAnalysis
from MDAnalysis.coordinates.LAMMPS import DumpReader
start = time.perf_counter()
for frame in DumpReader(sys.argv[1], n_atoms=int(sys.argv[2])): frame.positions
print(time.perf_counter() - start)
"""
ASE = """
import sys, time
import ase.io
start = time.perf_counter()
for frame in ase.io.read(sys.argv[1], index=":", format="lammps-dump-text"): frame.positions
print(time.perf_counter() - start)
"""
LAMMPS = """units lj
boundary f f f
region all block -31 31 -31 31 -31 31
create_box 2 all
mass * 1
read_dump {path} 0 x y z vx vy vz box no add yes
{more}
"""


def by_python(script, text, atoms):
    done = subprocess.run(["/usr/bin/python3", "-c", script, text, str(atoms)], capture_output=True, text=True)
    return float(done.stdout) if done.returncode == 0 else None


def by_lammps(text, count, folder):
    """Time of read_dump of all frames but the first, which makes the atoms."""
    if not shutil.which("lmp"):
        return None
    commands = "".join(f"read_dump {text} {100 * k} x y z vx vy vz box no replace yes\n"
                       for k in range(1, count))
    seconds = []
    for more in ("", commands):
        (folder / "in.read").write_text(LAMMPS.format(path=text, more=more))
        start = time.perf_counter()
        done = subprocess.run(["lmp", "-in", "in.read", "-log", "none", "-screen", "none"], cwd=folder)
        seconds.append(time.perf_counter() - start)
        if done.returncode:
            return None
    return (seconds[1] - seconds[0]) * count / (count - 1)


def measure(build, atoms, count, folder):
    files = make(folder, build / "mdana", atoms, count)
    size = files[0].stat().st_size / 1e6
    done = subprocess.run([build / "tests/bench/bench_readers", *files], capture_output=True, text=True, check=True)
    rows = []
    for line in done.stdout.splitlines():
        row = json.loads(line)
        rows.append((pathlib.Path(row["file"]).name, row["way"], size / row["seconds"]))
    few = max(2, count // 5)
    short = folder / "short.lammpstrj"
    write_text(short, atoms, few)
    part = short.stat().st_size / 1e6
    for name, seconds in (("LAMMPS read_dump", by_lammps(short, few, folder)),
                          ("MDAnalysis", by_python(MDANALYSIS, short, atoms)),
                          ("ASE", by_python(ASE, short, atoms))):
        if seconds:
            rows.append(("text.lammpstrj", name, part / seconds))
    return size, rows


def show(size, rows, markdown):
    base = {way.split(",")[0]: speed for _, way, speed in rows if way.endswith("from_chars")}
    base.setdefault("9 columns", None)
    if markdown:
        print(f"{size:.0f} MB of text; MB of text a second, and times the speed of std::from_chars\n")
        print("| file | read | MB/s | ratio |\n|---|---|---|---|")
    for file, way, speed in rows:
        ratio = speed / base[way.split(",")[0] if way.split(",")[0] in base else "9 columns"]
        print(f"| {file} | {way} | {speed:.0f} | {ratio:.2g} |" if markdown
              else f"{file:22} {way:24} {speed:8.0f} MB/s  {ratio:6.2g} x")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--atoms", type=int, default=227295)
    parser.add_argument("--frames", type=int, default=10)
    parser.add_argument("--markdown", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        show(*measure(options.build.resolve(), options.atoms, options.frames, pathlib.Path(folder)), options.markdown)


if __name__ == "__main__":
    sys.exit(main())
