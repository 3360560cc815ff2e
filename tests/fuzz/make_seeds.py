#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small files of every kind for the fuzzers to begin with: made of the first atoms of the dumps in sample-data, written as
the formats' own programs write them. usage: make_seeds.py PATH-OF-MDANA FOLDER; a folder a reader."""

import gzip
import json
import shutil
import struct
import subprocess
import sys
from pathlib import Path

import h5py
import numpy as np
from scipy.io import netcdf_file

ROOT = Path(__file__).resolve().parents[2]
SAMPLE = ROOT / "sample-data"
ATOMS = 6
BOUNDS = ((-40.0, 40.0), (-25.0, 25.0), (-25.0, 25.0))
COLUMNS = "id type x y z vx vy vz".split()


def lines_of(name):
    with gzip.open(SAMPLE / name / "dump.lammpstrj.gz", "rt") as file:
        return [next(file).split() for _ in range(14 + ATOMS)][13:13 + ATOMS]


def text_frame(step, rows, columns=COLUMNS, box="ITEM: BOX BOUNDS ff pp ss\n-40 40\n-25 25\n-25 25\n", head=""):
    return (f"{head}ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(rows)}\n{box}"
            f"ITEM: ATOMS {' '.join(columns)}\n" + "".join(" ".join(row) + "\n" for row in rows))


def texts(rows):
    """Text dumps as LAMMPS writes them with its choices of box and columns."""
    units = "ITEM: UNITS\nlj\nITEM: TIME\n0\n"
    tilted = "ITEM: BOX BOUNDS xy xz yz pp pp pp\n-40 40 1\n-25 25 0.5\n-25 25 -2\n"
    general = "ITEM: BOX BOUNDS abc origin pp pp pp\n80 0 0 -40\n1 50 0 -25\n2 3 50 -25\n"
    images = [row[:5] + ["1", "0", "-2", "Cu"] for row in rows]
    several = "".join(text_frame(100 * k, rows[:2 + k], head=units if k == 0 else "") for k in range(4))
    return {
        "frames": several,
        "tilted": text_frame(0, images, "id type xs ys zs ix iy iz element".split(), tilted),
        "general": text_frame(5, [row[:5] for row in rows], "id type xu yu zu".split(), general, units),
        "comments": "# made\n\n" + text_frame(1, rows).replace("\n", "\r\n"),
        "faulty": several.replace("OF ATOMS\n3", "OF ATOMS\n4").replace("ff pp", "xy xz"),
    }


def yaml_frame(step, rows):
    flow = lambda words: "[ " + "".join(f"{word}, " for word in words) + "]"
    box = "".join(f"  - [ {low}, {high} ]\n" for low, high in BOUNDS)
    data = "".join(f"  - {flow(row)}\n" for row in rows)
    return (f"---\ncreator: LAMMPS\ntimestep: {step}\nunits: lj\ntime: {step}\nnatoms: {len(rows)}\n"
            f"boundary: {flow('ppffss')}\nthermo:\n  - keywords: [ Step, Temp, ]\n  - data: [ {step}, 1.5, ]\n"
            f"box:\n{box}keywords: {flow(COLUMNS)}\ndata:\n{data}...\n")


def binary_frame(order, step, rows, named=True):
    put = lambda kinds, *values: struct.pack(order + kinds, *values)
    numbers = [float(word) for row in rows for word in row]
    width = len(rows[0])
    body = put("qqi", step, len(rows), 0) + put("6i", 1, 1, 0, 0, 2, 3) + put("6d", *sum(BOUNDS, ()))
    columns = " ".join(COLUMNS).encode()
    head, tail = b"", put("i", width)
    if named:
        head = put("q", -10) + b"DUMPCUSTOM" + put("ii", 1, 2)
        tail += put("i", 2) + b"lj" + b"\x01" + put("d", 0.5) + put("i", len(columns)) + columns
    half = len(numbers) // 2 // width * width
    ranks = put("i", 2)
    for part in (numbers[:half], numbers[half:]):
        ranks += put("i", len(part)) + put(f"{len(part)}d", *part)
    return head + body + tail + ranks


def netcdf(path, rows, version, scaled):
    with netcdf_file(path, "w", version=version) as file:
        file.Conventions, file.ConventionVersion, file.program = "AMBER", "1.0", "LAMMPS"
        for name, length in (("frame", None), ("atom", len(rows)), ("spatial", 3), ("cell_spatial", 3), ("cell_angular", 3)):
            file.createDimension(name, length)
        time = file.createVariable("time", "d", ("frame",))
        time.scale_factor = 0.01
        lengths = file.createVariable("cell_lengths", "d", ("frame", "cell_spatial"))
        angles = file.createVariable("cell_angles", "d", ("frame", "cell_angular"))
        angles.units = "degree"
        kind = file.createVariable("type", "i", ("frame", "atom"))
        positions = file.createVariable("scaled_coordinates" if scaled else "coordinates", "f", ("frame", "atom", "spatial"))
        positions.units = "angstrom"
        for k in range(3):
            time[k], lengths[k], angles[k] = k, (80, 50, 50), (90, 80, 90)
            kind[k] = [int(row[1]) for row in rows]
            positions[k] = [[float(word) for word in row[2:5]] for row in rows]


