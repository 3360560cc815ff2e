# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdana accuracy`, --error of other commands, `mdana selfcheck`."""

import math
from dataclasses import replace

import numpy as np

import dumps
import running
from running import SAMPLE, Case

HERTZ = SAMPLE.parents[1] / "hertz-tiny" / "dump.lammpstrj.gz"
KRIJT = [word for p in ("R=147", "m=14434147", "E=65.5", "gamma=3.17", "nu=0.25", "T_vis=0.075", "v=0.1") for word in ("-p", p)]


def rows_of(document, subject, knob):
    """By number: the rows of a ladder, in the order of the settings."""
    ladder = next(k for s in document["results"][0]["subjects"] if s["subject"] == subject
                  for k in s["knobs"] if k["knob"] == knob)
    rows = {}
    for row in ladder["rows"]:
        rows.setdefault(row["quantity"], []).append(row)
    return rows


class KnownBounce(Case):
    """A dump of a bounce in closed form."""

    def setUp(self):
        super().setUp()
        frames, self.top, self.depth, _ = dumps.spring_bounce(frames_a_quarter=32)
        self.frames = [f.without("fx", "fy", "fz") for f in frames]
        self.dump = dumps.write(self.dir / "bounce.dump", self.frames)

    def accuracy(self, *arguments, code=0, only="force"):
        return self.document("accuracy", self.dump, "--radius", "5", "--only", only, "--repeat", "1",
                             *arguments, code=code)

    def truths(self):
        return {"F_max": (self.top, self.top), "delta_max": (self.depth, self.depth), "F_min_loading": (0.0, self.top)}

    def test_errors_of_strides_hold_the_true_ones(self):
        for subject in ("force", "collision"):
            rows = rows_of(self.accuracy("--knob", "stride", only=subject), subject, "stride")
            for name, (truth, size) in self.truths().items():
                self.assertGreaterEqual(len(rows[name]), 3)
                for row in rows[name]:
                    true = abs(row["value"] - truth) / size
                    self.assertLessEqual(true, 2 * max(row["error"], row["stated"] or 0) + 1e-9, f"{subject}, {name}, {row['setting']}")

    def test_digits_of_the_input_cost_a_factor_of_ten_each(self):
        self.dump.write_text(shortened(self.dump.read_text(), 8))
        rows = rows_of(self.accuracy("--knob", "digits"), "force", "digits")["F_max"]
        errors = [r["error"] for r in rows]
        for k, row in enumerate(rows):
            self.assertAlmostEqual(row["number"], 10.0**k)
        slope = (math.log10(errors[5]) - math.log10(errors[2])) / 3
        self.assertGreater(slope, 0.6)
        self.assertLess(slope, 1.4)

    def test_threads_and_memory_change_nothing(self):
        document = self.accuracy("--knob", "threads,memory")
        for knob in ("threads", "memory"):
            for rows in rows_of(document, "force", knob).values():
                self.assertEqual([r["error"] for r in rows], [0.0] * 3)

    def test_a_recommendation_holds_for_another_run_of_the_kind(self):
        wanted = 0.02
        document = self.accuracy("--knob", "stride", "--error", wanted, "--judge", "F_max,delta_max")
        told = document["results"][0]["subjects"][0]["recommended"]
        self.assertTrue(told["met"])
        self.assertLessEqual(told["error"], wanted)
        words = told["settings"]["stride"].split()
        stride = 1 if words[0] == "all" else int(words[2])
        self.assertGreater(stride, 1, "every frame is not the cheapest that does")
        frames, top, depth, _ = dumps.spring_bounce(speed=0.4, stiffness=80.0, frames_a_quarter=32)
        other = dumps.write(self.dir / "other.dump", [f.without("fx", "fy", "fz") for f in frames])
        found = self.document("force", other, "--radius", "5", "--stride", stride)
        for name, truth, size in (("F_max", top, top), ("delta_max", depth, depth)):
            self.assertLessEqual(abs(found[name]["value"] - truth) / size, wanted, name)

    def test_other_commands_choose_their_stride(self):
        loose = self.document("force", self.dump, "--radius", "5", "--error", "0.5")
        self.assertTrue(loose["accuracy"]["met"])
        self.assertLess(loose["frames"], len(self.frames))
        for name, (truth, size) in self.truths().items():
            self.assertLessEqual(abs(loose[name]["value"] - truth) / size, 0.5, name)
        tight = self.document("force", self.dump, "--radius", "5", "--error", "1e-9", code=4)
        self.assertFalse(tight["accuracy"]["met"])
        self.assertEqual(tight["frames"], len(self.frames))
        self.assertAlmostEqual(tight["accuracy"]["exceeds"], tight["accuracy"]["error"] / 1e-9)
        self.assertRegex(" ".join(tight["warnings"]), "cannot be met.* times the wanted 1e-09")

    def test_a_wanted_error_that_nothing_meets(self):
        document = self.accuracy("--knob", "stride", "--error", "1e-12", code=4)
        told = document["results"][0]["subjects"][0]["recommended"]
        self.assertFalse(told["met"])
        self.assertEqual(told["settings"], {"stride": "all frames"})
        self.assertGreater(told["exceeds"], 1)


