# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts of grains without mdana: all pairs, and JKR by its parametric curve."""

import numpy as np
from scipy.optimize import brentq


class Jkr:
    """Two equal grains: d = 3 u^2 - 2 sqrt(u), F/F_c = 4 (u^3 - u^1.5), u = a/a0, d = overlap/delta0."""

    def __init__(self, radius, gamma, modulus, nu):
        reduced = radius / 2
        contact = modulus / (2 * (1 - nu * nu))
        self.a0 = (9 * np.pi * gamma * reduced**2 / contact)**(1 / 3)
        self.delta0 = self.a0**2 / (3 * reduced)
        self.pull = 3 * np.pi * gamma * reduced
        self.stiffness = 1.2 * contact * self.a0

    @classmethod
    def of_scene(cls, scene):
        grains = scene["grains"]
        return cls(grains["radius"], grains["surface_energy"], grains["modulus"], grains["poisson_ratio"])

    def force(self, overlap):
        """Of one contact on the stable branch; it must be above the pull-off, -0.825 delta0."""
        d = overlap / self.delta0
        u = brentq(lambda u: 3 * u * u - 2 * np.sqrt(u) - d, 6**(-2 / 3), 2 + np.sqrt(abs(d)), xtol=1e-15)
        return 4 * self.pull * (u**3 - u**1.5)

    def forces(self, overlaps):
        return np.array([self.force(overlap) for overlap in overlaps])


def pairs(frame, least=0.0):
    """All pairs with an overlap of at least `least`: indices, overlaps, unit vectors from the first to the second."""
    x, radius = frame["x y z"], frame["radius"][:, 0]
    first, second, overlaps, normals = [], [], [], []
    for i in range(len(x) - 1):
        apart = x[i + 1:] - x[i]
        distance = np.linalg.norm(apart, axis=1)
        overlap = radius[i] + radius[i + 1:] - distance
        for k in np.flatnonzero(overlap >= least):
            first.append(i)
            second.append(i + 1 + k)
            overlaps.append(overlap[k])
            normals.append(apart[k] / distance[k])
    return np.array(first, dtype=int), np.array(second, dtype=int), np.array(overlaps), np.array(normals).reshape(-1, 3)
