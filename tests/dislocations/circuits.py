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
    """b in a/6 of what a right-handed circle about the direction encloses: minus the sum of the ideal vectors of its bonds,
    in the frame of axes, or of the case's."""
    w = unit(direction)
    u = unit(np.cross(w, [0.36, 0.48, 0.8]))
    v = np.cross(w, u)
    relative = places - centre
    across, along = np.hypot(relative @ u, relative @ v), relative @ w
    good = np.isin(labels, (FCC, HCP)) & (np.abs(across - radius) < 1.3) & (np.abs(along) < 2)
    atoms = np.flatnonzero(good)
    if not len(atoms):
        raise NoCircuit("no crystalline atoms")
    tree = cKDTree(places[atoms])
    angle = 2 * np.pi * np.arange(WAYPOINTS) / WAYPOINTS
    ring = centre + radius * (np.outer(np.cos(angle), u) + np.outer(np.sin(angle), v))
    off, stops = tree.query(ring)
    if off.max() > 1.5 * SPACING:
        raise NoCircuit(f"no crystalline atom within {off.max():.2f} of the circle")
    neighbours = tree.query_ball_point(places[atoms], 1.2 * SPACING)
    total = np.zeros(3)
    for first, last in zip(stops, np.roll(stops, -1)):
        way = path(neighbours, first, last)
        for a, b in zip(way, way[1:]):
            start, end = places[atoms[a]], places[atoms[b]]
            turn = case.axes_at((start + end) / 2)
            total += turn @ ideal((end - start) @ turn, HCP in (labels[atoms[a]], labels[atoms[b]]))
    result = -total @ (case.axes if axes is None else axes)
    if np.abs(result - result.round()).max() > 1e-6:
        raise NoCircuit(f"not a vector of the crystal: {result.round(3)}")
    return [int(part) for part in result.round()]


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