def shortened(text, digits):
    """The atoms of a dump printed with fewer digits."""
    lines, atoms = [], False
    for line in text.splitlines():
        if line.startswith("ITEM:"):
            atoms = line.startswith("ITEM: ATOMS")
        elif atoms:
            words = line.split()
            line = " ".join(words[:2] + [f"{float(w):.{digits}f}" for w in words[2:]])
        lines.append(line)
    return "\n".join(lines) + "\n"


class Samples(Case):
    def test_every_analysis_of_a_dump_has_its_knobs(self):
        document = self.document("accuracy", HERTZ, "--repeat", "1")
        found = {s["subject"]: [k["knob"] for k in s["knobs"]] for s in document["results"][0]["subjects"]}
        self.assertEqual(set(found), {"force", "contact-radius", "energy", "fit-hertz", "fit-force"})
        for knobs in found.values():
            self.assertLessEqual({"stride", "digits", "threads", "memory"}, set(knobs))
        self.assertLessEqual({"source", "window", "degree"}, set(found["force"]))
        self.assertLessEqual({"source", "window", "degree", "law", "part", "min-delta-fraction", "loss"}, set(found["fit-force"]))
        self.assertLessEqual({"layer", "neighbour-cutoff", "definition"}, set(found["contact-radius"]))
        self.assertLessEqual({"method", "phase", "min-force-fraction", "loss"}, set(found["fit-hertz"]))

    def test_table_and_figure(self):
        out = self.dir / "accuracy.csv"
        document = running.parse_json(self.mdana("accuracy", SAMPLE, "--only", "force", "--knob", "stride", "--json", "-o", out).stdout)
        table = running.read_csv(out)
        rows = rows_of(document, "force", "stride")
        self.assertEqual(len(table["value"]), sum(map(len, rows.values())))
        self.assertEqual(set(table["quantity"]), set(rows))
        for seconds, memory in zip(table["seconds"], table["memory"]):
            self.assertGreater(seconds, 0)
            self.assertTrue(memory is None or memory > 1e6)
        self.mdana("plot", "work-precision", out, "-o", self.dir / "figure.svg", code=0)
        self.assertIn("force: stride: F_max", (self.dir / "figure.csv").read_text())

    def test_what_is_fixed_is_told_and_not_drawn(self):
        out = self.dir / "accuracy.csv"
        done = self.mdana("accuracy", SAMPLE, "--only", "force", "--knob", "stride,block-size", "--repeat", "1", "-o", out)
        self.assertRegex(done.stdout, r"force, block-size +32768 atoms +fixed: \S")
        table = running.read_csv(out)
        k = table["knob"].index("block-size")
        self.assertEqual((table["setting"][k], table["error"][k], table["seconds"][k]), ("32768 atoms (fixed)", None, None))
        self.mdana("plot", "work-precision", out, "-o", self.dir / "figure.svg")
        self.assertNotIn("block-size", (self.dir / "figure.csv").read_text())

    def test_errors_are_the_same_again(self):
        def numbers():
            document = self.document("accuracy", SAMPLE, "--only", "force,contact-radius", "--knob", "stride,source,layer")
            return [[(r["setting"], r["quantity"], r["value"], r["error"]) for r in k["rows"]]
                    for s in document["results"][0]["subjects"] for k in s["knobs"]]
        self.assertEqual(numbers(), numbers())

    def test_a_study(self):
        document = self.document("accuracy", SAMPLE.parents[1] / "hertz-tiny", "--only", "force", "--knob", "stride", "--repeat", "1")
        self.assertEqual([s["subject"] for s in document["results"][0]["subjects"]], ["force"])

    def test_what_a_scene_does_not_have_is_left_out(self):
        document = self.document("accuracy", SAMPLE, "--knob", "threads", "--repeat", "1")
        self.assertIn("fit-hertz", [entry["what"] for entry in document["left_out"]])

    def test_hertz_fits_and_contact_radii_say_what_they_cannot(self):
        document = self.document("fit-hertz", HERTZ, "--error", "0.01", code=4)
        self.assertEqual(document["accuracy"]["quantity"], "E_star")
        self.assertGreater(document["accuracy"]["exceeds"], 5)
        self.assertTrue(self.document("contact-radius", HERTZ, "--error", "1")["accuracy"]["met"])
        self.assertTrue(self.document("energy", HERTZ, "--error", "1")["accuracy"]["met"])

    def test_aggregates(self):
        grains = SAMPLE.parents[1] / "aggregate-tiny" / "dump.lammpstrj.gz"
        document = self.document("accuracy", grains, "--knob", "split,stride", "--repeat", "1")
        self.assertEqual(set(rows_of(document, "compress", "split")), {"delta_max", "t_max"})
        loose, fine = self.document("compress", grains, "--error", "0.2"), self.document("compress", grains)
        self.assertTrue(loose["accuracy"]["met"])
        self.assertLess(loose["frames"], fine["frames"])
        for name in ("delta_max", "t_max"):
            self.assertLessEqual(abs(loose[name]["value"] / fine[name]["value"] - 1), 0.2)
        self.mdana("compress", grains, grains, "--error", "0.2", code=2)

    def test_searches_of_defects_give_the_same(self):
        document = self.document("accuracy", SAMPLE, "--only", "defects", "--knob", "neighbours,zone", "--frames", "::8", "--repeat", "1")
        for knob in ("neighbours", "zone"):
            for name, rows in rows_of(document, "defects", knob).items():
                self.assertEqual([r["error"] for r in rows], [0.0, 0.0], name)

    def test_refusals(self):
        for arguments in (["accuracy"], ["accuracy", SAMPLE, "--repeat", "0"], ["accuracy", SAMPLE, "--error", "0"],
                          ["accuracy", SAMPLE, "--law", "magic"], ["force", SAMPLE, "--error", "-1"],
                          ["force", SAMPLE, "--error", "0.1", "--stride", "2"],
                          ["predict", "--law", "krijt", *KRIJT, "--error", "0.1", "--tolerance", "1e-3"]):
            with self.subTest(arguments):
                self.mdana(*arguments, code=2)
        self.refused("accuracy", SAMPLE, "--knob", "magic", says=["no analysis or knob of that name"])
        self.refused("accuracy", self.dir / "missing", says=["missing"])


