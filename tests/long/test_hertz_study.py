#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A real study for fit-hertz: spheres of radii 8 and 10, three orientations each, made by LAMMPS, pooled by size.

With MDANA_LONG_RUNS=DIR the runs are kept in DIR, and taken from there if they are there."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "oracles"))

import numpy as np

import lammps
import running

SIZES = {8: (1, 2, 3), 10: (1, 2, 3)}


class HertzStudy(running.Case):
    @classmethod
    def setUpClass(cls):
        folder = lammps.kept_runs(cls)
        cls.dumps = []
        for radius, seeds in SIZES.items():
            for seed in seeds:
                run = folder / f"hertz_r{radius}_s{seed}"
                if not (run / "scene.toml").is_file():
                    lammps.generate("hertz", "--radius", radius, "--velocity", "0.3", "--seed", seed, "--ranks",
                                    lammps.ranks(), "-o", run, timeout=3600)
                cls.dumps.append(run / "dump.lammpstrj.gz")
        done = running.run("fit-hertz", *cls.dumps, "--json", timeout=300)
        if done.returncode:
            raise AssertionError(done.stderr)
        cls.document = running.parse_json(done.stdout)

    def test_each_run_is_usable_and_touches_beyond_its_cut_radius(self):
        """R is known to 0.05 (and the radius at which the repulsion sets in is about 0.43 more than that of the cut)."""
        for run, radius in zip(self.document["runs"], [r for r, seeds in SIZES.items() for _ in seeds]):
            self.assertTrue(run["usable"])
            self.assertLess(abs(run["R"]["value"] - radius - 0.43), 0.2)
            self.assertGreater(run["E_star"]["error"], run["E_star"]["standard_error"] * 0.999)

    def test_sizes_are_pooled(self):
        """By random effects (DerSimonian & Laird 1986), computed here from the runs."""
        sizes = self.document["sizes"]
        self.assertEqual([s["runs"] for s in sizes], [3, 3])
        for size, runs in zip(sizes, (self.document["runs"][:3], self.document["runs"][3:])):
            for name in ("E_star", "R"):
                x = np.array([run[name]["value"] for run in runs])
                w = np.array([run[name]["error"] for run in runs])**-2.0
                q = np.sum(w * (x - np.sum(w * x) / np.sum(w))**2)
                between = max(0.0, (q - 2) / (np.sum(w) - np.sum(w * w) / np.sum(w)))
                w = 1 / (1 / w + between)
                self.assertAlmostEqual(size[name]["value"], np.sum(w * x) / np.sum(w), delta=1e-9 * abs(x[0]))
                self.assertAlmostEqual(size[name]["error"], np.sum(w)**-0.5, delta=1e-9 * abs(x[0]))
                self.assertAlmostEqual(size[name]["between"], between**0.5, delta=1e-7 * abs(x[0]))
                print(f"N = {size['N']:.0f}: {name} = {size[name]['value']:.4g} +- {size[name]['error']:.2g}, between runs "
                      f"{size[name]['between']:.2g}")

    def test_orientation_matters_as_it_should(self):
        """E* of orientations differs by up to a factor two at R = 10; R by far less."""
        for runs in (self.document["runs"][:3], self.document["runs"][3:]):
            moduli = [run["E_star"]["value"] for run in runs]
            self.assertLess(max(moduli), 3 * min(moduli))
            radii = [run["R"]["value"] for run in runs]
            self.assertLess(max(radii) - min(radii), 0.2)

    def test_table_of_sizes(self):
        table = self.table("fit-hertz", *self.dumps, "--rows", "size")
        self.assertEqual(list(table), ["N", "runs", "R", "R_error", "R_between", "E_star", "E_star_error", "E_star_between"])
        self.assertEqual(table["N"], [size["N"] for size in self.document["sizes"]])
        self.assertEqual(table["E_star"], [size["E_star"]["value"] for size in self.document["sizes"]])


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
