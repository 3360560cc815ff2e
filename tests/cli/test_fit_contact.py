# SPDX-License-Identifier: GPL-3.0-or-later
"""fit-contact, compare-laws and emit on tables that `mdana predict` made, and on tables that are wrong."""

import json

import running
from running import SAMPLE, Case

MATERIAL = {"E": 65.5, "gamma": 3.17, "nu": 0.25}
RADII = {88.4: 3120599, 147: 14434147}
VELOCITIES = (0.1, 0.2, 0.3, 0.4)


def options(values):
    return [word for name, value in values.items() for word in ("-p", f"{name}={value!r}")]


class Contact(Case):
    def predicted(self, law, parameters, velocities=VELOCITIES):
        """(R, v, e, outcome) by `mdana predict`."""
        rows = []
        for radius, mass in RADII.items():
            for v in velocities:
                given = {"R": radius, "m": mass, "v": v} | parameters
                one = self.document("predict", "--law", law, "--tolerance", "1e-11", *options(given))
                rows.append((radius, v, one["e"], one["outcome"]))
        return rows

    def written(self, rows, head="R,v,e,sigma,outcome", name="runs.csv"):
        path = self.dir / name
        path.write_text("\n".join(["# synthetic", head, *(",".join(map(str, row)) for row in rows)]) + "\n")
        return path

    def study(self, law, parameters):
        return self.written([(R, v, e, 0.001, outcome) for R, v, e, outcome in self.predicted(law, parameters)])


