# SPDX-License-Identifier: GPL-3.0-or-later
"""mdana plan: what is computed and left out of each kind of scene, why, and that results say the same."""

import math
import time

import dumps
import running
from running import SAMPLE
from studies import NAMES, Study

ROOT = SAMPLE.parents[1]
HERTZ = ROOT / "hertz-tiny" / "dump.lammpstrj.gz"
GRAINS = ROOT / "aggregate-tiny" / "dump.lammpstrj.gz"
PUBLISHED = {"force", "coefficient of restitution", "contact radius", "energies"}


def computed(document):
    return {entry["what"]: entry for entry in document["computed"]}


def left_out(document):
    return {entry["what"]: entry["reason"] for entry in document.get("left_out", [])}


def caught(frames=80, speed=0.25, rest=0.5, mass=4.0):
    """Bodies that fly into a harmonic well about delta = rest, of angular frequency 1, and stay there."""
    lag = math.atan(rest / speed)
    result = []
    for k in range(frames):
        t = 0.25 * k - 5
        delta, v = (speed * t, speed) if t < 0 else (rest + speed / math.cos(lag) * math.sin(t - lag),
                                                     speed / math.cos(lag) * math.cos(t - lag))
        result.append(dumps.two_cubes(k, 0.25 * k, 10 - delta, -v, 0 if t < 0 else mass * (delta - rest)))
    return result


