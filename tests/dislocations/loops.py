# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases with closed lines in balls: loops and the stacking-fault tetrahedron."""

import itertools

import numpy as np

import measure
from case import Case, Line
from crystal import EDGE, LAYER, SPACING, fault_shifts, fcc_points, to_lab, turn
from fields import circle, loop

X, _, Z = np.eye(3)


def follow(case, places, labels):
    for line in case.lines:
        line.corners = measure.loop(line, places, labels)


def ball(axes, radius, origin):
    places = fcc_points(axes, (radius,) * 3, origin)
    return places[np.linalg.norm(places, axis=1) < radius]


def shockley_loop(noise, steps, about):
    """In the plane y = 0, anticlockwise about y."""
    axes, radius = turn((1, 1, -2), (1, 1, 1)), 14.0
    places = ball(axes, 20.0, (0.21, LAYER / 2, 0.13))
    corners, shift = circle(radius, Z, X), fault_shifts(np.array([1, 1, 1]))[0]
    places = places + loop(places, corners, to_lab(axes, shift))
    places += np.random.default_rng(1).normal(0, 1, places.shape) * noise
    line = Line(-shift, corners, closed=True)
    return Case(f"Shockley loop of radius 14 on (111), {about}", axes, places, [line],
                {"relative": 0.03 if steps else 0.02, "reason": "steps of the line from row to row of atoms"},
                steps=steps, measure=follow if steps else None)


def prismatic(axes, shift, layers, cell, radius, origin, about, aside=(0, 0, 0), parted=None, **more):
    """Layers parallel to y = 0 taken out (shift against y) or put in (along y) within a disc; cell: area of an atom;
    aside: what is put in is a copy of the layers above, shifted so that it is not stacked like them."""
    places = ball(axes, 19.0, origin)
    thickness = np.linalg.norm(to_lab(axes, shift))
    inside = np.hypot(places[:, 0], places[:, 2]) < radius
    if (axes @ shift)[1] > 0:
        extra = places[inside & (places[:, 1] > 0) & (places[:, 1] < thickness)]
        changed, added = len(extra), extra - [0, thickness / 2, 0] + to_lab(axes, aside)
    else:
        gone = inside & (np.abs(places[:, 1]) < thickness / 2)
        changed, added = gone.sum(), np.zeros((0, 3))
        places = places[~gone]
    effective = np.sqrt(changed / layers * cell / np.pi)
    corners = circle(effective, Z, X)
    places = np.concatenate([places + loop(places, corners, to_lab(axes, shift)), added])
    line = Line(-np.array(shift), corners, closed=True)
    if more.get("net"):
        line.circuit, line.parted = 5.5, parted or {}
    return Case(f"{about}; radius {effective:.2f} by the area of the {changed} atoms", axes, places, [line],
                {"relative": 0.06, "reason": "the edge of the disc is uncertain by half a spacing"}, **more)


def frank_vacancy(**more):
    axes = turn((1, 1, -2), (1, 1, 1))
    return prismatic(axes, (-2, -2, -2), 1, SPACING**2 * np.sqrt(3) / 2, 9.0, (0.21, 0, 0.13),
                     "Frank loop, one layer of (111) missing", **more)


def frank_interstitial(**more):
    axes = turn((1, 1, -2), (1, 1, 1))
    return prismatic(axes, (2, 2, 2), 1, SPACING**2 * np.sqrt(3) / 2, 9.0, (0.21, LAYER / 2, 0.13),
                     "Frank loop, one more layer of (111)", fault_shifts(np.array([1, 1, 1]))[0], **more)


def prismatic_interstitial(**more):
    axes = turn((0, 0, 1), (1, 1, 0))
    return prismatic(axes, (3, 3, 0), 2, EDGE * SPACING, 9.0, (0.21, SPACING / 4, 0.13),
                     "perfect prismatic loop, two more layers of (220)", **more)


NORMALS = np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)])  # of the tetrahedron, outward