class Found(Contact):
    def expect(self, document, truth):
        self.assertTrue(document["usable"], document["reason"])
        for name, value in truth.items():
            self.assertAlmostEqual(document["parameters"][name]["value"] / value, 1, delta=1e-6, msg=name)
            self.assertGreater(document["parameters"][name]["error"], 0)
        self.assertLess(document["chi2"], 1e-6)

    def test_krijt(self):
        path = self.study("krijt", MATERIAL | {"T_vis": 0.05})
        document = self.document("fit-contact", "--law", "krijt", path, "--table2", "-p", "E=65.5", "--starts", 2)
        self.expect(document, {"T_vis": 0.05})
        self.assertEqual(document["law"], "krijt")
        self.assertEqual(document["observations"], 8)
        self.assertEqual(document["inputs"][0]["format"], "table")
        for name in ("correlation", "singular_values", "weak_direction", "minima", "aic", "bic", "digits",
                     "collisions", "fit_seconds", "residual_pattern"):
            self.assertIn(name, document)

    def test_intervals_and_table(self):
        path = self.study("jkr", {"E": 65.5, "gamma": 3.17})
        arguments = ["fit-contact", "--law", "jkr", path, "--table2", "-p", "E=65.5", "--free", "gamma", "--starts", 1]
        document = self.document(*arguments, "--intervals", "--bootstrap", 20)
        found = document["parameters"]["gamma"]
        low, high = found["interval"]
        self.assertAlmostEqual(high - low, 2 * found["error"], delta=0.1 * found["error"])
        self.assertLessEqual(*found["bootstrap_interval"])
        table = self.table(*arguments)
        self.assertEqual(list(table), ["R", "v", "e", "sigma", "e_fit", "residual"])
        self.assert_close(table["e_fit"], table["e"], 1e-6, 1, "e_fit")

    def test_two_tables_and_columns(self):
        """Half of the collisions in another table, with m and E as columns."""
        rows = self.predicted("jkr", {"E": 65.5, "gamma": 3.17})
        first = self.written([(R, v, e, 0.001, RADII[R], 65.5) for R, v, e, _ in rows[:4]], "R,v,e,sigma,m,E", "a.csv")
        second = self.written([(e, 0.001, v, R, 65.5, RADII[R]) for R, v, e, _ in rows[4:]], "e,sigma,v,R,E,m", "b.csv")
        document = self.document("fit-contact", "--law", "jkr", first, second)
        self.expect(document, {"gamma": 3.17})
        self.assertEqual(document["observations"], 8)

    def test_andrews_in_si(self):
        rows = []
        for v in (1, 2, 5, 10, 20):
            given = {"R": 3e-6, "m": 4.5e-14, "E": 3e6, "Y": 1e5, "v": v}
            one = self.document("predict", "--law", "andrews", *options(given))
            rows.append((3e-6, v, 4.5e-14, one["delta_max"], one["delta_max"] / 100, one["t_max"], one["t_max"] / 100))
        path = self.written(rows, "R,v,m,delta_max,delta_max_error,t_max,t_max_error")
        self.expect(self.document("fit-contact", "--law", "andrews", path), {"E": 3e6, "Y": 1e5})

    def test_document_of_a_collision(self):
        """Results of mdana collision, as JSON and as HDF5 would have it, stand for a line of a table."""
        paths = []
        for k, (R, v, e, outcome) in enumerate(self.predicted("jkr", {"E": 65.5, "gamma": 3.17}, (0.2, 0.4))):
            paths.append(self.dir / f"run{k}.json")
            paths[-1].write_text(json.dumps({
                "command": "collision", "outcome": outcome, "radius_sum": {"value": 2 * R, "error": None},
                "speed_before": {"value": v, "error": 1e-6}, "e": {"value": e, "error": 0.001}}))
        document = self.document("fit-contact", "--law", "jkr", *paths, "--table2", "-p", "E=65.5", "--free", "gamma")
        self.expect(document, {"gamma": 3.17})
        self.assertEqual(document["inputs"][0]["format"], "collision")

    def test_document_with_masses_and_radii(self):
        """What the document says of the bodies needs no option; equal ones are R and m, unequal ones R1, R2, m1, m2."""
        paths = []
        for k, (R1, R2) in enumerate(((80, 80), (60, 120), (100, 100))):
            m1, m2 = 4.3633 * R1**3, 4.3633 * R2**3
            given = {"R1": R1, "R2": R2, "m1": m1, "m2": m2, "E": 65.5, "gamma": 3.17, "v": 0.3}
            one = self.document("predict", "--law", "jkr", *options(given))
            paths.append(self.dir / f"run{k}.json")
            both = lambda a, b: {"body1": {"value": a, "error": None}, "body2": {"value": b, "error": None}}
            paths[-1].write_text(json.dumps({
                "command": "collision", "outcome": one["outcome"], "radius_sum": {"value": R1 + R2, "error": None},
                "radius": both(R1, R2), "mass": both(m1, m2), "speed_before": {"value": 0.3, "error": 1e-6},
                "e": {"value": one["e"], "error": 0.001}}))
        self.expect(self.document("fit-contact", "--law", "jkr", *paths, "-p", "E=65.5", "--free", "gamma"),
                    {"gamma": 3.17})

    def test_hdf5(self):
        """The document in an HDF5 file is read; that of the sample has no speed before contact."""
        path = self.dir / "run.h5"
        self.mdana("collision", SAMPLE, "-o", path)
        self.refused("fit-contact", "--law", "jkr", path, says=["run.h5: speed_before is not known"])


