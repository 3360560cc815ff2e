#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What leaving out saves: commands as the scene calls for them, against every column and every analysis of the build
(tests/bench/everything.cpp), and a lean build against the whole one. Tables in Markdown.

    left_out.py BUILD [--lean BUILD] [--run NAME=DUMP:COMMAND ...]

BUILD is a build directory with MDANA_BENCHMARKS=ON; DUMP stands beside its scene.toml."""

import argparse
import gzip
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "cli"))

import dumps
from measuring import measured

SAMPLE = ROOT / "sample-data"
REPETITIONS = 3


def least(command):
    """What the command prints, the least seconds of processors of some runs, and the least peak memory in MB."""
    runs = [measured(command, codes=(0, 4)) for _ in range(REPETITIONS)]
    return json.loads(runs[0][0]), min(run[2] for run in runs), min(run[3] for run in runs) / 1e6


def scenes(folder):
    """Name, dump, scene, and the command that is asked for."""
    sample = {name: SAMPLE / f"{name}-tiny" / "dump.lammpstrj.gz" for name in ("hertz", "adhesive", "aggregate")}
    positions = dumps.write(folder / "positions.lammpstrj.gz",
                            [frame.without("vx", "vy", "vz") for frame in dumps.read(sample["adhesive"])])
    scene = {name: dump.parent / "scene.toml" for name, dump in sample.items()}
    yield "Hertz, E\\* and R", sample["hertz"], scene["hertz"], "fit-hertz"
    yield "Hertz, all of the collision", sample["hertz"], scene["hertz"], "collision"
    yield "adhesive, sticks", sample["adhesive"], scene["adhesive"], "collision"
    yield "adhesive, contact radius alone", sample["adhesive"], scene["adhesive"], "contact-radius"
    yield "adhesive, dump without velocities", positions, scene["adhesive"], "force"
    yield "aggregates", sample["aggregate"], scene["aggregate"], "compress"


def millions(number):
    return f"{number / 1e6:.3g}"


def text_bytes(dump):
    data = dump.read_bytes() if dump.stat().st_size < 4e8 else b""
    return len(gzip.decompress(data)) if data[:2] == b"\x1f\x8b" else dump.stat().st_size


def row(build, name, dump, scene, command):
    told, seconds, memory = least([build / "mdana", command, dump, "--scene", scene, "--json"])
    everything, all_seconds, all_memory = least([build / "tests" / "bench" / "everything", dump, scene])
    info, _, _ = least([build / "mdana", "info", dump, "--scene", scene, "--json"])
    atoms = told["frames"] * info["atoms"][1]
    read = len(told["columns_read"])
    return [name, f"`{command}`", f"{text_bytes(dump) / 1e6:.3g}",
            f"{millions(atoms * read)} of {millions(atoms * everything['columns'])}",
            f"{seconds:.3f} of {all_seconds:.3f} ({all_seconds / seconds:.1f} x)", f"{memory:.0f} of {all_memory:.0f}",
            f"{len(told['left_out'])}"]


def libraries(program):
    lines = subprocess.run(["ldd", program], text=True, capture_output=True, check=True).stdout.splitlines()
    return {line.split()[0]: line.split("=> ")[-1].split()[0] for line in lines}


def sizes(build, lean):
    """Program, its bytes without symbols, how many libraries are loaded, their bytes, and those that only one has."""
    print("\n| build | program, MB | libraries loaded | their size, MB | which the lean one has not |\n|---|---:|---:|---:|---|")
    for name, place in (("whole", build), ("lean", lean)):
        linked = libraries(place / "mdana")
        total = sum(os.stat(os.path.realpath(path)).st_size for path in linked.values() if path.startswith("/"))
        only = sorted(set(linked) - set(libraries(lean / "mdana"))) if name == "whole" else []
        short = ", ".join(entry.split(".so")[0].removeprefix("lib") for entry in only) or "none"
        print(f"| {name} | {(place / 'mdana').stat().st_size / 1e6:.1f} | {len(linked)} | {total / 1e6:.0f} | {short} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=lambda path: Path(path).resolve())
    parser.add_argument("--lean", type=lambda path: Path(path).resolve(), help="build directory of the preset lean")
    parser.add_argument("--run", action="append", default=[], metavar="NAME=DUMP:COMMAND", help="another scene")
    args = parser.parse_args()
    print("| scene | command | text, MB | numbers converted, millions | CPU seconds | peak memory, MB | left out |")
    print("|---|---|---:|---:|---:|---:|---:|")
    with tempfile.TemporaryDirectory(prefix="mdana-bench-") as folder:
        more = []
        for text in args.run:
            name, rest = text.rsplit("=", 1)
            dump, command = rest.rsplit(":", 1)
            more.append((name, Path(dump), Path(dump).parent / "scene.toml", command))
        for scene in [*scenes(Path(folder)), *more]:
            print("| " + " | ".join(row(args.build, *scene)) + " |", flush=True)
    if args.lean:
        sizes(args.build, args.lean)


if __name__ == "__main__":
    main()
