# SPDX-License-Identifier: GPL-3.0-or-later
"""mdana compress on made-up aggregates that move on Andrews' law, integrated here, and on a real small collision."""

import json
import math
import random

import dumps
import running
from running import ROOT, Case

SAMPLE = ROOT / "sample-data" / "aggregate-tiny" / "dump.lammpstrj.gz"
MODULUS, STRENGTH, DENSITY, RADIUS = 1.0, 0.2, 7e-4, 20.0  # v_Y = 0.53, where delta_Y = 0.99
VELOCITIES = (0.3, 0.5, 0.8, 1.2, 2.0)


class Aggregates(Case):
    def collide(self, name, velocity, radius=RADIUS, offset=0.0, modulus=MODULUS, strength=STRENGTH, density=DENSITY,
                frames=150, after=1.0, before=8, **settings):
        """A dump of aggregates of density `density` in radius R_agg that touch at R_eff = R_agg - offset, as P2 has them;
        about `frames` frames up to delta_max, `after` times as many behind it."""
        effective = radius - offset
        reduced = effective / 2
        mass = 16 * math.pi / 3 * density * reduced**3
        elastic = 1.4716 * (5 * math.pi * density * velocity**2 / modulus)**0.4 * reduced / velocity
        plastic = 2 * math.pi * reduced * math.sqrt(density / 3 / strength)
        dt = max(elastic, plastic) / frames
        path = dumps.andrews_path(modulus, strength, reduced, mass, velocity, dt, before,
                                  round(before + (1 + after) * frames * 1.6))
        path = [(delta + 2 * offset, v) for delta, v in path]
        return dumps.write(self.dir / f"{name}.dump",
                           dumps.rigid_aggregates(path, dt, radius, settings.pop("grains", 10),
                                                  4 * math.pi / 3 * density * radius**3, **settings))

    def expect(self, document, modulus=MODULUS, strength=STRENGTH, digits=6):
        self.assertTrue(document["usable"], document["reason"])
        self.assertAlmostEqual(document["E_star"]["value"] / modulus, 1, delta=10**-digits)
        self.assertAlmostEqual(document["Y"]["value"] / strength, 1, delta=10**-digits)


