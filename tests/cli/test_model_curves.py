# SPDX-License-Identifier: GPL-3.0-or-later
"""sample-data/model-curves: every figure with its files, and points of the curves that are known otherwise."""

import csv
import json
import math
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

import running

SCRIPT = running.ROOT / "sample-data" / "model-curves"
FIGURES = ("p1-fig02", "p1-fig06", "p1-fig08", "p1-fig11", "p1-fig12", "p1-fig13", "p2-fig01", "p2-fig15")
SPHERES = {"58.9": (914443, 58.4), "88.4": (3120599, 63.7), "147": (14434147, 65.5), "294": (115506757, 68.3)}
GAMMA = 3.17


def draw(*arguments):
    return subprocess.run([str(SCRIPT), running.program, *map(str, arguments)], capture_output=True, text=True, check=False,
                          timeout=300)


def jkr(radius, modulus, gamma=GAMMA):
    """delta0 and F_c of two spheres of this radius."""
    a0 = (9 * math.pi * gamma * (radius / 2)**2 / modulus)**(1 / 3)
    return a0**2 / (1.5 * radius), 1.5 * math.pi * gamma * radius


def curves(path):
    """Of the curves of a figure, by their names in the head of the table: x and y."""
    with open(path, newline="", encoding="utf-8") as file:
        head, *rows = list(csv.reader(file, strict=True))
    columns = [[float(row[k]) for row in rows if row[k]] for k in range(len(head))]
    return {head[k].rsplit(": ", 1)[0]: (columns[k], columns[k + 1]) for k in range(0, len(head), 2)}