class Singular(Contact):
    def refusal(self, path, *arguments):
        document = self.document("fit-contact", path, *arguments, code=4)
        self.assertFalse(document["usable"])
        return document["reason"]

    def test_gamma_and_modulus(self):
        rows = [(R, v, e, 0.001, RADII[R]) for R, v, e, _ in self.predicted("jkr", {"E": 65.5, "gamma": 3.17})]
        path = self.written(rows, "R,v,e,sigma,m")
        reason = self.refusal(path, "--law", "jkr", "--free", "gamma,E")
        self.assertIn("only gamma^5/E^2 is determined", reason)
        known = self.document("fit-contact", path, "--law", "jkr", "--free", "gamma,E", "--prior", "E=65.5+-2")
        self.assertAlmostEqual(known["parameters"]["E"]["error"], 2, delta=0.05)

    def test_all_stick(self):
        path = self.written([(88.4, 0.001, "", ""), (147, 0.001, 0, 0.01)], "R,v,e,sigma")
        self.assertIn("every collision sticks", self.refusal(path, "--law", "krijt", "--table2"))

    def test_one_velocity(self):
        rows = [(R, v, e, 0.01) for R, v, e, _ in self.predicted("power", {"E": 65.5, "gamma": 3.17, "D": 118, "alpha": 3, "beta": 1.5}, (0.2,))] * 3
        reason = self.refusal(self.written(rows, "R,v,e,sigma"), "--law", "power", "--table2", "--starts", 1)
        self.assertIn("all collisions have v = 0.2", reason)


class BadTables(Contact):
    def expect(self, rows, head, *says, arguments=("--law", "krijt", "--table2")):
        path = self.written(rows, head)
        self.refused("fit-contact", path, *arguments, says=says)

    def test_cells(self):
        good = (147, 0.2, 0.5, 0.01)
        head = "R,v,e,sigma"
        self.expect([good, (147, 0.2, "nan", 0.01)], head, "runs.csv:4", "e is nan: a finite number is expected")
        self.expect([good, (147, 0.2, "x", 0.01)], head, "runs.csv:4", "e is 'x': a number is expected")
        self.expect([good, (147, 0.2, -0.5, 0.01)], head, "runs.csv:4", "e is -0.5")
        self.expect([good, (147, 0.2, 1.5, 0.01)], head, "runs.csv:4", "more speed after the collision")
        self.expect([good, (147, 0.2, 0.5, 0)], head, "runs.csv:4", "a standard error is greater than 0")
        self.expect([good, (147, 0.2, 0.5, "")], head, "runs.csv:4", "give all or none", "runs.csv:3")
        self.expect([good, (147, "", 0.5, 0.1)], head, "runs.csv:4", "v is missing")
        self.expect([good, (147, 0.2)], head, "runs.csv:4", "2 cells (the line of names has 4)")
        self.expect([(40, 0.2, 0.5, 0.01)], head, "runs.csv:3", "R = 40 is not in Table II")
        self.expect([(147, 0.2, 0.5, "bounced")], "R,v,e,outcome", "outcome is 'bounced'")
        self.expect([(147, 0.2, 0.5, "stick")], "R,v,e,outcome", "outcome is stick, but e is 0.5")

    def test_heads(self):
        self.expect([(1, 2, 3)], "R,v,ee", "runs.csv:2", "unknown column 'ee'", "sigma")
        self.expect([(1, 2, 3)], "R,v,v", "runs.csv:2", "column 'v' stands twice")
        self.expect([(1, 2)], "R,e", "runs.csv:2", "column v (relative velocity at delta = 0) is missing")
        self.expect([(1, 2)], "R,v", "runs.csv:2", "nothing that was seen")
        self.expect([], "R,v,e", "no rows below the line with the names")

    def test_missing_constants(self):
        self.expect([(147, 0.2, 0.5)], "R,v,e", "runs.csv:3", "parameter m is missing", arguments=("--law", "krijt", "-p", "E=65.5"))

    def test_documents(self):
        path = self.dir / "run.json"
        path.write_text('{"command": "info"}')
        self.refused("fit-contact", "--law", "jkr", path, says=["run.json", "of 'mdana collision' or 'mdana compress' is expected"])
        path.write_text('{"command": ')
        self.refused("fit-contact", "--law", "jkr", path, says=["run.json", "not JSON"])

    def test_options(self):
        path = self.written([(147, 0.2, 0.5, 0.01)], "R,v,e,sigma")
        for arguments, says in ((["--law", "newton"], "one of"), (["--law", "hertz"], "nothing is free"),
                                (["--law", "krijt", "--bound", "T_vis=2:1"], "0 < LEAST < GREATEST"),
                                (["--law", "krijt", "--start", "C=1"], "not a free parameter"),
                                (["--law", "krijt", "--prior", "T_vis=1"], "NAME=VALUE+-ERROR"),
                                (["--law", "krijt", "--free", "T_vis", "-p", "T_vis=1"], "fixed by -p and free"),
                                (["--law", "krijt", "--bootstrap", 5], "--bootstrap")):
            self.refused("fit-contact", path, "--table2", *arguments, code=2, says=[says])


