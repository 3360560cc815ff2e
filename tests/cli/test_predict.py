# SPDX-License-Identifier: GPL-3.0-or-later
"""mdana predict and mdana stability laws: numbers, sweeps, searches, and parameters that are refused."""

import math

import running

SPHERE = {"R": 147, "m": 14434147, "E": 65.5}
KRIJT = SPHERE | {"gamma": 3.17, "nu": 0.25, "T_vis": 0.075, "spacing": 1.091}
NUMBERS = ("e", "e_error", "delta_max", "t_max", "contact_time", "a_max", "p_c_max", "energy_residual", "evaluations",
           "seconds")


def arguments(law, parameters, *more):
    return ["predict", "--law", law, *(x for k, v in parameters.items() for x in ("-p", f"{k}={v}")), *more]


class Predict(running.Case):
    def test_jkr_by_its_closed_form(self):
        found = self.document(*arguments("jkr", SPHERE | {"gamma": 3.17, "v": 0.1}))
        r, m, e = 73.5, 14434147 / 2, 65.5
        a0 = (9 * math.pi * 3.17 * r * r / e)**(1 / 3)
        lost = (6 * 4**(4 / 3) + 4) / 5 * 6**(-4 / 3) * 3 * math.pi * 3.17 * r * a0**2 / (3 * r)
        self.assertAlmostEqual(found["e"], math.sqrt(1 - 2 * lost / (m * 0.01)), delta=1e-14)
        self.assertEqual(found["outcome"], "bounce")
        # The trajectory's greatest delta, and p_c of P1 eq. 9 at the greatest a.
        p = 2 * e * found["a_max"] / (math.pi * r) - math.sqrt(4 * 3.17 * e / (math.pi * found["a_max"]))
        self.assertAlmostEqual(found["p_c_max"], p, delta=1e-10 * p)
        self.assertAlmostEqual(found["p_c_max"] / e, 0.211, delta=5e-4)  # P1, section V

    def test_all_numbers_are_plain(self):
        found = self.document(*arguments("krijt", KRIJT | {"v": 0.1}))
        for name in NUMBERS:
            self.assertIsInstance(found[name], (int, float), name)
        self.assertLess(found["e_error"], 1e-8)
        self.assertEqual(found["warnings"], [])

    def test_spacing_is_not_taken_silently(self):
        without = {k: v for k, v in KRIJT.items() if k != "spacing"}
        self.assertIn("spacing is not given", str(self.document(*arguments("krijt", without | {"v": 0.1}))["warnings"]))

    def test_a_sweep_has_both_ends(self):
        found = self.document(*arguments("krijt", KRIJT | {"v": "0.04:0.5:24"}))
        velocities = [entry["v"] for entry in found["results"]]
        self.assertEqual((len(velocities), velocities[0], velocities[-1]), (24, 0.04, 0.5))
        one = self.document(*arguments("krijt", KRIJT | {"v": 0.04}))
        self.assertEqual(found["results"][0]["e"], one["e"])
        table = self.table(*arguments("krijt", KRIJT | {"v": "0.04:0.5:24"}))
        self.assertEqual(table["e"], [entry["e"] for entry in found["results"]])

    def test_trajectory(self):
        table = self.table(*arguments("power", SPHERE | {"gamma": 3.17, "D": 118, "alpha": 3, "beta": 1.5, "v": 0.1},
                                      "--trajectory"))
        self.assertEqual(list(table), ["t", "delta", "v", "a", "F"])
        m = 14434147 / 2
        self.assertGreater(len(table["t"]), 40)
        # dv/dt = -F/m*, by the trapezoidal rule over short steps.
        t, v, force = table["t"], table["v"], table["F"]
        change = [-(t[k + 1] - t[k]) * (force[k] + force[k + 1]) / (2 * m) for k in range(len(t) - 1)]
        self.assert_close([sum(change)], [v[-1] - v[0]], 0.01, 0.2)

    def test_searches(self):
        found = self.document(*arguments("jkr", SPHERE | {"gamma": 3.17}, "--sticking-velocity"))
        v = found["sticking_velocity"]["value"]
        for x, outcome in ((0.999999, "stick"), (1.000001, "bounce")):
            self.assertEqual(self.document(*arguments("jkr", SPHERE | {"gamma": 3.17, "v": x * v}))["outcome"], outcome)
        peak = self.document(*arguments("krijt", KRIJT, "--peak"))["peak"]
        self.assertLess(peak["error"], 1e-9)
        nothing = self.document(*arguments("hertz", SPHERE, "--sticking-velocity"), code=4)
        self.assertIsNone(nothing["sticking_velocity"]["value"])
        self.assertIn("bounce at the lowest", str(nothing["left_out"]))

    def test_what_is_refused_is_named(self):
        for changes, says in (({"nu": 0}, "nu=0"), ({"T_vis": -1}, "T_vis=-1"), ({"gamma": "nan"}, "gamma=nan"),
                              ({"Q": 1}, "no parameter Q"), ({"R": "1e999"}, "R=1e999"), ({"E": "inf"}, "E=inf")):
            self.refused(*arguments("krijt", KRIJT | {"v": 0.1} | changes), says=[says])
        self.refused(*arguments("krijt", KRIJT), says=["parameter v is missing"])
        self.refused(*arguments("krijt", KRIJT | {"v": 0.1}, "-p", "nu=0.3"), says=["nu is given twice"])
        for v in ("0.1:0.5", "0.5:0.1:3", "0.1:0.5:1", "a:b:c", "0:1:5", "0.1:0.5:1e9"):
            self.refused(*arguments("krijt", KRIJT | {"v": v}), code=2, says=["v="])
        self.refused(*arguments("none", SPHERE), code=2, says=["hertz", "krijt"])
        self.refused(*arguments("krijt", KRIJT | {"v": 0.1}, "dump"), code=2, says=["reads no file"])
        self.refused(*arguments("krijt", KRIJT | {"v": "0.1:0.5:3"}, "--trajectory"), code=2, says=["--trajectory"])

    def test_what_is_not_resolved_says_so(self):
        stiff = SPHERE | {"gamma": 3.17, "nu": 0.25, "C": 2.1e-4, "B": 1e100, "zeta": 4, "spacing": 1.091, "v": 0.1}
        found = self.document(*arguments("stress", stiff, "--time-limit", "0.001"), code=4)
        self.assertEqual(found["outcome"], "unresolved")
        self.assertIn("time limit", found["reason"])
        self.assertIsNone(found["e"])



if __name__ == "__main__":
    running.main()
