# SPDX-License-Identifier: GPL-3.0-or-later
"""Where relaxed lines are, from LAMMPS' labels: the atoms without structure are the cores."""

import numpy as np

OTHER, HCP = 5, 2
CORE = 3.0  # how far from a line its atoms without structure are, at most
DEEP = 2.5  # closer to the end of a rod atoms without structure are its surface


def straight(line, places, labels):
    """Follows a line along z from the middle to both ends of a rod; corners of the smooth line that fits best."""
    low, high = places[:, 2].min(), places[:, 2].max()
    cores = places[labels == OTHER]
    begin = line.corners.mean(0)
    for reach in (4.5, CORE, CORE):
        begin = middle(cores, begin, reach)
    found = [begin]
    for step in (-1.0, 1.0):
        at = begin + [0, 0, step]
        while low + DEEP < at[2] < high - DEEP:
            at = middle(cores, at, CORE)
            found.append(at)
            at = at + [0, 0, step]
    found = np.array(found)
    z = np.linspace(low, high, 13)
    fits = [np.polynomial.Polynomial.fit(found[:, 2], found[:, k], 3) for k in range(2)]
    return np.column_stack([fits[0](z), fits[1](z), z])


def middle(cores, at, reach):
    near = cores[(np.abs(cores[:, 2] - at[2]) < 1.2) & (np.hypot(*(cores - at)[:, :2].T) < reach)]
    if not len(near):
        raise AssertionError(f"no core near {at.round(1)}: the line is not where it was put")
    return np.array([*near[:, :2].mean(0), at[2]])


def loop(line, places, labels):
    """A loop about the y axis: its radius as a smooth function of the angle, by the cores' atoms."""
    radius = np.linalg.norm(line.corners, axis=1).mean()
    across = np.hypot(places[:, 0], places[:, 2])
    core = (labels == OTHER) & (np.abs(places[:, 1]) < 2) & (np.abs(across - radius) < 3.5)
    waves = np.arange(4)

    def terms(angle):
        return np.concatenate([np.cos(np.outer(angle, waves)), np.sin(np.outer(angle, waves[1:]))], axis=1)

    weights = np.linalg.lstsq(terms(np.arctan2(places[core, 0], places[core, 2])), across[core], rcond=None)[0]
    angle = np.arctan2(line.corners[:, 0], line.corners[:, 2])
    return line.corners / np.linalg.norm(line.corners, axis=1)[:, None] * (terms(angle) @ weights)[:, None]


def tetrahedron(centre, outward, inradius, places, labels):
    """Corners from the planes between the two layers of hcp atoms of each face."""
    from_centre = (places[labels == HCP] - centre) @ outward.T
    nearest = np.abs(from_centre - inradius).argmin(1)
    distances = [from_centre[nearest == k, k] for k in range(4)]
    planes = np.array([(d[d > d.mean()].mean() + d[d <= d.mean()].mean()) / 2 for d in distances])
    return centre + np.array([np.linalg.solve(np.delete(outward, k, 0), np.delete(planes, k)) for k in range(4)])
