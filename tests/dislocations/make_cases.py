#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Crystals with known dislocations, built by numpy and relaxed by LAMMPS, one folder each.

    tests/dislocations/make_cases.py OUT            all cases
    tests/dislocations/make_cases.py OUT edge sft   these only

Each folder gets dump.lammpstrj, scene.toml and truth.json; labels.dump has LAMMPS' labels (1 fcc, 2 hcp), for the proof
of the truth by Burgers circuits, whose results are in truth.json under "proof".
"""

import argparse
import json
import pathlib
import subprocess
import sys
import time

import numpy as np

import proof
from crystal import EDGE, family, to_lab
from lines import LINES
from loops import LOOPS

CASES = LINES | LOOPS
SCENE = """# A crystal with known dislocations, see truth.json. Written by tests/dislocations/make_cases.py.
schema = 1
name = "{name}"
dump = "dump.lammpstrj"
units = "lj"
sigma = 1.0
cutoff = 2.5
shift = true
bodies = "type"

[masses]
1 = 1.0

[[body]]
name = "1"
type = 1
atoms = {atoms}
"""


def write_data(case, file):
    """Atoms that stay where they are come last; type 2 is left out in the end."""
    order = np.argsort(case.held, kind="stable")
    low, high = case.places.min(0) - 3, case.places.max(0) + 3
    lines = ["crystal", "", f"{len(order)} atoms", "2 atom types", ""]
    lines += [f"{a:.6f} {b:.6f} {n}lo {n}hi" for a, b, n in zip(low, high, "xyz")] + ["", "Atoms", ""]
    lines += [f"{k} {1 + case.dropped[i]} {x:.12g} {y:.12g} {z:.12g}"
              for k, (i, (x, y, z)) in enumerate(zip(order, case.places[order]), 1)]
    file.write_text("\n".join(lines) + "\n")


def relax(case, folder):
    write_data(case, folder / "atoms.data")
    here = pathlib.Path(__file__).resolve().parent
    done = subprocess.run(["nice", "lmp", "-in", here / "relax.lmp", "-log", "relax.log", "-var", "free",
                           str((~case.held).sum()), "-var", "steps", str(case.steps)],
                          cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"make_cases: LAMMPS failed in {folder}: {done.stdout[-800:]}")
    (folder / "atoms.data").unlink()


def written(line, case):
    axes = case.axes if line.axes is None else line.axes
    truth = {"family": family(line.burgers), "burgers": line.burgers, "burgers_lab": to_lab(axes, line.burgers).tolist(),
             "length": line.length, "closed": line.closed, "corners": line.corners.tolist()}
    truth |= {"role": line.role} if line.role else {}
    return truth | ({"orientation": line.axes.tolist()} if line.axes is not None else {})


def truth_of(name, case):
    families = {}
    for line in case.lines:
        entry = families.setdefault(family(line.burgers), {"lines": 0, "length": 0})
        entry["lines"] += 1
        entry["length"] += line.length
    return {"case": name, "about": case.about, "found": case.found, "edge": EDGE, "orientation": case.axes.tolist(),
            "families": families, "tolerance": case.tolerance, "lines": [written(line, case) for line in case.lines]}


def make(name, folder):
    began = time.perf_counter()
    folder.mkdir(parents=True, exist_ok=True)
    case = CASES[name]()
    relax(case, folder)
    truth = truth_of(name, case) | {"proof": proof.of(case, folder)}
    truth["atoms"] = int((~case.dropped).sum())
    truth["seconds"] = round(time.perf_counter() - began, 1)
    (folder / "scene.toml").write_text(SCENE.format(name=name, atoms=truth["atoms"]))
    (folder / "truth.json").write_text(json.dumps(truth, indent=1) + "\n")
    return truth


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("names", nargs="*", help=", ".join(CASES))
    args = parser.parse_args()
    if unknown := [name for name in args.names if name not in CASES]:
        parser.error(f"no case {unknown[0]} (there are {', '.join(CASES)})")
    for name in args.names or CASES:
        truth = make(name, args.out / name)
        print(f"{name}: {truth['atoms']} atoms, {truth['seconds']} s", flush=True)
        for family_name, entry in truth["families"].items():
            print(f"  {entry['lines']} {family_name}, {entry['length']:.1f}")
        for line in truth["proof"]:
            print("   ", line)


if __name__ == "__main__":
    sys.exit(main())