class Compared(Contact):
    def test_the_true_law_is_best(self):
        rows = self.predicted("viscous-hertz", {"E": 65.5, "nu": 0.25, "T_vis": 0.06})
        path = self.written([(R, v, e, 0.001, RADII[R]) for R, v, e, _ in rows], "R,v,e,sigma,m")
        document = self.document("compare-laws", path, "--starts", 1, "-p", "E=65.5", "-p", "nu=0.25")
        self.assertEqual(document["best"], "viscous-hertz")
        laws = {entry["law"]: entry for entry in document["laws"]}
        self.assertIn("thornton", laws)
        self.assertIn("hertz", laws)
        self.assertEqual(laws["hertz"]["k"], 0)
        self.assertIn("krijt", [entry["what"] for entry in document["left_out"]])  # gamma is not known
        self.assertGreater(laws["hertz"]["chi2"], laws["viscous-hertz"]["chi2"])
        self.assertGreater(laws["hertz"]["cross_validation"]["velocity"], 1)
        self.assertTrue(laws["hertz"]["fails"])


class Emitted(Contact):
    def fit(self):
        path = self.study("krijt", MATERIAL | {"T_vis": 0.05})
        fit = self.dir / "fit.json"
        self.mdana("fit-contact", "--law", "krijt", path, "--table2", "-p", "E=65.5", "--starts", 1, "--intervals",
                   "-o", fit)
        return fit

    def test_lines(self):
        fit = self.fit()
        lines = self.mdana("emit", "--for", "lammps", fit, "-p", "R=147", "-p", "m=14434147").stdout
        young = 2 * (1 - 0.25**2) * 65.5
        damping = 2 * 0.05 * 65.5 / (0.25**2 * 14434147 / 2)
        coefficients = next(line for line in lines.splitlines() if line.startswith("pair_coeff")).split()
        self.assertEqual(coefficients[:4], ["pair_coeff", "*", "*", "jkr"])
        for word, value in zip(coefficients[4:8], (young, damping, 3.17, 0.25)):
            self.assertAlmostEqual(float(word) / value, 1, delta=1e-6)
        self.assertIn("# T_vis = 0.05 (", lines)
        self.assertIn("# fitted for R from 88.4 to 147", lines)
        grains = self.mdana("emit", "--for", "liggghts", fit, "-p", "R=147", "-p", "m=14434147", "-p", "v=0.1").stdout
        self.assertIn("cohesionEnergyDensity peratomtypepair 1 ", grains)
        python = self.mdana("emit", "--for", "yade", fit, "-p", "R=147", "-p", "m=14434147").stdout
        compile(python, "yade", "exec")
        self.assertIn("gamma=3.17", python)

    def test_what_is_not_one_number(self):
        done = self.mdana("emit", "--for", "lammps", self.fit(), code=1)
        self.assertIn("choose one by -p m=VALUE", done.stderr)

    def test_an_unusable_fit(self):
        path = self.dir / "fit.json"
        path.write_text('{"command": "fit-contact", "law": "krijt", "parameters": {}, "usable": false, "reason": "no"}')
        self.assertIn("not usable", self.mdana("emit", "--for", "yade", path, code=1).stderr)
        path.write_text("[1]")
        self.mdana("emit", "--for", "yade", path, code=1)


if __name__ == "__main__":
    running.main()
