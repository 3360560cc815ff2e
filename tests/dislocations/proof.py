# SPDX-License-Identifier: GPL-3.0-or-later
"""Proof of what a case claims, from LAMMPS' labels and Burgers circuits; nothing of mdana is used."""

import numpy as np
from scipy.spatial import cKDTree

from circuits import FCC, HCP, OTHER, NoCircuit, burgers
from crystal import unit


def labelled(file):
    """Places and labels of LAMMPS' compute cna/atom."""
    with open(file) as lines:
        while not next(lines).startswith("ITEM: ATOMS"):
            pass
        table = np.loadtxt(lines)
    return table[:, 1:4], table[:, 4].astype(int)


def of(case, places, labels):
    """Burgers circuits about each line at three places, and far from all: the sum over the lines through these discs."""
    counts = {name: int((labels == label).sum()) for name, label in (("fcc", FCC), ("hcp", HCP), ("other", OTHER))}
    discs = [disc(case, line, fraction, places, labels) for line in case.lines for fraction in (0.25, 0.5, 0.75)]
    discs.append(far_disc(case, places, labels))
    return {"labels": counts, "proved": all(d["burgers"] == d["claimed"] for d in discs), "discs": discs}


def disc(case, line, fraction, places, labels):
    segments = line.segments()
    exact = fraction * len(segments)
    number = int(exact)
    centre = line.corners[number] + (exact - number) * segments[number]
    claimed = list(line.parted.get(fraction, line.burgers))
    return proved(case, line, (centre, unit(segments[number]), line.circuit), claimed, places, labels)


def far_disc(case, places, labels):
    """As far from all lines as there is room for: no line goes through it."""
    grid = np.arange(-10, 11, 2.0)
    spots = np.stack(np.meshgrid(grid, grid, grid, indexing="ij"), -1).reshape(-1, 3)
    spots = spots[np.linalg.norm(spots, axis=1) < 12]
    on_lines = np.concatenate([line.corners[:len(line.segments()), None] + line.segments()[:, None] * part
                               for line in case.lines for part in np.linspace(0, 1, 20)[:, None]]).reshape(-1, 3)
    centre = spots[cKDTree(on_lines).query(spots)[0].argmax()]
    line = case.lines[0]
    return proved(case, line, (centre, unit(line.segments()[0]), 3.0), [0, 0, 0], places, labels)


def proved(case, line, where, claimed, places, labels):
    try:
        found = burgers(places, labels, case, line.axes, *where)
    except NoCircuit as reason:
        found = str(reason)
    centre, normal, radius = where
    return {"centre": centre.round(3).tolist(), "normal": normal.round(6).tolist(), "radius": radius,
            "claimed": claimed, "burgers": found}