class Laws(Case):
    def test_tolerance_of_a_prediction(self):
        rows = rows_of(self.document("accuracy", "--law", "krijt", *KRIJT, "--repeat", "1"), "predict krijt", "tolerance")["e"]
        self.assertEqual([r["number"] for r in rows], [1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2])
        for row in rows:
            self.assertLessEqual(row["error"], row["number"] + 1e-11)

    def test_a_prediction_chooses_its_tolerance(self):
        exact = self.document("predict", "--law", "krijt", *KRIJT, "--tolerance", "1e-12")
        for wanted in (1e-2, 1e-4, 1e-7):
            found = self.document("predict", "--law", "krijt", *KRIJT, "--error", wanted)
            self.assertTrue(found["accuracy"]["met"])
            for name in ("e", "delta_max", "t_max"):
                self.assertLessEqual(abs(found[name] / exact[name] - 1), wanted, name)
        self.assertLess(self.document("predict", "--law", "krijt", *KRIJT, "--error", "1e-2")["evaluations"], exact["evaluations"])

    def test_fit_of_observations(self):
        table = self.dir / "seen.csv"
        table.write_text("R,m,v,e,sigma\n" + "".join(
            f"58.9,891565,{v},{e},0.01\n" for v, e in ((0.2, 0.83), (0.25, 0.90), (0.3, 0.93), (0.4, 0.96), (0.5, 0.98), (0.6, 0.985))))
        document = self.document("accuracy", table, "--law", "jkr", "-p", "E=65.5", "--free", "gamma", "--repeat", "1")
        subject = document["results"][0]["subjects"][0]
        self.assertEqual([k["knob"] for k in subject["knobs"]], ["starts", "loss", "bootstrap"])
        self.assertEqual(rows_of(document, "fit-contact jkr", "starts")["gamma"][-1]["setting"], "1")
        chosen = self.document("fit-contact", table, "--law", "jkr", "-p", "E=65.5", "--free", "gamma", "--error", "0.5")
        self.assertTrue(chosen["accuracy"]["met"])