class OneRun(Aggregates):
    def test_elastic(self):
        """t_max = 1.471637592 delta_max/v (32), delta_max by (30), e = 1."""
        one = self.document("compress", self.collide("elastic", 0.4, strength=1e3), "--radius", RADIUS)
        delta = (5 * math.pi * DENSITY * 0.4**2 / MODULUS)**0.4 * RADIUS / 2
        self.assertAlmostEqual(one["delta_max"]["value"] / delta, 1, delta=1e-7)
        self.assertAlmostEqual(one["delta_max_over_R"]["value"] * RADIUS / delta, 1, delta=1e-7)
        self.assertAlmostEqual(one["t_max"]["value"] * 0.4 / delta / 1.471637592, 1, delta=1e-6)
        self.assertLess(abs(one["t_max"]["value"] - 1.471637592 * delta / 0.4), one["t_max"]["error"] + 1e-9)
        self.assertAlmostEqual(one["E_star_if_elastic"]["value"], MODULUS, delta=1e-6)
        self.assertEqual(one["outcome"], "bounce")
        self.assertAlmostEqual(one["e"]["value"], 1, delta=1e-6)
        self.assertAlmostEqual(one["speed_before"]["value"], 0.4, delta=1e-12)
        self.assertAlmostEqual(one["rho"]["value"] / DENSITY, 1, delta=1e-12)
        self.assertEqual(one["split"], "sign")
        self.assertIsNone(one["coordination"])

    def test_sticking(self):
        """delta = d + exp(-g t)(b sin t - d cos t) after the touch: a damped oscillation, whose turns are 2 pi apart."""
        d, g, v, dt = 0.5, 0.05, 0.5, 0.05
        b = v - g * d
        times = [0.3 * dt + k * dt for k in range(-40, 400)]
        path = [(v * t, v) if t < 0 else
                (d + math.exp(-g * t) * (b * math.sin(t) - d * math.cos(t)),
                 math.exp(-g * t) * ((b + g * d) * math.cos(t) + (d - g * b) * math.sin(t))) for t in times]
        dump = dumps.write(self.dir / "stick.dump", dumps.rigid_aggregates(path, dt, RADIUS, 6, 20.0))
        one = self.document("compress", dump, "--radius", RADIUS)
        turn = math.pi - math.atan((b + g * d) / (d - g * b))  # tan t = -(b + g d)/(d - g b)
        top = d + math.exp(-g * turn) * (b * math.sin(turn) - d * math.cos(turn))
        self.assertEqual(one["outcome"], "stick")
        self.assertEqual(one["e"]["value"], 0)
        self.assertAlmostEqual(one["t_max"]["value"], turn, delta=2e-5)
        self.assertAlmostEqual(one["delta_max"]["value"], top, delta=1e-6)
        period = one["return"]["oscillation_period"]
        self.assertLessEqual(abs(period["value"] - 2 * math.pi), period["error"])
        study = self.document("compress", dump, dump, "--radius", RADIUS)
        self.assertEqual(study["summary"]["stick"], 2)
        self.assertEqual(study["conditions"][0]["sticking_probability"]["value"], 1)

    def test_pairs_hold_the_true_one(self):
        """On the line of pairs E*, Y lies the true one, between two neighbours; 0.4 % is the curvature of the line there."""
        one = self.document("compress", self.collide("v", 1.2), "--radius", RADIUS)
        pairs = list(zip(one["degeneracy"]["E_star"][:-1], one["degeneracy"]["Y"][:-1]))
        below, above = next((a, b) for a, b in zip(pairs, pairs[1:]) if a[0] <= MODULUS < b[0])
        part = math.log(MODULUS / below[0]) / math.log(above[0] / below[0])
        self.assertAlmostEqual(below[1] * (above[1] / below[1])**part, STRENGTH, delta=4e-3 * STRENGTH)
        self.assertIsNone(one["degeneracy"]["E_star"][-1])
        self.assertEqual(one["degeneracy"]["Y"][-1], one["Y_if_rigid_plastic"]["value"])

    def test_both_splits_and_the_table(self):
        """Grains that reach to 0.8 R never cross the plane: both splits are the same to rounding."""
        path = self.collide("v", 1.2, frames=40)
        for split in ("sign", "membership"):
            table = self.table("compress", path, "--radius", RADIUS, "--split", split)
            self.assertEqual(list(table)[:4], ["step", "time", "delta", "v_rel"])
            self.assertEqual(table["delta"], table[f"delta_{split}"])
            self.assertEqual(table["v_rel"], table[f"v_rel_{split}"])
            self.assert_close(table["delta_sign"], table["delta_membership"], 1e-13, 2 * RADIUS)
            self.assert_close(table["v_rel_sign"], table["v_rel_membership"], 1e-13, 1.2)
            self.assertEqual(set(table["half_atoms1"]), {10.0})

    def test_crossed_grains(self):
        """Of mirror images N grains each, k of them deeper than the plane by h: the splits differ by 2/N times the sum
        of h, at most 2 k/N of the deepest, which is delta_max/2."""
        path = self.collide("v", 1.2, frames=40, reach=1.0, grains=200)
        table = self.table("compress", path, "--radius", RADIUS)
        places = [frame["x y z"] @ dumps.DIRECTION for frame in dumps.read(path)]
        for k, along in enumerate(places):
            crossed = [h for h in along[:200] if h > 0] + [-h for h in along[200:] if h < 0]
            differ = table["delta_membership"][k] - table["delta_sign"][k]
            self.assertAlmostEqual(differ, 2 / 200 * sum(crossed), delta=1e-11)
        one = self.document("compress", path, "--radius", RADIUS)
        a, b = (one[f"by_{split}"]["delta_max"]["value"] for split in ("sign", "membership"))
        deepest = max(table["delta"]) / 2
        self.assertGreater(b, a)
        self.assertLess(b - a, 2 * 2 * 20 / 200 * deepest)

    def test_without_velocities(self):
        """v_rel is the derivative of X then: five-point formulas at 60 frames up to delta_max."""
        bare = self.dir / "bare.dump"
        self.mdana("convert", self.collide("v", 1.2, frames=60), "-o", bare, "--columns", "id,type,mass,x,y,z")
        with_v = self.document("compress", self.dir / "v.dump", "--radius", RADIUS)
        without = self.document("compress", bare, "--radius", RADIUS)
        for name, tolerance in (("delta_max", 1e-5), ("t_max", 1e-3)):
            self.assertAlmostEqual(without[name]["value"] / with_v[name]["value"], 1, delta=tolerance)

    def test_units(self):
        """The same collision in other units: every number by its dimension. Rounding of numbers that are no powers of
        two is amplified by the turn, where a relative 1e-16 of delta is 1e-8 of t_max."""
        plain = self.document("compress", self.collide("lj", 1.2, frames=40), "--radius", RADIUS)
        for units, (mass, length, time) in {"si": (1e-19, 1e-7, 1e-8), "nano": (100.0, 100.0, 10.0)}.items():
            path = self.collide(units, 1.2, frames=40, scale=(mass, length, time), units=units)
            other = self.document("compress", path, "--radius", repr(RADIUS * length))
            self.assertEqual(other["units"], units)
            for name, factor in {"delta_max": length, "t_max": time, "speed_before": length / time, "delta_max_over_R": 1,
                                 "m_star": mass, "rho": mass / length**3, "e": 1, "R_eff": length,
                                 "E_star_if_elastic": mass / length / time**2,
                                 "Y_if_rigid_plastic": mass / length / time**2}.items():
                self.assertAlmostEqual(other[name]["value"] / plain[name]["value"] / factor, 1, delta=1e-7, msg=name)

    def test_real_collision(self):
        one = self.document("compress", SAMPLE)
        self.assertEqual(one["units"], "nano")
        self.assertAlmostEqual(one["speed_before"]["value"], 20, delta=0.1)
        self.assertIn("-0.397", one["return"]["note"])
        self.assertLess(abs(one["by_sign"]["delta_max"]["value"] / one["by_membership"]["delta_max"]["value"] - 1), 0.02)
        self.assertAlmostEqual(one["rho"]["value"], 0.4 * 0.001, delta=1e-6)
        self.assertEqual(one["phi"]["value"], 0.4)
        # 12 phi/phi_max (39) is of grains inside; those at the surface have fewer contacts.
        self.assertLess(one["coordination"]["value"], 12 * 0.4 / (math.pi / math.sqrt(18)))
        self.assertGreater(one["coordination"]["value"], 3)