def tetrahedron_shifts():
    """Shifts of what lies outside the faces: Frank's 1/3<111> inward at the first, so that all edges are stair-rods."""
    for shifts in itertools.product([-2 * NORMALS[0]], *(fault_shifts(n) for n in NORMALS[1:])):
        edges = [np.sort(np.abs(a - b)) for a, b in itertools.combinations(shifts, 2)]
        if all((edge == (0, 1, 1)).all() for edge in edges):
            return np.array(shifts)
    raise AssertionError("no stair-rods")


def face(corners, k):
    """The three corners besides k, anticlockwise from outside."""
    three = np.delete(np.arange(4), k)
    return three if np.linalg.det(corners[three] - corners[k]) > 0 else three[::-1]


def edges(shifts, corners):
    lines = []
    for k in range(4):
        for first, last in zip(face(corners, k), np.roll(face(corners, k), -1)):
            other = 6 - k - first - last
            if k < other:
                lines.append(Line(shifts[other] - shifts[k], corners[[first, last]]))
    return lines


def stacking_fault_tetrahedron(rows):
    """After Silcox & Hirsch (1959): a triangle of vacancies with `rows` along each edge, whose fault opens to four."""
    axes, side = turn((1, -1, 0), (1, 1, 1)), (rows - 1) * SPACING
    outward = NORMALS @ axes.T / np.sqrt(3)
    inradius = side / np.sqrt(24)
    centre = np.array([0, -inradius, 0])
    triangle = centre - 3 * inradius * outward[1:]
    places = ball(axes, 19.0, triangle[0])
    from_centre = (places - centre) @ outward.T
    gone = (np.abs(from_centre[:, 0] - inradius) < 0.1) & (from_centre[:, 1:] < inradius + 0.1).all(1)
    distances = inradius + np.array([0, 1, 1, 1]) * LAYER / 2  # the faults run between two layers
    corners = centre + np.array([np.linalg.solve(np.delete(outward, k, 0), np.delete(distances, k)) for k in range(4)])
    places, shifts = places[~gone], tetrahedron_shifts()
    u = sum(loop(places, corners[face(corners, k)], to_lab(axes, shifts[k])) for k in range(4))
    about = f"stacking-fault tetrahedron of {gone.sum()} vacancies, {rows} along each edge of the triangle"

    def follow_faces(case, labelled_places, labels):
        case.lines = edges(shifts, measure.tetrahedron(centre, outward, inradius, labelled_places, labels))

    return Case(about, axes, places + u, edges(shifts, corners),
                {"relative": 0.1, "reason": "where an edge ends is uncertain by half a spacing at each corner"},
                measure=follow_faces)


BRIEFLY = {"steps": 20, "found": "minimised in 20 steps only: further on, the line dissociates"}
FULLY = {"net": True, "found": "the line has dissociated: what is known is the sum of the Burgers vectors in the discs"}
LOOPS = {
    "shockley_loop": lambda: shockley_loop(0, 0, "displaced exactly, not relaxed"),
    "shockley_loop_0.001": lambda: shockley_loop(1e-3, 0, "noise of 0.001, not relaxed"),
    "shockley_loop_0.05": lambda: shockley_loop(0.05, 0, "noise of 0.05, not relaxed"),
    "shockley_loop_relaxed": lambda: shockley_loop(0, 15, "minimised in 15 steps only, as it shrinks"),
    "frank_vacancy": lambda: frank_vacancy(**BRIEFLY), "frank_interstitial": lambda: frank_interstitial(**BRIEFLY),
    "prismatic": lambda: prismatic_interstitial(**BRIEFLY),
    "frank_vacancy_relaxed": lambda: frank_vacancy(**FULLY),
    "frank_interstitial_relaxed": lambda: frank_interstitial(**FULLY),
    "prismatic_relaxed": lambda: prismatic_interstitial(parted={0.25: (-1, -2, 1)}, **FULLY),
    "tetrahedron": lambda: stacking_fault_tetrahedron(12),
}
