# SPDX-License-Identifier: GPL-3.0-or-later
"""mdana law: curves and pressures of the force laws against their closed forms, and what is refused."""

import math

import running

JKR = {"R": 147, "E": 65.5, "gamma": 3.17}
RADIUS = 73.5  # R*
A0 = (9 * math.pi * 3.17 * RADIUS**2 / 65.5)**(1 / 3)
DELTA0 = A0**2 / (3 * RADIUS)
PULL = 3 * math.pi * 3.17 * RADIUS  # F_c
LEAST = -0.75**(2 / 3) * DELTA0


def arguments(law, parameters, *more):
    return ["law", "--law", law, *(x for k, v in parameters.items() for x in ("-p", f"{k}={v}")), *more]


def at(table, delta):
    """The row of that delta."""
    return {name: column[table["delta"].index(delta)] for name, column in table.items()}


class Law(running.Case):
    def test_points_of_jkr(self):
        """(u, d, F) of first contact, of the force's minimum and of equilibrium; U = -6/5 there."""
        for u, d, f in (((2 / 3)**(2 / 3), 0, -8 / 9), (4**(-1 / 3), -4**(-2 / 3), -1), (1, 1, 0)):
            table = self.table(*arguments("jkr", JKR, "--delta", f"{d * DELTA0!r}:{2 * DELTA0!r}:2"))
            self.assertAlmostEqual(table["F"][0] / PULL, f, delta=1e-13)
            self.assertAlmostEqual(table["a"][0] / A0, u, delta=1e-7 if u < 0.7 else 1e-13)
        self.assertAlmostEqual(table["U"][0] / (PULL * DELTA0), -6 / 5, delta=1e-13)
        self.assertAlmostEqual(table["p_c"][0], 65.5 * 4 * A0 / (3 * math.pi * RADIUS), delta=1e-12)

    def test_least_is_pull_off(self):
        found = self.document(*arguments("jkr", JKR, "--delta", "least:8:5"))
        self.assertAlmostEqual(found["least_delta"], LEAST, delta=1e-14)
        self.assertAlmostEqual(found["R_star"], RADIUS, delta=1e-13)
        rows = found["results"]
        self.assertEqual(rows["delta"][0], found["least_delta"])
        self.assertAlmostEqual(rows["F"][0] / PULL, -5 / 9, delta=1e-6)  # the root of rounding, at a vertical tangent
        self.assertEqual((rows["delta"][-1], len(rows["delta"]), set(rows["branch"])), (8, 5, {"loading"}))
        apart = self.table(*arguments("jkr", JKR, "--delta", "-2:-1.5:3"))
        self.assertEqual((apart["F"], apart["a"], apart["U"]), ([0] * 3,) * 3)

    def test_unequal_spheres_and_a_wall(self):
        wanted = self.table(*arguments("hertz", {"R": 2, "E": 3}, "--delta", "0:0.1:11"))
        for radii in ({"R1": 1, "R2": "inf"}, {"R1": 1.5, "R2": 3}):
            self.assert_close(self.table(*arguments("hertz", radii | {"E": 3}, "--delta", "0:0.1:11"))["F"], wanted["F"],
                              1e-15, max(wanted["F"]))
        self.assertAlmostEqual(wanted["F"][-1], 4 * 0.1**1.5, delta=1e-15)

    def test_andrews_back_from_the_last_delta(self):
        """P2 eqs 64 and 68; the loop encloses what is lost."""
        law, depth = {"R": 2, "E": 1, "Y": 0.1}, (0.05 * math.pi)**2  # delta_Y, R* = 1
        last = 3 * depth
        table = self.table(*arguments("andrews", law, "--delta", f"least:{last!r}:401"))
        self.assertEqual(table["branch"], ["loading"] * 401 + ["unloading"] * 401)
        self.assertEqual(table["delta"][400], table["delta"][401])
        self.assertAlmostEqual(table["F"][400], math.pi * 0.1 * (last - depth / 3), delta=1e-15)
        self.assertAlmostEqual(table["F"][401], table["F"][400], delta=1e-14)
        self.assertAlmostEqual(table["delta"][-1], last - depth, delta=1e-15)
        self.assertEqual(table["F"][-1], 0)
        middle = table["delta"][600]
        x = middle - (last - depth)
        self.assertAlmostEqual(table["F"][600], 2 * ((last - depth) * x**0.5 + 2 / 3 * x**1.5), delta=1e-15)
        self.assertLess(table["U"][401], table["U"][400])

    def test_pressure_over_the_contact(self):
        depth = (0.05 * math.pi)**2
        law = {"R": 2, "E": 1, "Y": 0.1}
        table = self.table(*arguments("andrews", law, "--profile", repr(3 * depth)))
        self.assertEqual((table["r"][0], len(table["r"])), (0, 201))
        self.assertAlmostEqual(table["r"][-1], math.sqrt(3 * depth), delta=1e-15)
        self.assertEqual((table["p"][0], table["p"][-1]), (0.1, 0))
        # F is the pressure over the area: int 2 pi r p dr, by the trapezoidal rule (1e-3: p ends in a root).
        force = sum((table["r"][k + 1]**2 - table["r"][k]**2) * (table["p"][k + 1] + table["p"][k]) / 2
                    for k in range(200)) * math.pi
        self.assertAlmostEqual(force / (math.pi * 0.1 * (3 - 1 / 3) * depth), 1, delta=1e-3)
        back = self.document(*arguments("andrews", law, "--profile", repr(2.5 * depth), "--delta-max", repr(3 * depth)))
        self.assertAlmostEqual(back["p_c"], 2 / math.pi * math.sqrt(0.5 * depth), delta=1e-15)  # eq. 66
        infinite = self.document(*arguments("jkr", JKR, "--profile", "1"))["results"]["p"]
        self.assertEqual([k for k, p in enumerate(infinite) if p is None or p == 0], [200])

    def test_all_laws_and_sinks(self):
        more = {"hertz": (), "dmt": ("gamma",), "jkr": ("gamma",), "maugis": ("gamma", "spacing"), "andrews": ("Y",),
                "thornton": ("gamma", "Y")}
        values = {"gamma": 3.17, "spacing": 1.091, "Y": 7.9}
        for law, names in more.items():
            parameters = {"R": 147, "E": 65.5} | {name: values[name] for name in names}
            table = self.table(*arguments(law, parameters, "--delta", "least:8:9"))
            self.assertEqual(list(table), ["branch", "delta", "F", "a", "p_c", "U", "stiffness"])
            self.assertEqual(table["delta"][8], 8)
            self.assertTrue(all(f is not None for f in table["F"]), law)
            self.mdana(*arguments(law, parameters, "--delta", "least:8:9", "-o", self.dir / "law.h5"))
            for name in parameters:
                left = {k: v for k, v in parameters.items() if k != name}
                self.refused(*arguments(law, left, "--delta", "0:8:9"), says=[name])

    def test_what_is_refused_is_named(self):
        for changes, says in (({"E": 0}, "E=0"), ({"E": "nan"}, "E=nan"), ({"gamma": -1}, "gamma=-1"), ({"R": "inf"}, "R=inf"),
                              ({"E": "1e999"}, "E=1e999"), ({"E": "x"}, "E=x"), ({"m": 1}, "no parameter m"), ({"R1": 1}, "R1")):
            self.refused(*arguments("jkr", JKR | changes, "--delta", "0:8:9"), says=[says])
        self.refused(*arguments("jkr", JKR, "-p", "E=1", "--delta", "0:8:9"), says=["E is given twice"])
        for delta in ("0:8", "8:0:9", "0:8:1", "0:8:9.5", "a:8:9", "0:nan:9", "0:8:1e9", "least", ""):
            self.refused(*arguments("jkr", JKR, "--delta", delta), code=2, says=["--delta"])
        self.refused(*arguments("jkr", JKR, "--delta", "least:-5:9"), says=["begins at -1.42"])
        self.refused(*arguments("none", JKR, "--delta", "0:8:9"), code=2, says=["hertz", "maugis"])
        self.refused(*arguments("jkr", JKR), code=2, says=["--delta"])
        self.refused(*arguments("jkr", JKR, "--delta", "0:8:9", "--profile", "1"), code=2, says=["--profile"])
        self.refused(*arguments("jkr", JKR, "--profile", "1", "--delta-max", "2"), code=2, says=["no history"])
        self.refused(*arguments("jkr", JKR, "--profile", "-2"), says=["begins at"])
        andrews = {"R": 2, "E": 1, "Y": 0.1}
        self.refused(*arguments("andrews", andrews, "--profile", "1", "--delta-max", "0.5"), code=2, says=["--delta-max"])


if __name__ == "__main__":
    running.main()