class Study(Aggregates):
    def documents(self, paths, *options):
        """The runs one by one, as JSON files."""
        files = []
        for path in paths:
            files.append(path.with_suffix(".json"))
            self.mdana("compress", path, "--radius", RADIUS, *options, "-o", files[-1])
        return files

    def test_modulus_and_strength_to_six_digits(self):
        paths = [self.collide(f"v{k}", v) for k, v in enumerate(VELOCITIES)]
        for split in ("sign", "membership"):
            study = self.document("compress", *paths, "--radius", RADIUS, "--split", split)
            self.expect(study)
            self.assertAlmostEqual(study["with_counted_mass"]["E_star"]["value"], study["E_star"]["value"], delta=1e-12)
        self.assertEqual(study["summary"]["bounce"], 5)
        self.assertEqual([c["runs"] for c in study["conditions"]], [1] * 5)
        self.assertNotIn("degeneracy", study)
        table = self.table("compress", *paths, "--radius", RADIUS)
        self.assert_close(table["delta_max_fit"], table["delta_max"], 1e-7, 1)
        for v, elastic, plastic, time in zip(table["v"], table["delta_max_elastic"], table["delta_max_rigid_plastic"],
                                             table["t_max_rigid_plastic"]):
            self.assertAlmostEqual(elastic, (5 * math.pi * DENSITY * v**2)**0.4 * RADIUS / 2, delta=1e-5)
            self.assertAlmostEqual(plastic, 4 * v * math.sqrt(DENSITY / 3 / STRENGTH) * RADIUS / 2, delta=1e-5)
            self.assertAlmostEqual(time, 2 * math.pi * RADIUS / 2 * math.sqrt(DENSITY / 3 / STRENGTH), delta=1e-5)
        # fit-contact on the documents is the same fit; of collision's documents it takes delta_max and t_max too.
        fit = self.document("fit-contact", "--law", "andrews", *self.documents(paths))
        self.assertEqual(fit["inputs"][0]["format"], "compress")
        self.assertAlmostEqual(fit["parameters"]["E"]["value"], study["E_star"]["value"], delta=1e-6)
        whole = self.dir / "study.h5"
        self.mdana("compress", *paths, "--radius", RADIUS, "-o", whole)
        fit = self.document("fit-contact", "--law", "andrews", whole)
        self.assertAlmostEqual(fit["parameters"]["Y"]["value"] / STRENGTH, 1, delta=1e-6)
        collisions = []
        for path in paths:
            collisions.append(path.with_suffix(".collision.json"))
            self.mdana("collision", path, "--radius", RADIUS, "-o", collisions[-1])
        fit = self.document("fit-contact", "--law", "andrews", *collisions)
        self.assertAlmostEqual(fit["parameters"]["Y"]["value"] / STRENGTH, 1, delta=1e-4)
        self.mdana("collision", paths[0], "-o", collisions[0])
        self.refused("fit-contact", "--law", "andrews", *collisions, says=["radii of gyration", "--radius"])

    def test_offset(self):
        """delta_max from 2 R_agg lies on a line; its offset, and E* and Y from there, are exact."""
        offset = 0.75
        paths = [self.collide(f"R{radius}", 1.2, radius=radius, offset=offset) for radius in (16.0, 20.0, 30.0)]
        paths += [self.collide(f"v{k}", v, offset=offset) for k, v in enumerate((0.3, 0.6, 2.0))]
        for path, radius in zip(paths, (16, 20, 30, 20, 20, 20)):
            folder = self.dir / path.stem
            folder.mkdir()
            path.rename(folder / "dump")
            (folder / "scene.toml").write_text(f'schema = 1\ndump = "dump"\nunits = "lj"\n[[body]]\nradius = {radius}\n'
                                               f'[[body]]\nradius = {radius}\n')
        paths = [self.dir / path.stem / "dump" for path in paths]
        study = self.document("compress", *paths)
        self.assertEqual(len(study["radius_lines"]), 1)
        self.assertAlmostEqual(study["offset"]["value"], offset, delta=1e-6)
        self.assertAlmostEqual(study["radius_lines"][0]["slope"]["value"],
                               study["conditions"][0]["delta_max_over_R_eff"]["value"], delta=1e-6)
        self.expect(study, digits=5)
        given = self.document("compress", *paths, "--offset", offset)
        self.expect(given)
        one = self.document("compress", paths[0], "--offset", offset)
        self.assertEqual(one["R_eff"]["value"], 16 - offset)
        self.assertAlmostEqual(one["delta_max"]["value"] - one["delta_max_eff"]["value"], 2 * offset, delta=1e-12)
        self.assertAlmostEqual(one["m_star"]["value"] / one["m_star_counted"]["value"], (1 - offset / 16)**3, delta=1e-12)

    def test_noise_lies_within_errors(self):
        """E* and Y scatter by 3 % from run to run; three repeats at each velocity. Of twelve draws of the study the
        true E* and Y lie within two standard errors at least eleven times (95 % each, p = 0.88 for all but one or none);
        the draws are fixed, so this is no lottery."""
        dice = random.Random(7)
        inside = 0
        for draw in range(6):
            paths = [self.collide(f"d{draw}v{k}r{r}", v, frames=30, after=0.4, grains=4,
                                  modulus=MODULUS * math.exp(dice.gauss(0, 0.03)),
                                  strength=STRENGTH * math.exp(dice.gauss(0, 0.03)))
                     for k, v in enumerate((0.3, 0.8, 2.0)) for r in range(3)]
            study = self.document("compress", *paths, "--radius", RADIUS)
            self.assertTrue(study["usable"], study["reason"])
            for name, truth in (("E_star", MODULUS), ("Y", STRENGTH)):
                off = abs(study[name]["value"] - truth) / study[name]["error"]
                inside += off < 2
                self.assertLess(off, 4, name)
                self.assertLess(study[name]["error"], 0.1 * truth)
        self.assertGreaterEqual(inside, 11)

    def test_one_velocity(self):
        """Repeats at one velocity: dispersion, the line of pairs, and no E*, Y."""
        paths = [self.collide(f"r{r}", 1.2, frames=40, strength=STRENGTH * (1 + 0.02 * r)) for r in range(3)]
        study = self.document("compress", *paths, "--radius", RADIUS)
        self.assertFalse(study["usable"])
        self.assertIn("one velocity does not determine 2 parameters", study["reason"])
        self.assertIn("is known", study["reason"])  # the weak direction
        self.assertIsNone(study["E_star"])
        self.assertEqual(len(study["degeneracy"]["Y"]), len(study["degeneracy"]["E_star"]))
        self.assertEqual(study["conditions"][0]["runs"], 3)
        self.assertGreater(study["conditions"][0]["delta_max_over_R_eff"]["spread"], 0)
        self.assertAlmostEqual(study["summary"]["sticking_probability"]["high"], 0.5615, delta=1e-4)  # Wilson, 0 of 3
        self.mdana("fit-contact", "--law", "andrews", *self.documents(paths), code=4)

    def test_below_yield(self):
        """Elastic collisions say nothing of Y."""
        paths = [self.collide(f"v{k}", v, frames=60, strength=10) for k, v in enumerate((0.3, 0.8, 2.0))]
        study = self.document("compress", *paths, "--radius", RADIUS, code=4)
        self.assertFalse(study["usable"])
        self.assertIn("the elastic limit (Y infinite) describes the collisions as well", study["reason"])
        self.assertIn("Y is known", study["reason"])  # the weak direction
        self.assertAlmostEqual(study["elastic_limit"]["E_star"]["value"], MODULUS, delta=1e-5)
        self.assertIsNone(study["Y"])

    def test_rigid_plastic(self):
        """Far beyond yield delta_max goes with v and t_max does not: of Y that scatters by 1 % nothing is known of E*,
        but Y is (31, 33)."""
        paths = [self.collide(f"v{k}", v, frames=60, modulus=10, strength=0.05 * (1 + 0.01 * (-1)**k))
                 for k, v in enumerate((0.3, 0.6, 1.2, 2.4))]
        study = self.document("compress", *paths, "--radius", RADIUS, code=4)
        self.assertIn("the rigid plastic limit (E infinite) describes the collisions as well", study["reason"])
        found = study["rigid_plastic_limit"]["Y"]
        self.assertAlmostEqual(found["value"] / 0.05, 1, delta=0.01)
        self.assertLess(abs(found["value"] - 0.05), 2 * found["error"])

    def test_densities_that_differ(self):
        paths = [self.collide("a", 0.4, frames=40), self.collide("b", 1.2, frames=40, density=2 * DENSITY)]
        study = self.document("compress", *paths, "--radius", RADIUS)
        self.assertIn("filling factor", json.dumps(study["left_out"]))


