# SPDX-License-Identifier: GPL-3.0-or-later
"""Proof of what a case claims, from LAMMPS' labels and Burgers circuits; nothing of mdana is used."""

import numpy as np

from circuits import FCC, HCP, OTHER, NoCircuit, burgers
from crystal import unit

SURFACE = 12  # neighbours that an atom inside has


def read(file):
    with open(file) as lines:
        for line in lines:
            if line.startswith("ITEM: ATOMS"):
                break
        return np.loadtxt(lines)


def of(case, folder):
    """What circuits about each line give, at three places; the circuits follow the cores to where they are found."""
    places, labels = read(folder / "dump.lammpstrj")[:, 2:5], read(folder / "labels.dump")[:, 1].astype(int)
    counts = {name: int((labels == label).sum()) for name, label in (("fcc", FCC), ("hcp", HCP), ("other", OTHER))}
    results = [counts]
    for line in case.lines:
        axes = case.axes if line.axes is None else line.axes
        segments = line.segments()
        for fraction in (0.25, 0.5, 0.75):
            number = int(fraction * len(segments))
            direction = unit(segments[number])
            planned = line.corners[number] + (fraction if len(segments) < 3 else 0.5) * segments[number]
            centre = core(places, labels, planned, direction)
            try:
                found = [int(part) for part in burgers(places, labels, axes, centre, direction, line.circuit)]
            except NoCircuit as reason:
                found = str(reason)
            results.append({"planned": planned.round(2).tolist(), "at": centre.round(2).tolist(), "claimed": line.burgers,
                            "found": found})
    return results


def core(places, labels, near, direction):
    """Middle of the atoms without structure about a place, across the line."""
    centre = np.array(near, float)
    for _ in range(3):
        away = places - centre
        along = away @ direction
        across = np.linalg.norm(away - np.outer(along, direction), axis=1)
        chosen = (labels == OTHER) & (np.abs(along) < 2) & (across < 3)
        if not chosen.any():
            break
        shift = away[chosen].mean(0)
        centre = centre + shift - (shift @ direction) * direction
    return centre
