# SPDX-License-Identifier: GPL-3.0-or-later
"""fit-hertz on a generated R = 10 collision of random orientation against scipy's least squares on the same table."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import lammps
import running
from lammps import generate

try:
    from scipy.optimize import least_squares
except ImportError:
    running.skip("no scipy (Debian: apt install python3-scipy)")


def hertz(parameters, distance):
    modulus, radius = parameters
    return 4 / 3 * modulus * np.sqrt(radius / 2) * np.maximum(2 * radius - distance, 0)**1.5


class Oracle:
    """The fit as fits/hertz.hpp describes it: frames up to the greatest compression (or all) whose force is within two
    fractions of the greatest force, least squares in F or in F^(2/3)."""

    def __init__(self, distance, force, method="force", phase="loading", least=0.05, most=1.0):
        turn = np.argmin(distance)
        share = force / np.max(force)
        chosen = (share >= least) & (share <= most) & (force > 0)
        if phase == "loading":
            chosen[turn + 1:] = False
        self.frames = np.flatnonzero(chosen)
        x, f = distance[chosen], force[chosen]
        if len(x) < 3:
            self.found = None
            return
        power = 1.0 if method == "force" else 2 / 3

        def residuals(parameters):
            if method == "force":
                return hertz(parameters, x) - f
            modulus, radius = parameters  # a straight line, also where it is below zero
            return (4 / 3 * modulus * np.sqrt(radius / 2))**(2 / 3) * (2 * radius - x) - f**power

        scale = np.max(f**power)
        slope, intercept = np.polyfit(x, f**(2 / 3), 1)
        radius = -intercept / slope / 2
        start = [0.75 * (-slope)**1.5 / np.sqrt(radius / 2), radius]
        solution = least_squares(lambda p: residuals(p) / scale, start, x_scale=start, jac="3-point",
                                 xtol=1e-15, ftol=1e-15, gtol=1e-15, max_nfev=2000)
        self.found = solution.x
        variance = np.sum(solution.fun**2) / (len(x) - 2)
        covariance = variance * np.linalg.inv(solution.jac.T @ solution.jac)
        self.errors = np.sqrt(np.diag(covariance))
        self.correlation = covariance[0, 1] / np.prod(self.errors)


class HertzFit(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        cls.dir = Path(scratch.name)
        cls.dump = cls.dir / "run" / "dump.lammpstrj.gz"
        # The turn is at 8.3 tau; what comes after 12 is not needed.
        generate("hertz", "--preset", "small", "--velocity", "0.3", "--duration", "12", "--ranks", lammps.ranks(),
                 "-o", cls.dump.parent)
        table = cls.dir / "table.csv"
        cls.run_mdana("force", cls.dump, "-o", table)
        columns = running.read_csv(table)
        cls.distance, cls.force = np.array(columns["X"]), np.array(columns["F"])

    @staticmethod
    def run_mdana(*arguments):
        done = running.run(*arguments)
        if done.returncode:
            raise AssertionError(done.stderr)
        return done.stdout

    def compare(self, **settings):
        """E* within 0.1 %, R within 1e-3, as the issue asks; both codes solve the same problem to far more digits, so
        1e-6 is asked for besides, which is the step of two solvers that stop at 15 digits of a sum of squares times
        the condition of the problem."""
        options = {"method": "--method", "phase": "--phase",
                   "least": "--min-force-fraction", "most": "--max-force-fraction"}
        arguments = [str(word) for name, setting in settings.items() for word in (options[name], setting)]
        points = self.dir / "points.csv"
        document = running.parse_json(self.run_mdana("fit-hertz", self.dump, "--json", "-o", points, *arguments))
        oracle = Oracle(self.distance, self.force, **settings)
        modulus, radius = oracle.found
        print(f"{settings}: E* {modulus:.6g}, R {radius:.6g} by scipy; {document['E_star']['value']:.6g}, "
              f"{document['R']['value']:.6g} by mdana")
        self.assertAlmostEqual(document["E_star"]["value"] / modulus, 1, delta=1e-6)
        self.assertAlmostEqual(document["R"]["value"] / radius, 1, delta=1e-6)
        # The covariance depends on a numerical Jacobian here; 1 % is what anyone reads off a standard error.
        for name, error in zip(("E_star", "R"), oracle.errors):
            self.assertAlmostEqual(document[name]["standard_error"] / error, 1, delta=0.01, msg=name)
        self.assertAlmostEqual(document["correlation"], oracle.correlation, delta=0.01)
        self.assertEqual(document["points"], len(oracle.frames))
        return document, oracle, running.read_csv(points)

    def test_defaults(self):
        document, oracle, points = self.compare()
        self.assertTrue(document["usable"])
        self.assertEqual(points["frame"], list(oracle.frames))
        self.assertEqual(points["X"], list(self.distance[oracle.frames]))
        self.assertEqual(points["F"], list(self.force[oracle.frames]))
        scale = max(self.force)
        model = hertz((document["E_star"]["value"], document["R"]["value"]), np.array(points["X"]))
        # The same formula with the same numbers: rounding, multiplied by X/(2R - X) of some hundred.
        np.testing.assert_allclose(points["F_fit"], model, rtol=0, atol=1e-11 * scale)
        residual = np.array(points["F"]) - model
        np.testing.assert_allclose(points["residual"], residual, rtol=0, atol=1e-11 * scale)
        self.assertAlmostEqual(document["rms_residual"], np.sqrt(np.mean(residual**2)) / scale, delta=1e-11)

    def test_methods_ranges_phases(self):
        for settings in (
            {"method": "linear"}, {"method": "linear", "phase": "all"}, {"phase": "all"},
            {"least": 0.2, "most": 0.8}, {"method": "linear", "least": 0.1, "most": 0.5}, {"least": 0.02},
        ):
            with self.subTest(settings):
                self.compare(**settings)

    def test_spread(self):
        """The spread is that of 48 fits: two methods, two phases, four least and three greatest fractions."""
        document, chosen, _ = self.compare()
        variants = [
            oracle.found
            for method in ("force", "linear") for phase in ("loading", "all")
            for least in (0.02, 0.05, 0.1, 0.2) for most in (0.5, 0.75, 1.0)
            if (oracle := Oracle(self.distance, self.force, method, phase, least, most)).found is not None]
        for k, name in enumerate(("E_star", "R")):
            values = np.array([found[k] for found in variants])
            spread = document[name]["spread"]
            self.assertEqual(spread["variants"], len(values))
            deviation = np.sqrt(np.mean((values - chosen.found[k])**2))
            print(f"{name}: {min(values):.6g} to {max(values):.6g}, deviation {deviation:.3g}")
            self.assertAlmostEqual(spread["min"] / min(values), 1, delta=1e-5)
            self.assertAlmostEqual(spread["max"] / max(values), 1, delta=1e-5)
            self.assertAlmostEqual(spread["deviation"] / deviation, 1, delta=1e-4)
            self.assertEqual(document[name]["error"], max(spread["deviation"], document[name]["standard_error"]))

    def test_physics(self):
        """R of the soft 1/r^12 contact is 0.3 to 0.5 above the cut radius, here 10 (Yoshida, Kokubo & Tanaka 2024, Table
        II: 29.6 for 29.2), and 0.2 more is allowed for so small a sphere. E* is 53 to 60 in random orientation at
        R = 29, and at R = 10 known within a factor of two."""
        document, *_ = self.compare()
        self.assertGreater(document["R"]["value"], 10.1)
        self.assertLess(document["R"]["value"], 10.7)
        self.assertGreater(document["E_star"]["value"], 25)
        self.assertLess(document["E_star"]["value"], 120)


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
