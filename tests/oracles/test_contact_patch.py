# SPDX-License-Identifier: GPL-3.0-or-later
"""The alpha and neighbours radii of contact-radius against scipy's Delaunay triangulation and k-d tree on the same
frames, and two balls of crystals that meet in a circle of known radius."""

import math
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
import dumps  # noqa: E402
import running  # noqa: E402
from running import SAMPLE, Case  # noqa: E402

try:
    from scipy.spatial import Delaunay, cKDTree
except ImportError:
    running.skip("no scipy (Debian: apt install python3-scipy)")

CIRCUMRADIUS, STACKED = 1.5, 0.35  # in spacings, as contact_patch.md states


def unstacked(points):
    """Outermost first, a point is dropped if one that stays is nearer than STACKED."""
    order = np.argsort(-np.linalg.norm(points - points.mean(axis=0), axis=1), kind="stable")
    kept = []
    for k in order:
        if all(np.linalg.norm(points[k] - other) >= STACKED for other in kept):
            kept.append(points[k])
    return np.array(kept)


def area(points, spacing):
    """Bare area of the alpha shape plus the strip by Euler's formula: (B/2 + chi) mean cells."""
    flat = unstacked(points / spacing) if len(points) else points
    if len(flat) < 3:
        return 0.0
    corners = Delaunay(flat).simplices
    a, b, c = (flat[corners[:, k]] for k in range(3))
    sides = [np.linalg.norm(q - p, axis=1) for p, q in ((a, b), (b, c), (c, a))]
    half = sum(sides) / 2  # Heron, unlike mdana
    triangle = np.sqrt(np.maximum(half * (half - sides[0]) * (half - sides[1]) * (half - sides[2]), 0))
    small = sides[0] * sides[1] * sides[2] < 4 * CIRCUMRADIUS * triangle
    corners, triangle = corners[small], triangle[small]
    if not len(corners):
        return 0.0
    edges = np.sort(np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), axis=1)
    edges, times = np.unique(edges, axis=0, return_counts=True)
    vertices = len(np.unique(corners))
    characteristic = vertices - len(edges) + len(corners)
    border = np.sum(times == 1)  # sides at the edge: as many as corners there, one that is there twice counted so
    cell = 2 * np.mean(triangle)
    return float(np.sum(triangle) + (border / 2 + characteristic) * cell) * spacing**2


def equivalent_radius(points, spacing):
    return math.sqrt(area(points, spacing) / math.pi)


class Frame:
    """Atoms of a frame about the contact plane of two spheres."""

    def __init__(self, x, body, radii):
        centre = [x[body == b].mean(axis=0) for b in (1, 2)]
        line = centre[1] - centre[0]
        distance = np.linalg.norm(line)
        normal = line / distance
        plane = centre[0] + normal * (distance**2 + radii[0]**2 - radii[1]**2) / (2 * distance)
        u = np.cross(normal, [0.3, 0.5, -0.8])
        u /= np.linalg.norm(u)
        self.x, self.body = x, body
        self.height = (x - plane) @ normal
        self.flat = np.stack([(x - plane) @ u, (x - plane) @ np.cross(normal, u)], axis=1)

    def both(self, chosen):
        return self.flat[chosen] if {1, 2} <= set(self.body[chosen]) else np.empty((0, 2))

    def alpha(self, layer, spacing):
        return equivalent_radius(self.both(np.abs(self.height) <= layer / 2), spacing)

    def neighbours(self, cutoff, spacing):
        chosen = np.zeros(len(self.x), bool)
        for b in (1, 2):
            tree = cKDTree(self.x[self.body != b])
            own = np.flatnonzero(self.body == b)
            chosen[own] = tree.query(self.x[own])[0] <= cutoff
        return equivalent_radius(self.both(chosen), spacing)