def h5md(path, rows, **layout):
    with h5py.File(path, "w") as file:
        file.create_group("h5md").attrs["version"] = np.array([1, 1])
        box = file.create_group("particles/all/box")
        box.attrs["dimension"] = 3
        box.attrs["boundary"] = np.array([b"periodic", b"none", b"none"])
        box["edges"] = np.array([80.0, 50.0, 50.0])
        for name, first, last, kind in (("position", 2, 5, "f8"), ("velocity", 5, 8, "f4"), ("species", 1, 2, "i4"), ("id", 0, 1, "i8")):
            values = np.array([[float(word) for word in row[first:last]] for row in rows]).astype(kind)
            values = values if last - first == 3 else values[:, 0]
            group = file.create_group(f"particles/all/{name}")
            chunks = (1, *values.shape) if layout else None
            group.create_dataset("value", data=np.stack([values] * 3), chunks=chunks, **layout)
            group["step"] = np.arange(3) * 10 if layout else 10
            group["time"] = np.arange(3) * 0.5 if layout else 0.5


LOG_HEAD = "LAMMPS (29 Sep 2021)\nunits lj\ntimestep 0.01\n"
LOGS = {
    "one": LOG_HEAD + "Per MPI rank memory allocation (min/avg/max) = 3 | 3 | 3 Mbytes\nStep Temp E_pair PotEng\n"
                      "       0 1e-06 -3.5 -3.5\nWARNING: lost\n      10 0.25 -3.25 -3.0e+00\nLoop time of 0.1 on 1 procs\n",
    "multi": LOG_HEAD + "".join(f"------------ Step {10 * k} ----- CPU = 0.0{k} (sec) -------------\n"
                                f"TotEng = -1.{k} KinEng = 0.5 Temp = 1\nPotEng = -2 E_bond = 0 E_angle = 0\n" for k in range(3)) +
             "Loop time of 0.1 on 1 procs\n",
    "yaml": LOG_HEAD + "---\nkeywords: ['Step', 'Temp', 'PotEng', ]\ndata:\n  - [0, 1.5, -3, ]\n  - [10, 1.25, -2.5, ]\n...\n"
                       "Loop time of 0.1 on 1 procs\nERROR: Lost atoms (../thermo.cpp:438)\n",
}
CONTACTS = "".join(f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ENTRIES\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n"
                   "ITEM: ENTRIES index c_ids[1] c_ids[2] c_force\n1 1 2 0.5\n2 3 2 -1e-3\n" for step in (0, 10))
STUDY = """schema = 1
title = "Contact"
[checks]
accuracy = true
[fits]
laws = ["jkr"]
[figures]
kinds = []
[[run]]
name = "a"
scene = "a/scene.toml"
frames = "10:20:2"
log = "a/log.lammps"
[[run]]
name = "b"
group = "g"
scene = "scene.toml"
"""
INDICES = {
    "whole": "hash xxh3:0\nframes 3\n0 0 0 2\n118 11 1 2\n236 22 2 2\n",
    "elsewhere": "hash xxh3:0\nframes 3\n0 0 0 2\n9999999999 11 1 2\n100 22 -2 2\n",
    "many": "hash xxh3:0\nframes 1000000000000000\n0 0 0 2\n",
}
TABLES = {
    "restitution": "# v e\nR,m,v,e,sigma,outcome\n58.9,0.04,0.1,0.5,0.01,bounce\n58.9,1,0.02,,0.01,stick\n",
    "motion": "time,delta,v,F,delta_error\n0,0,1,0,0.1\n1,0.5,0.5,1,0.1\n2,0.25,-0.5,0.5,0.1\n",
    "labels": "name,value\na,1\nb,nan\nc,\n",
}


def main():
    mdana, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    rows = lines_of("hertz-tiny")

    def put(reader, name, data):
        (folder / reader).mkdir(parents=True, exist_ok=True)
        path = folder / reader / name
        path.write_bytes(data.encode() if isinstance(data, str) else data)
        return path

    for name, text in texts(rows).items():
        dump = put("lammps_text", name, text)
        put("gzip", name, gzip.compress(text.encode(), mtime=0))
        packed = folder / "zstd" / f"{name}.dump.zst"
        packed.parent.mkdir(exist_ok=True)
        subprocess.run([mdana, "convert", dump, "-o", packed], check=False, capture_output=True)
    put("gzip", "members", gzip.compress(texts(rows)["frames"][:300].encode(), 1) + gzip.compress(b"", 0) + bytes(7))
    put("lammps_yaml", "frames", "".join(yaml_frame(10 * k, rows[:2 + k]) for k in range(3)))
    for name, order in (("little", "<"), ("big", ">")):
        put("lammps_binary", name, b"".join(binary_frame(order, 10 * k, rows[:2 + k]) for k in range(3)))
    five = [row[:5] for row in rows]
    put("lammps_binary", "nameless", binary_frame("<", 7, five, named=False))
    (folder / "amber_netcdf").mkdir(exist_ok=True)
    netcdf(folder / "amber_netcdf" / "classic", five, 1, scaled=False)
    netcdf(folder / "amber_netcdf" / "offset64", five, 2, scaled=True)
    (folder / "h5md").mkdir(exist_ok=True)
    h5md(folder / "h5md" / "contiguous", rows)
    h5md(folder / "h5md" / "compressed", rows, compression="gzip", shuffle=True)
    for reader, files in (("thermo_log", LOGS), ("frame_index", INDICES), ("table", TABLES),
                          ("local_dump", {"contacts": CONTACTS}), ("study", {"study": STUDY})):
        for name, text in files.items():
            put(reader, name, text)
    for scene in SAMPLE.glob("*/scene.toml"):
        (folder / "scene").mkdir(exist_ok=True)
        shutil.copy(scene, folder / "scene" / scene.parent.name)
    for command in ("collision", "force"):
        document = subprocess.run([mdana, command, SAMPLE / "adhesive-tiny" / "dump.lammpstrj.gz", "--json"], check=True,
                                  capture_output=True).stdout
        put("document", command, json.dumps(json.loads(document)))


if __name__ == "__main__":
    main()
