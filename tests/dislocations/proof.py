# SPDX-License-Identifier: GPL-3.0-or-later
"""Proof of what a case claims, from LAMMPS' labels and Burgers circuits; nothing of mdana is used."""

import numpy as np

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
    """Burgers circuits about each line at three places: the sum over all lines through each of these discs."""
    counts = {name: int((labels == label).sum()) for name, label in (("fcc", FCC), ("hcp", HCP), ("other", OTHER))}
    discs = [disc(case, line, fraction, places, labels) for line in case.lines for fraction in (0.25, 0.5, 0.75)]
    return {"labels": counts, "proved": all(d["burgers"] == d["claimed"] for d in discs), "discs": discs}


def disc(case, line, fraction, places, labels):
    segments = line.segments()
    exact = fraction * len(segments)
    number = int(exact)
    centre = line.corners[number] + (exact - number) * segments[number]
    direction = unit(segments[number])
    try:
        found = burgers(places, labels, case, line.axes, centre, direction, line.circuit)
    except NoCircuit as reason:
        found = str(reason)
    return {"centre": centre.round(3).tolist(), "normal": direction.round(6).tolist(), "radius": line.circuit,
            "claimed": list(line.parted.get(fraction, line.burgers)), "burgers": found}