class Plans(running.Case):
    def plan(self, *arguments):
        document = self.document("plan", *arguments)
        self.assertEqual(document["command"], "plan")
        both = set(computed(document)) & set(left_out(document))
        self.assertEqual(both, set(), "a part is computed or left out")
        for entry in document["computed"] + document["left_out"]:
            self.assertTrue(entry["reason"], entry["what"])
        return document

    def test_hertz_scene(self):
        document = self.plan(HERTZ)
        self.assertLessEqual(PUBLISHED | {"Hertz fit", "lattice defects"}, set(computed(document)))
        reasons = left_out(document)
        for adhesion in ("JKR (laws with adhesion)", "surface energy"):
            self.assertIn("no attraction", reasons[adhesion])
        self.assertIn("not of aggregates", reasons["compression of aggregates"])
        self.assertEqual(computed(document)["force"]["columns"], "type x y z vx vy vz".split())
        self.assertEqual(computed(document)["contact radius"]["columns"], "type x y z".split())
        self.assertEqual(reasons["force from forces"], "not in the dump")
        self.assertIn("better", reasons["force from positions"])

    def test_adhesive_scene(self):
        document = self.plan(SAMPLE)
        self.assertIn("adhesive", left_out(document)["Hertz fit"])
        self.assertIn("E*", left_out(document)["JKR (laws with adhesion)"])
        self.assertIn("at rest", left_out(document)["surface energy"])
        self.assertIn("c_pe", left_out(document)["W"])
        known = self.plan(SAMPLE, "--modulus", "60")
        self.assertIn("JKR (laws with adhesion)", computed(known))

    def test_aggregates(self):
        document = self.plan(GRAINS)
        self.assertLessEqual({"force", "compression of aggregates", "coordination"}, set(computed(document)))
        for what in ("lattice defects", "contact radius", "Hertz fit", "JKR (laws with adhesion)", "surface energy"):
            self.assertIn("no solid sphere", left_out(document)[what])
        self.assertIn("mdana network", left_out(document)["contact network"])

    def test_without_velocities(self):
        frames = [frame.without("vx", "vy", "vz") for frame in dumps.read(SAMPLE)]
        dump = dumps.write(self.dir / "dump.lammpstrj", frames)
        document = self.plan(dump, "--scene", SAMPLE.parent / "scene.toml")
        self.assertIn("from positions", computed(document)["force"]["reason"])
        self.assertEqual(computed(document)["force"]["columns"], "type x y z".split())
        for what in ("energies", "rotation", "W"):
            self.assertIn("no column vx", left_out(document)[what])
        self.assertIn("no column vx", self.mdana("energy", dump, "--scene", SAMPLE.parent / "scene.toml", code=1).stderr)

    def test_a_single_body(self):
        frames = [frame.body(1) for frame in dumps.read(SAMPLE)[:3]]
        dump = dumps.write(self.dir / "dump.lammpstrj", frames)
        document = self.plan(dump, "--bodies", "type")
        self.assertEqual(set(computed(document)), {"lattice defects"})
        for what in PUBLISHED | {"signs of plasticity", "rotation"}:
            self.assertIn("two bodies, 1 found", left_out(document)[what])
        self.assertIn("c_pe", left_out(document)["surface energy"])

    def test_unknown_layer_times_and_radii(self):
        frames = [frame.without("vx", "vy", "vz") for frame in dumps.read(SAMPLE)]
        for frame in frames:
            frame.units, frame.time = "metal", None
        dump = dumps.write(self.dir / "dump.lammpstrj", frames)
        document = self.plan(dump, "--units", "metal", "--masses", "1=1,2=1")
        self.assertIn("--layer", left_out(document)["contact radius"])
        self.assertIn("--timestep", left_out(document)["force"])
        self.assertIn("does not state", left_out(document)["Hertz fit"])
        self.assertIn("[grains] radius", left_out(self.plan(dump, "--for", "network", "--units", "metal", "--masses",
                                                            "1=1,2=1"))["contact network"])

    def test_commands(self):
        """Each command has its own parts, whatever the scene is of; their columns are those that it reads."""
        for command in ("force", "energy", "contact-radius", "collision", "fit-hertz", "defects"):
            with self.subTest(command):
                plan, result = self.plan(SAMPLE, "--for", command), self.document(command, SAMPLE)
                self.assertLessEqual(set(computed(result)), set(computed(plan)))
                self.assertLessEqual(set(computed(plan)) - set(computed(result)), set(left_out(result)), "settled")
                self.assertLessEqual(set(left_out(plan).items()), set(left_out(result).items()))
                if command != "defects":  # of which ids give the order only
                    self.assertLessEqual(set(plan["columns_read"]), set(result["columns_read"]))
                self.assertLessEqual({c for e in plan["computed"] for c in e["columns"]}, set(plan["columns_read"]))
        for command in ("compress", "network"):
            with self.subTest(command):
                plan, result = self.plan(GRAINS, "--for", command), self.document(command, GRAINS)
                self.assertLessEqual(set(left_out(plan).items()), set(left_out(result).items()))
        self.mdana("plan", SAMPLE, "--for", "convert", code=2)
        self.mdana("plan", SAMPLE.parent, "--for", "force", code=2)

    def test_what_only_the_result_tells(self):
        """A run that sticks has no speed after; one that ends in contact has no restitution."""
        stuck = self.document("force", dumps.write(self.dir / "dump.lammpstrj", caught()), "--radius", "5")
        self.assertEqual((stuck["outcome"], stuck["e"]["value"]), ("stick", 0))
        self.assertIn("stick", left_out(stuck)["speed after the collision"])
        self.assertIn("begins in contact", left_out(self.document("force", SAMPLE))["coefficient of restitution"])
        bounce = self.document("force", HERTZ)
        self.assertNotIn("speed after the collision", left_out(bounce))
        self.assertIn("coefficient of restitution", computed(bounce))
        cut = left_out(self.document("force", HERTZ, "--frames", ":22"))
        self.assertIn("the dump ends", cut["coefficient of restitution"])

    def test_estimate(self):
        document = self.plan(SAMPLE)
        estimate = document["estimate"]
        self.assertEqual((document["frames"], document["frames_source"]), (47, "counted"))
        self.assertGreater(estimate["seconds"], 0)
        self.assertGreater(estimate["factor"], 1)
        self.assertGreater(estimate["bytes"], 5e6)
        self.assertEqual(estimate["input_bytes"], SAMPLE.stat().st_size)
        self.assertAlmostEqual(sum(part["seconds"] for part in estimate["parts"]),
                               estimate["processor_seconds"])
        self.assertLessEqual(estimate["seconds"], estimate["processor_seconds"])
        # id type x y z vx vy vz, of which the lattice needs ids
        self.assertEqual(estimate["numbers"], 47 * 1206 * 8)
        few = self.plan(SAMPLE, "--frames", ":6", "--for", "force")
        self.assertEqual(few["frames"], 6)
        self.assertEqual(few["estimate"]["numbers"], 6 * 1206 * 7)
        self.assertLess(few["estimate"]["seconds"], estimate["seconds"])
        table = self.table("plan", SAMPLE)
        self.assertEqual(len(table["seconds"]), len(estimate["parts"]))

    def test_terminal(self):
        text = self.mdana("plan", SAMPLE).stdout
        for line in (r"columns +8 of 8 read", r"contact radius +.* ms", r"Hertz fit +the scene is adhesive", r"estimate +about"):
            self.assertRegex(text, line)

    def test_refusals(self):
        self.refused("plan", self.dir / "missing.dump", says=["missing.dump"])
        self.refused("plan", SAMPLE, "--frames", "1000:", says=["none chosen"])
        self.refused("plan", self.dir, says=["scene.toml"])

    def test_is_fast_where_the_file_is_large(self):
        """Frames that are the first one again and again: counted for a quarter of a second, then taken for alike."""
        frame = dumps.split(dumps.read_text(SAMPLE))[0]
        dump = self.dir / "dump.lammpstrj"
        with open(dump, "w", encoding="utf-8") as file:
            for k in range(3000):
                file.write(frame.replace("TIMESTEP\n4672", f"TIMESTEP\n{4672 + k}").replace("TIME\n36.5", f"TIME\n{36.5 + k}"))
        start = time.monotonic()
        document = self.plan(dump, "--for", "force", "--scene", SAMPLE.parent / "scene.toml")
        self.assertLess(time.monotonic() - start, 20)
        self.assertLess(abs(document["frames"] - 3000), 30)


