# SPDX-License-Identifier: GPL-3.0-or-later
"""Burgers circuits from atom to atom about a known place, with the labels of LAMMPS' compute cna/atom."""

from collections import deque

import numpy as np
from scipy.spatial import cKDTree

from crystal import EDGE, FCC_NEIGHBOURS, HCP_NEIGHBOURS, SPACING, unit

FCC, HCP, OTHER = 1, 2, 5
WAYPOINTS = 12
LONGEST = 12  # bonds from one to the next; the other way round has more
CLEAR = 0.25  # of the spacing: how far a bond may be from what it is taken for; the nearest two are 0.47 apart


class NoCircuit(Exception):
    """There is no path of crystalline atoms about the place, or a bond on it is unclear."""


def burgers(places, labels, case, axes, centre, direction, radius):
    """b in a/6 of what a right-handed circle about the direction encloses, in the frame of axes, or of the case's:
    minus the sum of the ideal vectors of its bonds."""
    total = np.zeros(3)
    way = circuit(places, labels, centre, direction, radius)
    for a, b in zip(way, np.roll(way, -1)):
        turn = case.axes_at((places[a] + places[b]) / 2)
        total += turn @ ideal((places[b] - places[a]) @ turn, HCP in (labels[a], labels[b]))
    result = -total @ (case.axes if axes is None else axes)
    if np.abs(result - result.round()).max() > 1e-6:
        raise NoCircuit(f"not a vector of the crystal: {result.round(3)}")
    return [int(part) for part in result.round()]


def circuit(places, labels, centre, direction, radius):
    """Crystalline atoms near the circle, each a neighbour of the one before, and the first of the last."""
    w = unit(direction)
    u = unit(np.cross(w, [0.36, 0.48, 0.8]))
    v = np.cross(w, u)
    relative = places - centre
    off = np.abs(np.hypot(relative @ u, relative @ v) - radius)
    atoms = np.flatnonzero(np.isin(labels, (FCC, HCP)) & (off < 1.3) & (np.abs(relative @ w) < 2))
    if not len(atoms):
        raise NoCircuit("no crystalline atoms")
    tree = cKDTree(places[atoms])
    angle = 2 * np.pi * np.arange(WAYPOINTS) / WAYPOINTS
    gap, stops = tree.query(centre + radius * (np.outer(np.cos(angle), u) + np.outer(np.sin(angle), v)))
    if gap.max() > 1.5 * SPACING:
        raise NoCircuit(f"no crystalline atom within {gap.max():.2f} of the circle")
    neighbours = tree.query_ball_point(places[atoms], 1.2 * SPACING)
    ways = [path(neighbours, first, last)[:-1] for first, last in zip(stops, np.roll(stops, -1))]
    return atoms[np.concatenate(ways).astype(int)]


def path(neighbours, first, last):
    """Shortest way from bond to bond."""
    before, queue = {first: None}, deque([first])
    while queue and last not in before:
        here = queue.popleft()
        for there in neighbours[here]:
            if there not in before:
                before[there] = here
                queue.append(there)
    if last not in before:
        raise NoCircuit("the circle is interrupted")
    way = [last]
    while before[way[-1]] is not None:
        way.append(before[way[-1]])
    if len(way) > LONGEST:
        raise NoCircuit("a path goes round the other way")
    return way[::-1]


def ideal(bond, faulted):
    """The crystal's vector (a/6) that a bond in its axes stands for; at atoms of a fault those of hcp, too."""
    vectors = np.concatenate([FCC_NEIGHBOURS, HCP_NEIGHBOURS]) if faulted else FCC_NEIGHBOURS
    misfit = np.linalg.norm(vectors - bond * 6 / EDGE, axis=1)
    if misfit.min() > CLEAR * SPACING * 6 / EDGE:
        raise NoCircuit(f"a bond is {misfit.min() * EDGE / 6 / SPACING:.2f} spacings from any of the crystal's")
    return vectors[misfit.argmin()]