@unittest.skipUnless(shutil.which("gnuplot"), "no gnuplot")
class Drawn(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        cls.dir = Path(scratch.name) / "curves"
        cls.done = draw("-o", cls.dir, "--points", 49)

    def curves(self, name):
        return curves(self.dir / f"{name}.csv")

    def test_every_figure_is_there(self):
        self.assertEqual((self.done.returncode, self.done.stderr), (0, ""))
        wanted = [f"{name}.{kind}" for name in FIGURES for kind in ("csv", "gp", "pdf", "svg")]
        self.assertEqual(sorted(p.name for p in self.dir.iterdir()), sorted(wanted + ["curves.json"]))
        said = json.loads((self.dir / "curves.json").read_text(encoding="utf-8"))
        for name in FIGURES:
            self.assertEqual((self.dir / f"{name}.pdf").read_bytes()[:5], b"%PDF-")
            svg = xml.etree.ElementTree.parse(self.dir / f"{name}.svg")
            paths = [e for e in svg.iter("{http://www.w3.org/2000/svg}path") if len(e.get("d", "")) > 200]
            self.assertGreaterEqual(len(paths), len(self.curves(name)), f"{name}: a path a curve")
            self.assertTrue(said[name]["commands"])
        self.assertEqual([p.name for p in self.dir.parent.iterdir()], ["curves"], "nothing else is left")

    def test_the_script_of_a_figure_draws_it_again(self):
        before = (self.dir / "p1-fig02.svg").read_bytes()
        (self.dir / "p1-fig02.svg").unlink()
        subprocess.run(["gnuplot", "p1-fig02.gp"], cwd=self.dir, check=True, capture_output=True)
        self.assertEqual((self.dir / "p1-fig02.svg").read_bytes(), before)

    def test_jkr_force(self):
        """Ends at pull-off (-(3/4)^(2/3), -5/9), -1 at -4^(-2/3), -8/9 at 0, 0 at 1, of delta0 and F_c."""
        for name, (delta0, pull), units in (("p1-fig02", jkr(147, 65.5), (1, 1)),
                                            ("p2-fig01", jkr(1e-7, 7e9 / 1.875, 0.1), (1e9, 1e9))):
            x, y = self.curves(name)["JKR"]
            x, y = [v / units[0] / delta0 for v in x], [v / units[1] / pull for v in y]
            self.assertAlmostEqual(x[0], -0.75**(2 / 3), delta=1e-12)
            self.assertAlmostEqual(y[0], -5 / 9, delta=1e-5)
            self.assertAlmostEqual(min(y), -1, delta=0.01)
            for d, f in ((0, -8 / 9), (1, 0)):
                k = next(k for k, v in enumerate(x) if v > d)
                part = (d - x[k - 1]) / (x[k] - x[k - 1])
                self.assertAlmostEqual(y[k - 1] + part * (y[k] - y[k - 1]), f, delta=0.02)  # linear between the points

    def test_contact_radius(self):
        found = self.curves("p1-fig06")
        self.assertEqual(len(found), 12)
        for name, (x, y) in found.items():
            if name.endswith("JKR"):  # delta = a^2/R* - sqrt(4 pi gamma a/E*), P1 eq. 5
                for d, a in zip(x[1:], y[1:]):
                    self.assertAlmostEqual(d, a * a / 44.2 - math.sqrt(4 * math.pi * GAMMA * a / 63.7), delta=1e-11)
            else:  # delayed: begins at beta = 0.02, a = (0.08 pi gamma R*^2/E*)^(1/3)
                self.assertAlmostEqual(y[0], (0.08 * math.pi * GAMMA * 44.2**2 / 63.7)**(1 / 3), delta=0.01)

    def test_restitution(self):
        """JKR by its closed form; e = 0 at low speed in every model, and never above 1."""
        found = self.curves("p1-fig08")
        self.assertEqual(len(found), 16)
        for radius, (mass, modulus) in SPHERES.items():
            delta0, pull = jkr(float(radius), modulus)
            lost = (6 * 4**(4 / 3) + 4) / 5 * 6**(-4 / 3) * pull * delta0
            for v, e in zip(*found[f"R = {radius}: JKR"]):
                self.assertAlmostEqual(e, math.sqrt(max(0, 1 - 4 * lost / (mass * v * v))), delta=1e-9)
        for name in ("p1-fig08", "p1-fig11", "p1-fig13"):
            for curve, (v, e) in self.curves(name).items():
                self.assertEqual((v[0], v[-1], len(v)), (0.02, 0.5, 49))
                self.assertTrue(all(0 <= x < 1 for x in e), curve)
                if "294" not in curve:
                    self.assertEqual(e[0], 0, curve)
        krijt = self.curves("p1-fig11")
        for radius in SPHERES:  # without yield the plastic model is Krijt's, with it e is less
            plain, plastic = krijt[f"R = {radius}: Krijt"][1], krijt[f"R = {radius}: Krijt pd, v_Y = 0.17"]
            for v, e, less in zip(plastic[0], plain, plastic[1]):
                self.assertTrue(abs(less - e) < 1e-7 if v < 0.17 or e == 0 else less < e, (radius, v, e, less))

    def test_what_the_text_says_of_its_laws(self):
        """P1: all of R = 147 bounce at v = 0.1; the models' e falls at high speed, unlike JKR's."""
        for name, law in (("p1-fig11", "stress"), ("p1-fig13", "power law")):
            v, e = self.curves(name)[f"R = 147: {law}"]
            self.assertGreater(e[v.index(min(v, key=lambda x: abs(x - 0.1)))], 0.7)
            self.assertLess(e[-1], max(e) - 0.1)
        self.assertGreater(max(self.curves("p1-fig11")["R = 58.9: stress"][1]), 0.1)

    def test_phase_plane(self):
        for curve, (x, v) in self.curves("p1-fig12").items():
            self.assertAlmostEqual(x[0], 0, delta=1e-15, msg=curve)
            self.assertAlmostEqual(v[0], 0.1, delta=1e-15, msg=curve)
            turn = x.index(max(x))
            self.assertLess(abs(v[turn]), 0.02)
            self.assertTrue(all(b < a for a, b in zip(v[turn - 1:], v[turn:turn + 3])), curve)

    def test_pressure(self):
        panels = list(self.curves("p2-fig15").values())
        (r, p), plastic, back = panels
        self.assertAlmostEqual(p[0], math.sqrt(0.5), delta=1e-12)  # of Y, by p_c as sqrt(delta)
        self.assertAlmostEqual(r[-1], math.sqrt(0.5), delta=1e-12)
        for x, y in zip(*plastic):  # Hertz cut off at Y
            self.assertAlmostEqual(y, min(1, math.sqrt(max(0, 3 - x * x))), delta=1e-7)
        for x, y in zip(*back):  # eqs 65 to 67: the inner part has a_Y,max^2 = R*(3 - 1) delta_Y
            self.assertAlmostEqual(y, math.sqrt(max(0, 2.5 - max(x * x, 2))), delta=1e-7)


class Refused(running.Case):
    def test_nothing_is_left_of_what_fails(self):
        (self.dir / "own").mkdir()
        (self.dir / "own" / "text").write_text("mine", encoding="utf-8")
        for arguments, says in ((["-o", self.dir / "own"], "--force"), (["-o", self.dir / "own", "--force"], "curves.json")):
            done = draw(*arguments)
            self.assertEqual(done.returncode, 1)
            self.assertIn(says, done.stderr)
        done = subprocess.run([str(SCRIPT), "/bin/false", "-o", str(self.dir / "new")], capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 1)
        self.assertEqual([p.name for p in self.dir.iterdir()], ["own"])
        self.assertEqual(draw("-o", self.dir / "new", "--only", "p9").returncode, 2)


if __name__ == "__main__":
    running.main()