class StudyPlans(Study):
    def test_runs_and_total(self):
        document = self.document("plan", self.runs)
        runs = {run["name"]: run for run in document["runs"]}
        self.assertEqual(set(runs), set(NAMES))
        self.assertAlmostEqual(document["estimate"]["seconds"], sum(run["estimate"]["seconds"] for run in runs.values()))
        self.assertIn("Hertz fit", computed(runs["hertz-tiny"]))
        self.assertIn("JKR (laws with adhesion)", computed(runs["adhesive-tiny"]))  # E* is that of hertz-tiny
        table = self.table("plan", self.runs)
        self.assertEqual(sorted(table["run"]), sorted(NAMES))
        self.assertFalse((self.runs / "cache").exists())

    def test_settings_are_reasons(self):
        runs = {run["name"]: run for run in self.document("plan", self.study())["runs"]}
        for what, setting in (("lattice defects", "defects"), ("error against run time", "accuracy"),
                              ("numerical stability", "stability")):
            self.assertEqual(left_out(runs["hertz-tiny"])[what], f"the study file says {setting} = false")

    def test_results_say_the_same_and_cost_nothing(self):
        study = self.study(defects=True)
        before = {run["name"]: run for run in self.document("plan", study)["runs"]}
        self.report()
        for run in self.results()["runs"]:
            plan = before[run["name"]]
            self.assertEqual(set(computed(run)) - set(computed(plan)), set())
            settled = set(computed(plan)) - set(computed(run))
            self.assertLessEqual(settled, set(left_out(run)), "what turned out not to be possible is told")
            self.assertLessEqual(set(left_out(plan).items()), set(left_out(run).items()))
        page = (self.out / "index.html").read_text(encoding="utf-8")
        for text in ("What was left out and why", "no attraction", "Computed:", "the best that the dump has"):
            self.assertIn(text, page)
        after = self.document("plan", study, "--report", self.out)
        self.assertEqual([run["cached"] for run in after["runs"]], [True] * len(NAMES))
        self.assertEqual(after["estimate"]["seconds"], 0)
        self.edit("hertz-tiny", "velocity", "velocity")
        (self.runs / "hertz-tiny" / "scene.toml").open("a", encoding="utf-8").write("\n# changed\n")
        changed = {run["name"]: run for run in self.document("plan", study, "--report", self.out)["runs"]}
        self.assertFalse(changed["hertz-tiny"]["cached"])
        self.assertRegex(changed["hertz-tiny"]["state"], "scene.toml")
        self.assertTrue(changed["aggregate-tiny"]["cached"])

    def test_a_run_that_fails_is_told(self):
        (self.runs / "hertz-tiny" / "dump.lammpstrj.gz").unlink()
        document = self.document("plan", self.runs)
        [failed] = [run for run in document["runs"] if "failure" in run]
        self.assertEqual(failed["name"], "hertz-tiny")
        self.assertRegex(failed["failure"], "[Nn]o such file")


if __name__ == "__main__":
    running.main()
