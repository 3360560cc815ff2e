#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Crystals with known dislocations, built by numpy and relaxed by LAMMPS, one folder each.

    tests/dislocations/make_cases.py OUT            all cases
    tests/dislocations/make_cases.py OUT edge sft   these only

Each folder gets dump.lammpstrj, scene.toml and truth.json, see README.md, and labels.dump with LAMMPS' labels
(1 fcc, 2 hcp, 5 neither). Ends with 1 if Burgers circuits do not prove what truth.json says.
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
    truth = {"family": family(line.burgers), "burgers": line.burgers,
             "burgers_lab": to_lab(axes, line.burgers).tolist(), "length": line.length(),
             "closed": line.closed, "corners": line.corners.round(4).tolist()}
    truth |= {"role": line.role} if line.role else {}
    return truth | ({"orientation": line.axes.tolist()} if line.axes is not None else {})


def families(lines):
    found = {}
    for line in lines:
        entry = found.setdefault(family(line.burgers), {"lines": 0, "length": 0})
        entry["lines"] += 1
        entry["length"] += line.length()
    return found


def truth_of(name, case):
    truth = {"case": name, "about": case.about, "edge": EDGE, "orientation": case.axes.tolist()}
    truth |= {"found": case.found} if case.found else {}
    if not case.net:
        truth |= {"families": families(case.lines), "tolerance": case.tolerance,
                  "lines": [written(line, case) for line in case.lines]}
    return truth


def make(name, folder):
    began = time.perf_counter()
    folder.mkdir(parents=True, exist_ok=True)
    case = CASES[name]()
    relax(case, folder)
    places, labels = proof.labelled(folder / "labels.dump")
    if case.measure:
        case.measure(case, places, labels)
    truth = truth_of(name, case) | proof.of(case, places, labels)
    truth["atoms"] = int((~case.dropped).sum())
    truth["seconds"] = round(time.perf_counter() - began, 1)
    (folder / "scene.toml").write_text(SCENE.format(name=name, atoms=truth["atoms"]))
    (folder / "truth.json").write_text(json.dumps(truth, indent=1) + "\n")
    return truth


def tell(name, truth):
    print(f"{name}: {truth['atoms']} atoms, {truth['seconds']} s, {'proved' if truth['proved'] else 'NOT PROVED'}")
    for kind, entry in truth.get("families", {}).items():
        print(f"  {entry['lines']} {kind}, {entry['length']:.1f}")
    for disc in truth["discs"]:
        if disc["burgers"] != disc["claimed"]:
            print(f"  at {disc['centre']}: {disc['claimed']} claimed, found: {disc['burgers']}")
    sys.stdout.flush()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("names", nargs="*", help=", ".join(CASES))
    args = parser.parse_args()
    if unknown := [name for name in args.names if name not in CASES]:
        parser.error(f"no case {unknown[0]} (there are {', '.join(CASES)})")
    proved = True
    for name in args.names or CASES:
        truth = make(name, args.out / name)
        tell(name, truth)
        proved = proved and truth["proved"]
    return 0 if proved else 1


if __name__ == "__main__":
    sys.exit(main())
