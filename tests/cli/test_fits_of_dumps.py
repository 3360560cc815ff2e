#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of forces out of dumps whose forces obey a law exactly."""

import math

import dumps
import running


class Case(running.Case):
    def dump(self, frames):
        path = self.dir / "made.dump"
        dumps.write(path, frames)
        return path


def random_effects(values, errors):
    """DerSimonian & Laird 1986: mean, its error and the deviation between runs."""
    weights = [1 / e**2 for e in errors]
    fixed = sum(w * v for w, v in zip(weights, values)) / sum(weights)
    q = sum(w * (v - fixed)**2 for w, v in zip(weights, values))
    between = max(0, (q - len(values) + 1) / (sum(weights) - sum(w * w for w in weights) / sum(weights)))
    weights = [1 / (e**2 + between) for e in errors]
    return sum(w * v for w, v in zip(weights, values)) / sum(weights), sum(weights)**-0.5, between**0.5


class FitHertz(Case):
    def test_unequal_bodies_need_their_ratio(self):
        dump = self.dump(dumps.hertz_bounce())
        self.refused("fit-hertz", dump, "--masses", "1=1,2=1.1", says=(dump, "differ", "--radius"))
        equal = self.document("fit-hertz", dump, "--radius", "5")
        other = self.document("fit-hertz", dump, "--radius", "5.5,4.5")
        # F(X) tells E* sqrt(R*) and R1 + R2; R* = (R1 + R2) c/(1 + c)^2 with c = R1/R2.
        self.assertAlmostEqual(equal["E_star_sqrt_R_star"]["value"], 60 * 2.5**0.5, 5)
        self.assertEqual(equal["E_star_sqrt_R_star"]["value"], other["E_star_sqrt_R_star"]["value"])
        self.assertEqual(equal["R"]["value"], other["R"]["value"])
        self.assertAlmostEqual(other["E_star"]["value"], 60 * (2.5 / (5.5 * 4.5 / 10))**0.5, 4)

    def test_runs_are_pooled(self):
        moduli = (50.0, 60.0, 76.0)
        files = []
        for k, modulus in enumerate(moduli):
            files.append(self.dir / f"run{k}.dump")
            dumps.write(files[-1], dumps.hertz_bounce(modulus))
        document = self.document("fit-hertz", *files)
        self.assertEqual(document["pooled_runs"], 3)
        self.assertEqual([round(run["E_star"]["value"], 4) for run in document["runs"]], list(moduli))
        errors = [run["E_star"]["error"] for run in document["runs"]]
        mean, error, between = random_effects(moduli, errors)
        pooled = document["E_star"]
        self.assertAlmostEqual(pooled["value"], mean, 3)
        self.assertAlmostEqual(pooled["error"], error, 3)
        self.assertAlmostEqual(pooled["between"], between, 3)
        self.assertAlmostEqual(pooled["within"], math.sqrt(sum(e * e for e in errors) / 3), 6)
        plain = sum(moduli) / 3
        self.assertAlmostEqual(pooled["spread"], math.sqrt(sum((m - plain)**2 for m in moduli) / 2), 4)
        table = self.table("fit-hertz", *files)
        self.assertEqual(table["run"], [0, 1, 2])
        self.assertAlmostEqual(table["E_star"][2], 76, 4)

    def test_a_broken_run_does_not_stop_the_others(self):
        good = self.dump(dumps.hertz_bounce())
        broken = self.dir / "broken.dump"
        broken.write_text("ITEM: TIMESTEP\n", encoding="utf-8")
        result = self.mdana("fit-hertz", good, broken, "--json", code=1)
        self.assertIn("broken.dump", result.stderr)
        self.assertIn('"pooled_runs": 1', result.stdout)


class FitForce(Case):
    def test_hertz_is_found(self):
        dump = self.dump(dumps.hertz_bounce())
        document = self.document("fit-force", "--law", "hertz", "--radius", "5", dump)
        self.assertTrue(document["usable"])
        self.assertAlmostEqual(document["parameters"]["E*"]["value"], 60, 4)
        self.assertAlmostEqual(document["parameters"]["R"]["value"], 5, 5)
        offset = self.document("fit-force", "--law", "hertz", "--free", "E,offset", "--radius", "4.9", "--part", "loop",
                               dump)
        # At the radii 4.9, E* sqrt(R*) is that of R* = 2.5; delta is 0.2 too small.
        self.assertAlmostEqual(offset["parameters"]["E*"]["value"], 60 * (2.5 / 2.45)**0.5, 4)
        self.assertAlmostEqual(offset["parameters"]["offset"]["value"], 0.2, 5)
        table = self.table("fit-force", "--law", "hertz", "--radius", "5", dump)
        self.assertLess(max(abs(r) for r in table["residual"]), 1e-6 * max(table["F"]))

    def test_law_without_adhesion_in_the_data_says_so(self):
        dump = self.dump(dumps.hertz_bounce())
        document = self.document("fit-force", "--law", "jkr", "--radius", "5", dump, code=4)
        self.assertFalse(document["usable"])
        self.assertIn("gamma", document["reason"])

    def test_bad_requests_are_named(self):
        dump = self.dump(dumps.hertz_bounce())
        for arguments, says in ((["--law", "hooke"], ("hooke", "hertz")),
                                (["--law", "jkr", "--free", "E,,R"], ("--free",)),
                                (["--law", "jkr", "-p", "Y=3"], ("Y=3", "jkr")),
                                (["--law", "jkr", "-p", "gamma=x"], ("gamma=x", "number")),
                                (["--law", "jkr", "-p", "gamma=1", "--free", "gamma"], ("gamma",)),
                                ([], ("--law",))):
            with self.subTest(arguments):
                result = self.mdana("fit-force", *arguments, dump, code=2)
                for word in says:
                    self.assertIn(word, result.stderr)
        self.refused("fit-force", "--law", "hertz", "--free", "E,R,offset", dump, says=("R and offset",))


if __name__ == "__main__":
    running.main()