class ContactPatch(Case):
    def compare(self, *arguments, radii=(5, 5), layer=1.0):
        """To 1e-9: the same triangles, areas by other formulas (Heron's loses some digits on thin ones)."""
        document = self.document("contact-radius", SAMPLE, *arguments)["contact_radius"]
        table = self.table("contact-radius", SAMPLE, *arguments)
        spacing, cutoff = document["spacing"]["value"], document["neighbours"]["cutoff"]["value"]
        largest = 0.0
        for k, frame in enumerate(dumps.read(SAMPLE)):
            atoms = Frame(frame["x y z"], frame["type"][:, 0], radii)
            for name, wanted in (("alpha", atoms.alpha(layer, spacing)),
                                 ("neighbours", atoms.neighbours(cutoff, spacing))):
                found = table[f"contact_radius_{name}"][k]
                self.assertAlmostEqual(found, wanted, delta=1e-9, msg=f"{name}, frame {k}")
                largest = max(largest, found)
        self.assertGreater(largest, 2)
        return document, spacing

    def test_defaults(self):
        """The spacing is the median distance of nearest neighbours of the first frame, the cutoff 1.5 of it."""
        document, spacing = self.compare()
        first = dumps.read(SAMPLE)[0]
        x = first["x y z"]
        nearest = cKDTree(x).query(x, k=2)[0][:, 1]
        self.assertAlmostEqual(spacing, float(np.median(nearest)), delta=0.001 * spacing)
        self.assertAlmostEqual(document["neighbours"]["cutoff"]["value"], 1.5 * spacing, delta=1e-12)

    def test_options(self):
        self.compare("--spacing", "1.2", "--neighbour-cutoff", "1.3", "--layer", "1.7", "--radius", "5,4.5",
                     radii=(5, 4.5), layer=1.7)


class LatticeSpheres(Case):
    """Two fcc balls of different orientation pushed together: the lens where they would overlap is left out of each,
    so that they meet in the plane in a disc of known radius."""

    SPACING = 1.0
    RADIUS = 16.0

    def ball(self, random, side):
        """Atoms of a ball cut flat at the contact plane z = 0, half a plane distance off it."""
        constant = self.SPACING * math.sqrt(2)
        n = int(self.RADIUS / constant) + 3
        cells = np.stack(np.meshgrid(*[np.arange(-n, n + 1)] * 3), axis=-1).reshape(-1, 3)
        basis = np.array([[0, 0, 0], [0.5, 0.5, 0], [0.5, 0, 0.5], [0, 0.5, 0.5]])
        x = (cells[:, None] + basis + random.uniform(0, 1, 3)).reshape(-1, 3) * constant
        turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
        x = x @ turn.T
        centre = np.array([0, 0, side * self.height])
        x = x[np.linalg.norm(x, axis=1) < self.RADIUS] + centre
        return x[side * x[:, 2] > 0.35 * self.SPACING]

    def frame(self, random, radius, step):
        """The balls' centres at such a height that they meet in a circle of that radius."""
        self.height = math.sqrt(self.RADIUS**2 - radius**2)
        bodies = [self.ball(random, side) for side in (-1, 1)]
        rows = [f"{b + 1} {b + 1} {p[0]:.17g} {p[1]:.17g} {p[2]:.17g}\n" for b in (0, 1) for p in bodies[b]]
        rows = [f"{k + 1} {row.split(' ', 1)[1]}" for k, row in enumerate(rows)]
        return (f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(rows)}\nITEM: BOX BOUNDS ff ff ff\n"
                "-50 50\n-50 50\n-50 50\nITEM: ATOMS id type x y z\n" + "".join(rows))

    def radii_of(self, radius, seed):
        random = np.random.default_rng(seed)
        dump = self.dir / f"{radius}-{seed}.dump"
        # Two frames are the least that a collision has; both must hold as many atoms: twice the same.
        frame = self.frame(random, radius, 0)
        dump.write_text(frame + frame.replace("TIMESTEP\n0", "TIMESTEP\n1", 1), encoding="utf-8")
        return self.document("contact-radius", dump, "--units", "lj", "--spacing", "1", "--neighbour-cutoff", "1.5",
                             "--radius", "16")["contact_radius"]

    def test_known_overlap(self):
        """Neighbours reach beyond the circle of radius a to where the gap of the spheres is as wide as the atoms at the
        plane leave it: cutoff - 0.7 d = 0.8 d at most, that is to a' with a'^2 - a^2 = 0.8 R (two parabolas r^2/2R), and
        the error must reach down to a or the warning tell it. So a < found < a' within the error."""
        for radius, seed in ((6.0, 1), (8.0, 2), (10.0, 3)):
            with self.subTest(radius=radius):
                found = self.radii_of(radius, seed)
                outer = math.sqrt(radius**2 + 0.8 * self.RADIUS)
                print(radius, f"{outer:.2f}", {k: [round(found[k]["end"][w], 2) for w in ("value", "error")]
                                              for k in ("gyration", "alpha", "neighbours")})
                for name in ("gyration", "alpha", "neighbours"):
                    value, error = found[name]["end"]["value"], found[name]["end"]["error"]
                    self.assertGreater(value + error, radius, name)
                    self.assertLess(value - error, outer, name)
                    self.assertLess(error, 0.25 * radius, name)


if __name__ == "__main__":
    running.main()