class Refused(Aggregates):
    def test_dump_that_ends_too_early(self):
        one = self.document("compress", self.collide("early", 1.2, frames=40, after=-0.5), "--radius", RADIUS)
        self.assertIsNone(one["delta_max"]["value"])
        self.assertIsNone(one["t_max"]["value"])
        self.assertEqual(one["outcome"], "unresolved")
        self.assertIn("the dump ends before", json.dumps(one["left_out"]))
        self.assertIn("no delta_max", json.dumps(one["warnings"]))

    def test_dump_that_begins_in_contact(self):
        path = self.collide("late", 1.2, frames=40)
        one = self.document("compress", path, "--radius", RADIUS, "--frames", "20:")
        self.assertIsNone(one["t_max"]["value"])
        self.assertGreater(one["delta_max"]["value"], 0)
        self.assertIn("begins in contact", json.dumps(one["left_out"]))

    def test_no_contact(self):
        path = self.collide("apart", 1.2, frames=40)
        self.refused("compress", path, "--radius", RADIUS, "--frames", ":6", says=["no contact in this dump"])

    def test_radius_that_is_too_small(self):
        """The aggregates bounce, but never at X < 2 R."""
        one = self.document("compress", self.collide("small", 1.2, frames=40), "--radius", 10)
        self.assertIsNone(one["delta_max"]["value"])
        self.assertIn("radius or offset do not fit", json.dumps(one["left_out"]))

    def test_one_body(self):
        path = self.collide("one", 1.2, frames=20)
        self.refused("compress", path, "--bodies", "id:1-20", "--radius", RADIUS, says=["body 2 has no atoms"])

    def test_nan(self):
        frames = dumps.read(self.collide("nan", 1.2, frames=20))
        frames[5].atoms[3, 4] = math.nan
        path = dumps.write(self.dir / "nan.dump", frames)
        self.refused("compress", path, "--radius", RADIUS, says=["not finite", "step 5"])
        frames[5].atoms[3, 4], frames[-1].atoms[3, 4] = 0, math.nan
        path = dumps.write(self.dir / "nan.dump", frames)
        late = self.document("compress", path, "--radius", RADIUS, code=3)
        self.assertGreater(late["delta_max"]["value"], 0)
        self.refused("compress", path, "--radius", RADIUS, "--strict", says=["not finite"])

    def test_no_times(self):
        frames = dumps.read(self.collide("timeless", 1.2, frames=20))
        for frame in frames:
            frame.time = None
        path = dumps.write(self.dir / "timeless.dump", frames)
        self.refused("compress", path, "--radius", RADIUS, says=["--timestep"])

    def test_too_few_frames_for_a_derivative(self):
        """With forces four frames tell the outcome of nothing, but are no error."""
        frames = [dumps.two_cubes(k, 0.5 * k, 10.3 - d, 0, 10 * d).without("vx", "vy", "vz")
                  for k, d in enumerate((0.0, 0.5, 0.6, 0.5))]
        path = dumps.write(self.dir / "few.dump", frames)
        one = self.document("compress", path, "--radius", 5)
        self.assertIsNone(one["delta_max"]["value"])
        self.assertIn("frames are too few", json.dumps(one["left_out"]))
        self.assertIn("delta", self.table("compress", path, "--radius", 5))

    def test_a_run_that_fails_does_not_stop_the_others(self):
        good = self.collide("good", 1.2, frames=40)
        done = self.mdana("compress", good, self.dir / "missing", "--radius", RADIUS, "--json", code=1)
        study = running.parse_json(done.stdout)
        self.assertEqual(study["summary"]["failed"], 1)
        self.assertIn("missing", done.stderr)
        self.refused("compress", self.dir / "a", self.dir / "b", says=["none of the runs"])

    def test_options(self):
        for arguments in (["--offset", "nan"], ["--offset", "x"], ["--split", "halves"], ["-o", "x.txt"]):
            self.mdana("compress", SAMPLE, *arguments, code=2)
        self.refused("compress", SAMPLE, "--offset", 5000, says=["leaves nothing of R_agg"])

    def test_documents_without_numbers(self):
        early = self.dir / "early.json"
        self.mdana("compress", self.collide("early", 1.2, frames=40, after=-0.5), "--radius", RADIUS, "-o", early)
        self.refused("fit-contact", "--law", "andrews", early, says=["early.json", "delta_max is not known"])
        early.write_text('{"command": "compress", "runs": []}')
        self.refused("fit-contact", "--law", "andrews", early, says=["a study without runs"])


if __name__ == "__main__":
    running.main()
