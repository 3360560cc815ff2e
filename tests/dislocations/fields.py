# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacements of dislocations in an isotropic solid (Hirth & Lothe, Theory of Dislocations). Lengths in sigma.

Burgers vectors are the jump of the displacement in a right-handed turn about the line: b = closed integral of du.
"""

import numpy as np

POISSON = 0.25


def bending(x, y, burgers):
    """Displacement by an edge dislocation along z without what grows in each turn (Hirth & Lothe 3-45, 3-46)."""
    squared = x * x + y * y + 1e-12
    log, mixed, difference = (1 - 2 * POISSON) * np.log(squared), 2 * x * y / squared, (x * x - y * y) / squared
    u = np.zeros((len(x), 3))
    u[:, 0] = burgers[0] * mixed + burgers[1] * (log - difference)
    u[:, 1] = -burgers[0] * (log + difference) - burgers[1] * mixed
    return u / (8 * np.pi * (1 - POISSON))


def straight(places, at, burgers):
    """A line along +z through (x, y); the crystal is cut at y = at[1], x < at[0]."""
    x, y = (places[:, :2] - at).T
    return np.outer(np.arctan2(y, x) / (2 * np.pi), burgers) + bending(x, y, burgers)


def moved(places, start, end, burgers):
    """What a straight line that moves from start to end, both (x, y), adds; the crystal is cut between them."""
    (x0, y0), (x1, y1) = (places[:, :2] - start).T, (places[:, :2] - end).T
    angle = np.arctan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1)
    return np.outer(angle / (2 * np.pi), burgers) + bending(x1, y1, burgers) - bending(x0, y0, burgers)


def solid_angle(places, corners):
    """Of a polygon, positive on the side from which it runs anticlockwise (Van Oosterom & Strackee 1983)."""
    centre, total = corners.mean(0), np.zeros(len(places))
    for first, second in zip(corners, np.roll(corners, -1, axis=0)):
        r = [corner - places for corner in (centre, first, second)]
        size = [np.linalg.norm(v, axis=1) for v in r]
        triple = np.einsum("ij,ij->i", r[0], np.cross(r[1], r[2]))
        below = size[0] * size[1] * size[2] + sum(
            np.einsum("ij,ij->i", r[i], r[j]) * size[k] for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)))
        total -= 2 * np.arctan2(triple, below)
    return total


def loop(places, corners, shift):
    """What lies before the polygon (see solid_angle) moves by +shift/2, what lies behind by -shift/2. Topology only: of
    Burgers' formula without its two line integrals. The line runs anticlockwise and its b is -shift."""
    return np.outer(solid_angle(places, corners) / (4 * np.pi), shift)


def circle(radius, u, v, corners=48):
    """Polygon of the same area in the plane of the orthogonal unit vectors u, v; anticlockwise about u x v."""
    angle = 2 * np.pi * (np.arange(corners) + 0.5) / corners
    outer = radius * np.sqrt(2 * np.pi / corners / np.sin(2 * np.pi / corners))
    return outer * (np.outer(np.cos(angle), u) + np.outer(np.sin(angle), v))
