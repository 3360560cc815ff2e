# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdana network` on the small dump of sample-data: other units, other ways to say what grains are, what is refused."""

import shutil
import tomllib
from dataclasses import replace

import numpy as np

import dumps
import grains
import running
from running import Case, main, read_csv, without_digits

DUMP = running.ROOT / "sample-data" / "aggregate-tiny" / "dump.lammpstrj.gz"
CONTACTS = DUMP.parent / "contacts.dump.gz"
SCENE = tomllib.loads((DUMP.parent / "scene.toml").read_text(encoding="utf-8"))
MATERIAL = {"--surface-energy": ("surface_energy", (1, 0, -2)), "--grain-modulus": ("modulus", (1, -1, -2)),
            "--rolling-displacement": ("rolling_displacement", (0, 1, 0))}
LENGTHS, VELOCITIES = "x y z radius", "vx vy vz"
DIMENSIONS = {"time": (0, 0, 1), "X": (0, 1, 0), "delta": (0, 1, 0), "compacted_volume": (0, 3, 0)}


def dimension(column):
    return DIMENSIONS.get(column, (1, 1, -2) if column.startswith("force") else (0, 0, 0))


class Network(Case):
    @classmethod
    def setUpClass(cls):
        cls.frames = dumps.read(DUMP)[::9]
        cls.jkr = grains.Jkr.of_scene(SCENE)

    def scaled(self, mass, length, time, units):
        """The frames in other units, and the options that say the rest of the scene in them."""
        factor = lambda powers: mass**powers[0] * length**powers[1] * time**powers[2]  # noqa: E731
        frames = []
        for frame in self.frames:
            atoms = frame.atoms.copy()
            for names, by in ((LENGTHS, length), (VELOCITIES, length / time), ("mass", mass)):
                for name in names.split():
                    atoms[:, frame.columns.index(name)] *= by
            frames.append(replace(frame, atoms=atoms, units=units, time=frame.time * time))
        options = ["--radius", repr(SCENE["body"][0]["radius"] * length), "--poisson-ratio", 0.25]
        for option, (name, powers) in MATERIAL.items():
            options += [option, repr(SCENE["grains"][name] * factor(powers))]
        return dumps.write(self.dir / f"{units}.dump", frames), options, factor

    def network(self, *arguments):
        out = self.dir / "network.csv"
        document = self.document("network", *arguments, "-o", out)
        return document, read_csv(out)

    def test_powers_of_two_scale_exactly(self):
        dump, options, _ = self.scaled(1.0, 1.0, 1.0, "nano")
        document, table = self.network(dump, *options)
        for mass, length, time in ((2.0**-12, 2.0**-7, 2.0**-3), (2.0**60, 2.0**30, 2.0**20)):
            other, options, factor = self.scaled(mass, length, time, "lj")
            found, scaled = self.network(other, *options)
            for name, values in table.items():
                by = factor(dimension(name))
                self.assertEqual([None if v is None else v * by for v in values], scaled[name], name)
            self.assertEqual(found["aggregate"]["bulk_modulus"]["value"],
                             document["aggregate"]["bulk_modulus"]["value"] * factor((1, -1, -2)))
            self.assertEqual(found["aggregate"]["static_yield_stress"]["value"],
                             document["aggregate"]["static_yield_stress"]["value"] * factor((1, -1, -2)))

    def test_si(self):
        """Powers of ten round: overlaps to 1e-16 of 1000 nm, 1e-13 nm, so forces to 1e-8 of them."""
        dump, options, _ = self.scaled(1.0, 1.0, 1.0, "nano")
        _, table = self.network(dump, *options)
        dump, options, factor = self.scaled(1e-21, 1e-9, 1e-9, "si")
        _, scaled = self.network(dump, *options)
        for name, values in table.items():
            by = factor(dimension(name))
            scale = max((abs(v) for v in values if v is not None), default=1) or 1
            for a, b in zip(values, scaled[name], strict=True):
                self.assertEqual(a is None, b is None, name)
                if a is not None:
                    self.assertAlmostEqual(a / scale, b / by / scale, delta=1e-8, msg=name)

    def test_scene_option_and_column_agree(self):
        """The grains by the scene, by options, and without the column radius."""
        _, table = self.network(DUMP, "--stride", 9)
        dump, options, _ = self.scaled(1.0, 1.0, 1.0, "nano")
        plain = dumps.write(self.dir / "plain.dump", [frame.without("radius") for frame in dumps.read(dump)])
        for more in ([dump], [plain, "--grain-radius", 100]):
            found, other = self.network(*more, *options)
            for name in table:
                if "tension" not in name and "compression" not in name:  # these know how many digits the dump has
                    self.assertEqual(table[name], other[name], name)
            self.assertEqual(found["filling_factor"]["source"], "grains of the first frame over the bodies' spheres")
            self.assertAlmostEqual(found["filling_factor"]["value"], 205 / 512, delta=1e-12)

    def test_coordination_of_close_packing_less_random_grains(self):
        """12 phi/phi_max where a grain has all its places in the aggregate; within three standard errors."""
        document = self.document("network", DUMP, "--frames", "0:1")
        core = document["coordination_core"]
        expected = document["coordination_cpe"]["at_equilibrium_overlap"]
        self.assertAlmostEqual(expected, 12 * 0.4 / (np.pi / np.sqrt(18)) * (1 - self.jkr.delta0 / 200)**3, delta=1e-12)
        self.assertLess(abs(core["value"] - expected), 3 * core["error"])
        self.assertLess(document["coordination"]["value"], core["value"])
        first, second, overlaps, _ = grains.pairs(self.frames[0])
        self.assertAlmostEqual(document["coordination"]["value"], 2 * len(overlaps) / 410, delta=1e-12)
        self.assertEqual(document["frame"]["first"]["contacts"], len(first))

    def test_made_and_broken(self):
        _, table = self.network(DUMP, "--stride", 9)
        held = []
        for frame in self.frames:
            first, second, _, _ = grains.pairs(frame)
            ids = frame["id"][:, 0].astype(int)
            held.append({frozenset((ids[a], ids[b])) for a, b in zip(first, second)})
        self.assertEqual(table["made"], [len(now - held[0]) for now in held])
        self.assertEqual(table["broken"], [len(held[0] - now) for now in held])
        self.assertGreater(table["broken"][-1], 20)

    def test_undecided_pairs_are_told(self):
        document, table = self.network(DUMP)
        frames = dumps.read(DUMP)
        row = document["undecided"]["row"]
        _, _, overlaps, _ = grains.pairs(frames[row], least=-(0.75**(2 / 3)) * self.jkr.delta0)
        self.assertEqual(document["undecided"]["most"], np.sum(overlaps < 0))
        self.assertEqual(table["contacts"][row], np.sum(overlaps >= 0))

    def test_listed_contacts(self):
        """Forces of the list where it has some (overlap above 0.397 delta0), else by the overlap, which is the same."""
        _, plain = self.network(DUMP)
        document, table = self.network(DUMP, "--contacts", CONTACTS)
        listed = [k for k, n in enumerate(table["listed"]) if n is not None]
        self.assertEqual(listed, list(range(0, 47, 4)))
        self.assertEqual(document["listed"]["frames"], 12)
        self.assertEqual(document["listed"]["unmatched"], 0)
        self.assertEqual(table["contacts"], plain["contacts"])
        frames = dumps.read(DUMP)
        for k in listed:
            _, _, overlaps, _ = grains.pairs(frames[k])
            self.assertEqual(table["listed"][k], np.sum(overlaps > 4**(-2 / 3) * self.jkr.delta0))
            for name in ("force_mean", "force_min", "force_q25", "force_max"):  # positions have 8 digits: 1e-4 nm
                self.assertAlmostEqual(table[name][k], plain[name][k], delta=2e-4 * self.jkr.stiffness, msg=name)
        other = dumps.write(self.dir / "other.dump", [replace(self.frames[0], step=1)])
        self.refused("network", other, "--grain-radius", 100, "--contacts", CONTACTS, says=["no contacts at a step"])
        self.refused("network", DUMP, "--contacts", DUMP, says=[DUMP, "no part of a local dump"])
        self.refused("network", DUMP, "--contacts", CONTACTS, "--contact-columns", "a,b,c", says=["no column 'a'"])
        for columns in ("a,b", "a,b,c,d"):
            self.refused("network", DUMP, "--contacts", CONTACTS, "--contact-columns", columns, code=2,
                         says=["ID,ID,FORCE"])

    def test_without_constants_there_are_no_forces(self):
        dump, _, _ = self.scaled(1.0, 1.0, 1.0, "nano")
        document, table = self.network(dump)
        self.assertNotIn("force_mean", table)
        self.assertEqual(set(table["undecided"]), {0.0})
        self.assertIn("--surface-energy", str(document["left_out"]))

    def test_aggregate_modulus(self):
        document = self.document("network", DUMP, "--aggregate-modulus", 60)
        nu, bulk = document["aggregate"]["poisson_ratio"]["value"], document["aggregate"]["bulk_modulus"]["value"]
        self.assertAlmostEqual(3 * bulk * (1 - 2 * nu) / (2 * (1 - nu * nu)), 60, delta=1e-9)

    def test_estimates_over_the_filling_factor(self):
        """`mdana aggregate` gives what `mdana network` does at the same filling factor and coordination."""
        document = self.document("network", DUMP)
        grains_of = SCENE["grains"]
        constants = [f"-p{name}={grains_of[key]!r}" for name, key in (
            ("r", "radius"), ("E", "modulus"), ("nu", "poisson_ratio"), ("gamma", "surface_energy"),
            ("xi_c", "rolling_displacement"))]
        table = self.table("aggregate", "--filling-factor", "0.4:0.5:2", *constants, "-pE_aggregate=60")
        bulk, core = document["aggregate"]["bulk_modulus"]["value"], document["coordination_core"]["value"]
        self.assertAlmostEqual(table["bulk_modulus_cpe"][0] / table["coordination_cpe"][0], bulk / core, delta=1e-12 * bulk)
        self.assertEqual(table["static_yield_stress"][0], document["aggregate"]["static_yield_stress"]["value"])
        self.assertEqual(table["coordination_bcca"][0], document["aggregate"]["coordination_bcca"]["value"])
        nu, bulk = table["poisson_ratio_cpe"][1], table["bulk_modulus_cpe"][1]
        self.assertAlmostEqual(3 * bulk * (1 - 2 * nu) / (2 * (1 - nu * nu)), 60, delta=1e-9)
        bare = self.table("aggregate", "--filling-factor", "0.4")
        self.assertEqual((bare["bulk_modulus_cpe"], bare["static_yield_stress"]), ([None], [None]))
        for arguments in (["0"], ["0.75"], ["nan"], ["0.1:0.8:3"], ["0.4", "-p", "r=-1"], ["0.4", "-p", "nu=0.6"],
                          ["0.4", "-p", "r=1", "-p", "r=2"], ["0.4", "-p", "x=1"]):
            self.refused("aggregate", "--filling-factor", *arguments, code=2)

    def test_info_says_what_aggregates_have_not(self):
        document = self.told_by_info(DUMP, "no crystal lattice")
        self.assertIn("contact network", self.mdana("info", DUMP).stdout)
        self.assertEqual(document["interaction"], "aggregate")
        bare = dumps.write(self.dir / "dump.lammpstrj.gz", [frame.without("radius") for frame in self.frames])
        scene = (DUMP.parent / "scene.toml").read_text(encoding="utf-8").replace("radius = 100.0\n", "")
        (self.dir / "scene.toml").write_text(scene, encoding="utf-8")
        self.told_by_info(bare, "no column 'radius'")

    def test_report_has_aggregates_beside_spheres(self):
        """Compression, together with other aggregates and without what is of spheres, which is said."""
        runs = self.dir / "runs"
        for sample, name in ((DUMP.parent, "a"), (DUMP.parent, "b"), (running.SAMPLE.parent, "spheres")):
            shutil.copytree(sample, runs / name)
        for name in "ab":
            scene = runs / name / "scene.toml"
            scene.write_text(scene.read_text().replace('name = "aggregate-tiny"', f'name = "{name}"'))
        self.mdana("report", runs, "-o", self.dir / "report")
        results = running.parse_json((self.dir / "report" / "results.json").read_text(encoding="utf-8"))
        compressed = self.document("compress", DUMP)
        by_name = {run["name"]: run for run in results["runs"]}
        self.assertEqual(set(by_name), {"a", "b", "adhesive-tiny"})
        for name in "ab":
            self.assertEqual(without_digits(by_name[name]["delta_max"]), compressed["delta_max"])
            self.assertEqual(without_digits(by_name[name]["coordination"]), compressed["coordination"])
            self.assertIn("lattice defects", [entry["what"] for entry in by_name[name]["left_out"]])
            self.assertTrue((self.dir / "report" / "runs" / name / "approach.csv").is_file())
        [together] = results["aggregates"]
        self.assertFalse(together["usable"])  # two runs of one velocity
        page = (self.dir / "report" / "index.html").read_text(encoding="utf-8")
        for text in ("delta_max", "no solid sphere", "Aggregates together", "relative velocity against time"):
            self.assertIn(text, page)

    def test_report_of_aggregates_alone(self):
        self.mdana("report", DUMP.parent, "-o", self.dir / "report")
        self.assertIn("Contact mechanics of 1 run", (self.dir / "report" / "index.html").read_text(encoding="utf-8"))

    def test_one_frame_is_enough(self):
        dump = dumps.write(self.dir / "one.dump", self.frames[:1])
        self.assertEqual(self.document("network", dump)["frames"], 1)

    def test_refusals(self):
        bare = [frame.without("radius") for frame in self.frames]
        dump = dumps.write(self.dir / "bare.dump", bare)
        self.refused("network", dump, says=["radius", "--grain-radius", "[grains]"])
        self.refused("network", dump, "--grain-radius", 100, "--surface-energy", 100,
                     says=["E is not known", "--grain-modulus"])
        self.refused("network", dump, "--grain-radius", -1, code=2, says=["--grain-radius"])
        self.refused("network", dump, "--grain-radius", "nan", code=2, says=["--grain-radius"])
        self.refused("network", DUMP, "--poisson-ratio", 0.6, code=2, says=["--poisson-ratio"])
        self.refused("network", DUMP, "--compacted", 1.5, code=2, says=["--compacted"])
        for column, value, says in (("radius", -100.0, "must be positive"), ("radius", 0.0, "must be positive"),
                                    ("radius", float("nan"), "radius"), ("x", float("nan"), "not finite")):
            frames = [replace(frame, atoms=frame.atoms.copy()) for frame in self.frames]
            frames[0].atoms[17, frames[0].columns.index(column)] = value
            self.refused("network", dumps.write(self.dir / "wrong.dump", frames), says=["wrong.dump", says])
        frames = [replace(frame, atoms=frame.atoms.copy()) for frame in self.frames]
        places = [frames[0].columns.index(name) for name in "xyz"]
        frames[0].atoms[5, places] = frames[0].atoms[6, places]
        self.refused("network", dumps.write(self.dir / "wrong.dump", frames), says=["coincide"])


if __name__ == "__main__":
    main()
