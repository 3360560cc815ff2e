#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdana collision` tells in one pass what the single commands tell."""

from dataclasses import replace

import dumps
import running
from running import SAMPLE


class Collision(running.Case):
    def test_numbers_are_those_of_the_single_commands(self):
        whole = self.document("collision", SAMPLE)
        force = self.document("force", SAMPLE)
        for name in ("outcome", "F_max", "F_min_loading", "delta_max", "hysteresis_area", "kinetic_loss", "cycles"):
            self.assertEqual(whole[name], force[name], name)
        contact = self.document("contact-radius", SAMPLE)
        self.assertEqual(whole["contact_radius"], contact["contact_radius"])
        reasons = {entry["what"] for entry in self.document("energy", SAMPLE)["left_out"]}
        self.assertLessEqual(reasons, {entry["what"] for entry in whole["left_out"]})
        self.assertEqual([w for w in whole["warnings"] if w not in contact["warnings"]], force["warnings"])

    def test_bodies_are_told(self):
        whole = self.document("collision", SAMPLE)
        # Two spheres of 603 atoms of mass 1, cut at radius 5 (the scene file).
        for body in ("body1", "body2"):
            self.assertEqual(whole["mass"][body]["value"], 603)
            self.assertEqual(whole["radius"][body]["value"], 5)

    def test_table_is_all_tables(self):
        whole = self.table("collision", SAMPLE)
        for command in ("force", "contact-radius", "energy"):
            for name, column in self.table(command, SAMPLE).items():
                if name not in ("a_hertz", "a_jkr"):  # which contact-radius lays beside
                    self.assertEqual(whole[name], column, f"{command}: {name}")

    def test_plastic_signs(self):
        plain = self.document("collision", SAMPLE)
        self.assertEqual(plain["p_c_max"], plain["p_c"]["hertz"])
        by_jkr = self.document("collision", SAMPLE, "--modulus", 60, "--surface-energy", 3.17)
        self.assertEqual(by_jkr["p_c_max"], by_jkr["p_c"]["jkr"])
        # Hertz: 2/pi sqrt(delta_max/R*) with R* = 2.5 of two spheres of radius 5.
        self.assertAlmostEqual(plain["p_c"]["hertz"]["value"],
                               2 / 3.141592653589793 * (plain["delta_max"]["value"] / 2.5) ** 0.5, 12)
        self.assertIn(plain["plastic"], ("no", "possible", "yes"))
        self.assertEqual(len(plain["plastic_reasons"]), 3)

    def test_late_steps_do_not_round_times(self):
        """From step 2^53 on a time in doubles would be right to 0.01 of these frames' distances."""
        frames = [replace(f, time=None) for f in dumps.spring_bounce()[0]]
        early = dumps.write(self.dir / "early.dump", frames)
        late = dumps.write(self.dir / "late.dump", [replace(f, step=f.step + 2**53) for f in frames])
        options = ("--bodies", "type", "--radius", 5, "--timestep", 0.0278)
        told = self.document("force", late, *options)
        self.assertTrue([w for w in told["warnings"] if "count from the first frame" in w], told["warnings"])
        self.assertEqual(told["F_max"], self.document("force", early, *options)["F_max"])
        times = self.table("force", late, *options)["time"]
        self.assertEqual(times[0], 0)
        self.assertAlmostEqual(times[5], 5 * 0.0278, 12)

    def test_without_velocities_the_rest_is_told(self):
        bare = self.dir / "bare.lammpstrj"
        self.mdana("convert", SAMPLE, "-o", bare, "--columns", "id,type,x,y,z")
        document = self.document("collision", bare, "--scene", SAMPLE.parent / "scene.toml")
        self.assertIn("energies", [entry["what"] for entry in document["left_out"]])
        self.assertEqual(document["force_source"], "positions")
        self.assertIn("gyration", document["contact_radius"])


if __name__ == "__main__":
    running.main()