class OtherCommands(Case):
    """--error of commands whose subjects are their own, and what their ladders hold."""

    E, R, REDUCED = 60.0, 5.0, 2.5

    def hertz_dump(self, name, speed, frames_in_contact=64):
        """Two bodies of m* = 4 that bounce by Hertz's law; the force is in their speeds only."""
        depth = (15 * 4 * speed**2 / (16 * self.E * math.sqrt(self.REDUCED)))**0.4
        dt = 2.9432 * depth / speed / frames_in_contact
        path = dumps.andrews_path(self.E, 1e9, self.REDUCED, 4.0, speed, dt, 32, 64 + frames_in_contact)
        frames = [dumps.two_cubes(k, k * dt, 2 * self.R - delta, -v).without("fx", "fy", "fz") for k, (delta, v) in enumerate(path)]
        return dumps.write(self.dir / name, frames)

    def stride_of(self, told):
        words = told["settings"]["stride"].split()
        return 1 if words[0] == "all" else int(words[2])

    def test_fit_of_a_known_law(self):
        dump = self.hertz_dump("a.dump", 0.5)
        scene = self.dir / "hertz.toml"
        scene.write_text('schema = 1\ninteraction = "hertz"\n')
        document = self.document("accuracy", dump, "--scene", scene, "--radius", self.R, "--only", "fit-force", "--repeat", "1",
                                 "--knob", "stride")
        rows = rows_of(document, "fit-force", "stride")
        for name, truth in (("E*", self.E), ("R", self.R)):
            errors = [abs(r["value"] / truth - 1) for r in rows[name]]
            self.assertGreater(len(errors), 2)
            self.assertLess(errors[0], 1e-3)
            self.assertGreater(errors[2], 4 * errors[0], "coarser frames are worse")
            for row, true in zip(rows[name], errors):
                self.assertLessEqual(true, 2 * max(row["error"], row["stated"] or 0) + 1e-9, f"{name}, {row['setting']}")

    def test_fit_force_keeps_the_wanted_error_on_another_run(self):
        for wanted in (0.1, 0.03):
            for name, speed in (("a.dump", 0.5), ("b.dump", 0.3)):
                found = self.document("fit-force", "--law", "hertz", self.hertz_dump(name, speed), "--radius", self.R, "--error", wanted)
                self.assertTrue(found["accuracy"]["met"])
                self.assertLessEqual(abs(found["parameters"]["E*"]["value"] / self.E - 1), wanted)
                self.assertLessEqual(abs(found["parameters"]["R"]["value"] / self.R - 1), wanted)
            self.assertGreater(self.stride_of(found["accuracy"]), 1)
        self.mdana("fit-force", "--law", "hertz", self.dir / "a.dump", "--radius", self.R, "--error", "1e-9", code=4)

    def test_collision_says_all_of_it_to_the_error(self):
        frames, top, depth, _ = dumps.spring_bounce(frames_a_quarter=32)
        dump = dumps.write(self.dir / "bounce.dump", [f.without("fx", "fy", "fz") for f in frames])
        loose = self.document("collision", dump, "--radius", "5", "--error", "0.5")
        self.assertTrue(loose["accuracy"]["met"])
        self.assertLess(loose["frames"], len(frames))
        self.assertLessEqual(abs(loose["F_max"]["value"] / top - 1), 0.5)
        self.assertLessEqual(abs(loose["delta_max"]["value"] / depth - 1), 0.5)
        tight = self.document("collision", dump, "--radius", "5", "--error", "1e-9", code=4)
        self.assertEqual(tight["frames"], len(frames))
        series = self.document("collision", dump, dump, "--radius", "5", "--error", "0.5")
        self.assertEqual([run["accuracy"]["settings"] for run in series["runs"]], 2 * [loose["accuracy"]["settings"]])
        self.mdana("collision", dump, dump, "--radius", "5", "--error", "1e-9", code=4)

    def test_greatest_numbers_of_defects_are_those_of_all_frames_to_the_error(self):
        wanted = 0.05
        out = self.dir / "table.csv"
        chosen = running.parse_json(self.mdana("defects", SAMPLE, "--no-lines", "--error", wanted, "--json", "-o", out).stdout)
        self.assertTrue(chosen["accuracy"]["met"])
        self.assertGreater(self.stride_of(chosen["accuracy"]), 1)
        some, every = running.read_csv(out), self.table("defects", SAMPLE, "--no-lines")
        self.assertLess(len(some["fcc"]), len(every["fcc"]))
        for column in ("fcc", "hcp", "bulk_defect"):
            self.assertLessEqual(abs(max(some[column]) - max(every[column])), wanted * 1206, column)

    def test_networks_at_the_greatest_compression(self):
        grains = SAMPLE.parents[1] / "aggregate-tiny" / "dump.lammpstrj.gz"
        chosen, every = self.document("network", grains, "--error", "0.1"), self.document("network", grains)
        self.assertTrue(chosen["accuracy"]["met"])
        self.assertLess(chosen["frames"], every["frames"])
        some, all_ = (d["frame"]["at_delta_max"] for d in (chosen, every))
        for name in ("contacts", "contacts12", "made", "broken", "tension", "compression"):
            self.assertLessEqual(abs(some[name] - all_[name]), 0.1 * all_["contacts"], name)
        self.assertEqual(self.document("network", grains, "--error", "1e-6", code=4)["accuracy"]["settings"], {"stride": "all frames"})

    def test_laws_are_compared_with_as_many_starts_as_they_need(self):
        table = self.dir / "seen.csv"
        table.write_text("R,m,v,e,sigma\n" + "".join(
            f"58.9,891565,{v},{e},0.01\n" for v, e in ((0.2, 0.83), (0.25, 0.90), (0.3, 0.93), (0.4, 0.96), (0.5, 0.98), (0.6, 0.985))))
        given = (table, "-p", "E=65.5", "-p", "nu=0.25", "-p", "spacing=1.091")
        chosen, all_ = self.document("compare-laws", *given, "--error", "1e-3"), self.document("compare-laws", *given, "--starts", "16")
        self.assertTrue(chosen["accuracy"]["met"])
        self.assertLess(int(chosen["accuracy"]["settings"]["starts"]), 16)
        self.assertEqual(chosen["best"], all_["best"])
        found, exact = ({law["law"]: law["chi2"] for law in d["laws"]} for d in (chosen, all_))
        self.assertEqual(set(found), set(exact))
        for law, chi2 in exact.items():
            self.assertLessEqual(abs(found[law] - chi2), 1e-3 * max(chi2, 6), law)
        self.mdana("compare-laws", *given, "--error", "1e-3", "--starts", "4", code=2)
        ladder = rows_of(self.document("accuracy", *given, "--law", "all", "--repeat", "1", "--knob", "starts"), "compare-laws", "starts")
        self.assertEqual(set(ladder), {f"{law}.chi2" for law in exact})

    def test_a_surface_energy_has_no_error_to_choose_and_says_why(self):
        frame = dumps.read(SAMPLE)[0].without("vx", "vy", "vz")
        energies = np.full((len(frame.atoms), 1), -6.25)
        ball = replace(frame, columns=[*frame.columns, "c_pe"], atoms=np.hstack([frame.atoms, energies]))
        dump = dumps.write(self.dir / "ball.dump", [ball])
        given = ("--scene", SAMPLE.parent / "scene.toml")
        rows = rows_of(self.document("accuracy", dump, *given, "--only", "surface-energy", "--repeat", "1", "--knob", "radius,digits,frames"),
                       "surface-energy", "radius")["gamma"]
        told = self.document("surface-energy", dump, *given)
        self.assertEqual([r["setting"] for r in rows], ["cut", "volume", "gyration"])
        exact = told["N"] * (-6.25 - told["e_1"]["value"]) / (4 * math.pi * 5**2)
        self.assertAlmostEqual(rows[0]["value"] / exact, 1, places=12)
        self.assertEqual([r["value"] for r in rows], [told["gamma"][r["setting"]]["value"] for r in rows])
        self.mdana("surface-energy", dump, *given, "--error", "0.1", code=2)
        self.assertIn("There is no\n--error", self.mdana("surface-energy", "--help").stdout)


class SelfCheck(Case):
    def test_all_members_keep_their_digits(self):
        out = self.dir / "selfcheck.csv"
        document = running.parse_json(self.mdana("selfcheck", "--json", "-o", out).stdout)
        self.assertEqual(document["lost"], 0)
        members = {m["member"]: m for m in document["members"]}
        self.assertLessEqual({"lammps_text", "motion", "contact_radius", "jkr", "krijt"}, set(members))
        table = running.read_csv(out)
        self.assertEqual(len(table["case"]), document["cases"])
        for member in members.values():
            self.assertGreater(member["seconds"], 0)
            for answer in member["answers"]:
                agree = 16 if answer["computed"] == answer["exact"] else -math.log10(
                    abs(answer["computed"] / answer["exact"] - 1) if answer["exact"] else abs(answer["computed"]))
                self.assertAlmostEqual(answer["digits"], min(max(agree, 0), 16), places=2)
                self.assertGreaterEqual(agree, answer["needed"])
        self.assertRegex(self.mdana("selfcheck").stdout, r"cases +\d+, 0 with fewer digits")


if __name__ == "__main__":
    running.main()
