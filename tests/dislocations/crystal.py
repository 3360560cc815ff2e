# SPDX-License-Identifier: GPL-3.0-or-later
"""Face-centred cubic crystals of Lennard-Jones atoms. Lengths in sigma; the rows of `axes` are the laboratory's x, y, z
in cube axes.

Vectors of the crystal are three whole numbers in units of a/6 along the cube axes: 1/2<110> is (3, 3, 0), a Shockley
partial 1/6<112> is (1, 1, 2), Frank's 1/3<111> is (2, 2, 2), a stair-rod 1/6<110> is (1, 1, 0).
"""

import itertools

import numpy as np

EDGE = 1.549603  # of the cube: no pressure with the potential cut off at 2.5 (lattice sum)
SPACING = EDGE / np.sqrt(2)  # of nearest neighbours
LAYER = EDGE / np.sqrt(3)  # of {111}

FAMILIES = {  # by the sorted sizes of a vector's parts
    (0, 3, 3): "perfect", (1, 1, 2): "shockley", (2, 2, 2): "frank", (0, 1, 1): "stair_rod", (0, 0, 2): "hirth",
}
FCC_NEIGHBOURS = np.array([v for v in itertools.product((-3, 0, 3), repeat=3) if sum(map(abs, v)) == 6])
HCP_NEIGHBOURS = np.array([np.multiply(signs, sizes) for signs in itertools.product((-1, 1), repeat=3)
                           for sizes in ((1, 1, 4), (1, 4, 1), (4, 1, 1))])  # those that fcc does not have


def family(burgers):
    return FAMILIES.get(tuple(sorted(abs(int(part)) for part in burgers)), "other")


def unit(vector):
    return np.asarray(vector, float) / np.linalg.norm(vector)


def turn(line, normal):
    """Axes with y along the normal and z along the line, both in cube axes."""
    return np.array([np.cross(unit(normal), unit(line)), unit(normal), unit(line)])


def mirrored(axes):
    """Axes of the crystal on the other side of a twin plane normal to y: turned by 180 degrees about it."""
    return np.diag([-1, 1, -1]) @ axes


def to_lab(axes, vector):
    """A vector of the crystal in sigma, along the laboratory's axes."""
    return axes @ np.asarray(vector) * EDGE / 6


def fault_shifts(normal):
    """The three 1/6<112> by which what lies on the side of this <111> may move to make a stacking fault."""
    beyond = FCC_NEIGHBOURS[FCC_NEIGHBOURS @ normal > 0]
    return beyond - np.outer(beyond @ normal / 3, normal).astype(int)


def fcc_points(axes, reach, origin=(0, 0, 0)):
    """All lattice points within `reach` (x, y, z) of the laboratory's zero; one of them would lie at `origin`."""
    n = int((np.linalg.norm(reach) + np.linalg.norm(origin)) / EDGE) + 2
    grid = np.arange(-n, n + 1)
    cells = np.stack(np.meshgrid(grid, grid, grid, indexing="ij"), -1).reshape(-1, 3)
    basis = ([0, 0, 0], [.5, .5, 0], [.5, 0, .5], [0, .5, .5])
    places = np.concatenate([(cells + b) @ (EDGE * axes.T) + origin for b in basis])
    return places[(np.abs(places) <= reach).all(1)]


def twin_lamella(axes, reach, half):
    """A crystal with a lamella |y| < half that is mirrored; half is a multiple of LAYER/2 and y normal to {111}."""
    origin = np.array([0.21, -half, 0.13])
    matrix = fcc_points(axes, reach, origin)
    twin = fcc_points(mirrored(axes), reach, origin)
    beyond = fcc_points(axes, reach, origin + [0, 4 * half, 0])  # two mirrors make a shift
    rim = half + LAYER / 2
    return np.concatenate([matrix[matrix[:, 1] < -rim], twin[np.abs(twin[:, 1]) < rim], beyond[beyond[:, 1] > rim]])
