# SPDX-License-Identifier: GPL-3.0-or-later
"""fit-contact on motions delta(t), v(t), F(t) and straight from dumps: viscous Hertz spheres that scipy moved."""

import numpy as np
from scipy.integrate import solve_ivp

import dumps
import running
from running import Case

RADIUS, MASS = 5.0, 8.0  # of each body: eight atoms of mass 1
TRUTH = {"T_vis": 0.004, "E": 60.0}
NU = 0.25


def motion(speed, count=80, before=20, late=0.0):
    """t, delta, v, F of a collision, with free flight before and after: m* delta'' = -F, F = 4/3 E* sqrt(R*) delta^1.5 +
    2 T E*/nu^2 sqrt(R* delta) v while in contact. The first row in contact is that part of a step late."""
    reduced, mass = RADIUS / 2, MASS / 2

    def force(delta, v):
        a = np.sqrt(reduced * max(delta, 0.0))
        return 4 / 3 * TRUTH["E"] * a * max(delta, 0.0) + 2 * TRUTH["T_vis"] * TRUTH["E"] / NU**2 * a * v

    def apart(_, y):
        return y[0]

    apart.terminal, apart.direction = True, -1
    solution = solve_ivp(lambda _, y: (y[1], -force(*y) / mass), (0, 100), (1e-14, speed), method="DOP853", rtol=1e-13,
                         atol=1e-15, dense_output=True, events=apart)
    end = solution.t[-1]
    rows = []
    for t in (np.arange(count) - before + late) * end / (count - 2 * before):
        if t <= 0:
            rows.append((t, speed * t, speed, 0.0))
        elif t < end:
            delta, v = solution.sol(t)
            rows.append((t, delta, v, force(delta, v)))
        else:
            delta, v = solution.y[:, -1]
            rows.append((t, delta + v * (t - end), v, 0.0))
    return rows


class Moved(Case):
    def dump(self, speed, name="made.dump", noise=0.0):
        """`noise` is the standard deviation of the speeds of frames."""
        path = self.dir / name
        random = np.random.default_rng(1)
        frames = [dumps.two_cubes(k, t, 2 * RADIUS - delta, -v - noise * random.standard_normal(), F)
                  for k, (t, delta, v, F) in enumerate(motion(speed))]
        dumps.write(path, frames)
        return path

    def csv(self, rows, head="time,delta,v,F"):
        path = self.dir / "motion.csv"
        path.write_text("\n".join([head, *(",".join(repr(float(x)) for x in row) for row in rows)]) + "\n")
        return path

    def fit(self, *arguments, free="T_vis,E", code=0):
        return self.document("fit-contact", "--law", "viscous-hertz", "-p", f"nu={NU}", "--free", free, *arguments,
                             code=code)

    def expect(self, document, delta=1e-5):
        self.assertTrue(document["usable"], document["reason"])
        for name, found in document["parameters"].items():
            self.assertAlmostEqual(found["value"] / TRUTH[name], 1, delta=delta, msg=name)


class Motions(Moved):
    """To 1e-5, what frames of a motion by scipy at 1e-13 leave of the derivatives by differences."""

    def test_contact_between_two_rows(self):
        """The cubic through both knows nothing of where the force begins: it is off by some F h/m* of v."""
        self.expect(self.fit(self.csv(motion(0.5, late=0.4)), "-p", "R=5", "-p", "m=8"), delta=1e-3)

    def test_table(self):
        document = self.fit(self.csv(motion(0.5)), "-p", "R=5", "-p", "m=8")
        self.expect(document)
        self.assertEqual(document["inputs"][0]["format"], "motion")
        self.assertGreater(document["samples"], 40)
        self.assertGreaterEqual(document["residual_memory"], 1)

    def test_table_with_its_own_parameters_and_delta_only(self):
        rows = [(t, delta, RADIUS, MASS) for t, delta, _, _ in motion(0.5)]
        self.expect(self.fit(self.csv(rows, "t,delta,R,m")), delta=5e-3)  # v by four rows, two of them in free flight

    def test_dump(self):
        document = self.fit(self.dump(0.5), "--motion", "-p", "R=5")
        self.expect(document)
        self.assertEqual(document["inputs"][0]["format"], "lammps_text")

    def test_results_in_hdf5(self):
        path = self.dir / "run.h5"
        self.mdana("collision", self.dump(0.5), "--radius", "5", "-o", path)
        self.expect(self.fit(path, "--motion"))

    def test_two_motions_together(self):
        table = self.table("fit-contact", "--law", "viscous-hertz", "-p", f"nu={NU}", "-p", "R=5", "--free", "T_vis,E",
                           "--motion", self.dump(0.5, "a.dump"), self.dump(0.3, "b.dump"))
        self.assertEqual(list(table), ["run", "time", "delta", "delta_fit", "v", "v_fit", "F", "F_fit"])
        self.assertEqual(set(table["run"]), {0, 1})
        self.assert_close(table["F_fit"], table["F"], 1e-4, max(table["F"]), "F_fit")


class Dumps(Moved):
    def test_restitution_of_several_dumps(self):
        files = [self.dump(v, f"v{v}.dump", noise=1e-5) for v in (0.2, 0.5, 1.0)]
        document = self.fit(*files, "-p", "R=5", "-p", "E=60", free="T_vis")
        found = document["parameters"]["T_vis"]
        self.assertLess(abs(found["value"] - TRUTH["T_vis"]), 4 * found["error"])
        self.assertLess(found["error"], 1e-3 * TRUTH["T_vis"])  # e is a ratio of mean speeds in free flight
        self.assertEqual(document["observations"], 3)
        self.assertAlmostEqual(document["range"]["v"][0], 0.2, delta=1e-4)


class Refused(Moved):
    def refuse(self, rows, *says, head="time,delta,v,F"):
        self.refused("fit-contact", "--law", "hertz", "--free", "E", "-p", "R=5", "-p", "m=8", self.csv(rows, head),
                     says=says)

    def test_bad_motions(self):
        good = motion(0.5)
        self.refuse(good[40:], "motion.csv: the motion begins in contact")
        self.refuse(good[:30], "motion.csv: delta never falls again")
        self.refuse(good[:5] + good[4:], "time does not rise")
        self.refuse([(t, delta - 9, v, F) for t, delta, v, F in good], "delta never rises above 0")
        self.refuse([(t, float("nan"), v, F) for t, delta, v, F in good], "delta of row 1 is not a number")
        self.refuse([(*row, 0) for row in good], "a standard error is greater than 0", head="time,delta,v,F,delta_error")
        self.refuse([(*row, k) for k, row in enumerate(good)], "R is another than in the rows before",
                    head="time,delta,v,F,R")

    def test_a_document_has_no_motion(self):
        path = self.dir / "run.json"
        self.mdana("collision", self.dump(0.5), "--radius", "5", "-o", path)
        self.refused("fit-contact", "--law", "hertz", "--free", "E", "--motion", path, says=["run.json", "no motion"])

    def test_motions_and_collisions_do_not_mix(self):
        table = self.dir / "runs.csv"
        table.write_text("R,v,e,m\n5,0.5,0.9,8\n")
        self.refused("fit-contact", "--law", "hertz", "--free", "E", self.csv(motion(0.5)), table, "-p", "R=5", "-p", "m=8",
                     says=["fit them apart"])


if __name__ == "__main__":
    running.main()
