# SPDX-License-Identifier: GPL-3.0-or-later
"""A study: its file, the cache of its report, what is run anew and why, and stops at any moment."""

import re
import shutil
import signal
import subprocess

import running
from running import main, run
from studies import NAMES, SAMPLE, StoppedStudy, Study


class StudyFile(Study):
    def test_runs_with_another_attraction_are_a_group_of_their_own(self):
        self.edit("adhesive-tiny", "gamma = 3.17", "")
        groups = re.findall(r'(?m)^group = "(.*)"', self.mdana("study", "init", self.runs, "--print").stdout)
        self.assertIn("adhesive, gamma not known, R = 5", groups)

    def test_init_lists_the_runs(self):
        done = self.mdana("study", "init", self.runs)
        self.assertEqual(done.stdout, f"{self.runs / 'study.toml'}\n")
        text = (self.runs / "study.toml").read_text(encoding="utf-8")
        for name in NAMES:
            self.assertIn(f'name = "{name}"\nscene = "{name}/scene.toml"', text)
        for group in ("adhesive, R = 5", "aggregate, phi = 0.4, R = 800", "hertz, R = 5"):
            self.assertIn(f'group = "{group}"', text)
        self.assertEqual(self.mdana("study", "init", self.runs, "--print").stdout, text)

    def test_dumps_without_a_scene_are_named(self):
        shutil.copy(SAMPLE / "hertz-tiny" / "dump.lammpstrj.gz", self.runs / "bare.lammpstrj.gz")
        text = self.mdana("study", "init", self.runs, "--print").stdout
        self.assertIn("#   bare.lammpstrj.gz", text)
        self.assertNotIn("#   hertz-tiny", text)

    def test_an_edited_file_is_not_replaced(self):
        file = self.study()
        before = file.read_text(encoding="utf-8")
        self.assertIn("--force", self.mdana("study", "init", self.runs, code=1).stderr)
        self.assertEqual(file.read_text(encoding="utf-8"), before)
        self.mdana("study", "init", self.runs, "--force")
        self.assertNotEqual(file.read_text(encoding="utf-8"), before)

    def test_faults_are_told_with_their_lines(self):
        file = self.study()
        good = file.read_text(encoding="utf-8")
        for old, new, says in [
            ("schema = 1", "schema = 2", "schema"),
            ("accuracy = false", "accurate = false", "checks.accurate: unknown key"),
            ("accuracy = false", 'accuracy = "no"', "true or false"),
            ('laws = ["jkr"]', 'laws = ["jkrr"]', "none of"),
            ('"phase-plane"]', '"Force"]', "'Force' is none of"),
            ('name = "hertz-tiny"', 'name = "adhesive-tiny"', "stands twice"),
            ('name = "hertz-tiny"', 'name = ""', "needs one"),
            ('scene = "hertz-tiny/scene.toml"', "", "needs a scene file"),
            ("[figures]", "[figures", "study.toml:"),
        ]:
            with self.subTest(new):
                self.assertIn(old, good)
                file.write_text(good.replace(old, new), encoding="utf-8")
                message = self.report(code=1).stderr
                self.assertIn("study.toml", message)
                self.assertIn(says, message)
                self.assertFalse(self.out.exists())

    def test_runs_of_one_name_are_told_apart(self):
        shutil.copytree(SAMPLE / "hertz-tiny", self.runs / "again")
        text = self.mdana("study", "init", self.runs, "--print").stdout
        self.assertIn('name = "again"', text)
        self.assertIn('name = "hertz-tiny"', text)


class Cache(Study):
    def test_only_what_changed_is_run_anew(self):
        self.study()
        self.assertEqual({state.split(":")[0] for state in self.plan().values()}, {"to run", "to run if changed"})
        first = self.report().stderr
        self.assertIn("3 runs: 3 analysed anew, 0 from the cache, 0 failed", first)
        before = self.files(self.out)
        self.assertEqual(set(self.plan().values()), {"cached"})
        second = self.report().stderr
        self.assertIn("3 runs: 0 analysed anew, 3 from the cache, 0 failed", second)
        self.assertEqual(self.files(self.out), before)

        self.edit("aggregate-tiny", "filling_factor = 0.4", "filling_factor = 0.41")
        plan = self.plan()
        self.assertEqual(plan["aggregate-tiny"], "to run: changed: aggregate-tiny/scene.toml")
        self.assertEqual([plan[name] for name in ("adhesive-tiny", "hertz-tiny")], ["cached", "cached"])
        self.assertIn("1 analysed anew, 2 from the cache", self.report().stderr)
        phi = {r["name"]: r for r in self.results()["runs"]}["aggregate-tiny"]["phi"]["value"]
        self.assertEqual(phi, 0.41)

    def test_a_changed_dump_or_setting(self):
        file = self.study()
        self.report()
        dump = self.runs / "hertz-tiny" / "dump.lammpstrj.gz"
        dump.write_bytes(dump.read_bytes() + subprocess.run(["gzip", "-c"], input=b"\n", capture_output=True, check=True).stdout)
        plan = self.plan()
        self.assertEqual(plan["hertz-tiny"], "to run: changed: hertz-tiny/dump.lammpstrj.gz")
        self.assertIn("after hertz-tiny", plan["adhesive-tiny"])  # whose R places its delta
        self.assertEqual(plan["aggregate-tiny"], "cached")
        # The blank line changes no number of the Hertz run, so that the adhesive one is as it was.
        self.assertIn("1 analysed anew, 2 from the cache", self.report().stderr)
        file.write_text(file.read_text().replace("stability = false", "stability = true"))
        self.assertTrue(all("settings" in state or "after" in state for state in self.plan().values()))

    def test_a_damaged_cache_is_run_anew(self):
        self.study()
        self.report()
        record = self.out / "cache" / "hertz-tiny.run"
        data = bytearray(record.read_bytes())
        data[len(data) // 2] ^= 1
        record.write_bytes(data)
        self.assertTrue(self.plan()["hertz-tiny"].startswith("to run: no result yet"))
        self.report()
        self.assertEqual(set(self.plan().values()), {"cached"})

    def test_a_dry_run_writes_nothing(self):
        self.study()
        self.plan()
        self.assertFalse(self.out.exists())

    def test_only(self):
        self.study()
        done = self.report("--only", "hertz*")
        self.assertIn("1 analysed anew", done.stderr)
        self.assertEqual({run["name"]: "not_run" in run for run in self.results()["runs"]},
                         {"adhesive-tiny": True, "aggregate-tiny": True, "hertz-tiny": False})
        self.assertIn("--only", (self.out / "index.html").read_text(encoding="utf-8"))
        self.report()
        self.report("--only", "adhesive-tiny")  # keeps the results of the others
        self.assertFalse(any("not_run" in run for run in self.results()["runs"]))
        self.assertIn("hertz-tiny", self.report("--only", "nothing", code=1).stderr)

    def test_only_runs_what_the_chosen_ones_need(self):
        """R of the Hertz run places delta of the adhesive one: without it the result would be another one."""
        self.study()
        self.report("--only", "adhesive*")
        alone = {run["name"]: run for run in self.results()["runs"]}
        self.assertIn("not_run", alone["aggregate-tiny"])
        self.report()
        whole = {run["name"]: run for run in self.results()["runs"]}
        self.assertEqual(whole["adhesive-tiny"], alone["adhesive-tiny"])
        self.assertIn("Hertz fit of run hertz-tiny", whole["adhesive-tiny"]["radius_source"])

    def test_a_broken_run_is_told_and_does_not_stop_the_others(self):
        self.study()
        dump = self.runs / "adhesive-tiny" / "dump.lammpstrj.gz"
        whole = dump.read_bytes()
        dump.write_bytes(b"no dump\n")
        done = self.report(code=1)
        self.assertIn("1 failed", done.stderr)
        by_name = {run["name"]: run for run in self.results()["runs"]}
        self.assertIn("dump.lammpstrj.gz", by_name["adhesive-tiny"]["failure"])
        self.assertIn("delta_max", by_name["hertz-tiny"])
        self.assertIn("adhesive-tiny", (self.out / "index.html").read_text(encoding="utf-8"))
        rows = self.rows()
        self.assertEqual({row["run"]: row["state"] for row in rows},
                         {"adhesive-tiny": "failed", "aggregate-tiny": "measured", "hertz-tiny": "measured"})
        dump.write_bytes(whole)
        self.assertIn("1 analysed anew, 2 from the cache, 0 failed", self.report().stderr)

    def test_a_scene_that_cannot_be_read_is_a_broken_run(self):
        self.study()
        self.edit("hertz-tiny", "schema = 1", "schema = 7")
        self.report(code=1)
        self.assertIn("schema", {r["name"]: r for r in self.results()["runs"]}["hertz-tiny"]["failure"])


class Stops(StoppedStudy):
    def test_killed_at_any_moment_it_goes_on(self):
        """Before, within and after the first run, while the page is written. At fifty moments: tests/long."""
        self.kill_at((0.02, 0.2, 0.4, 0.6, 0.8, 0.9, 0.97))

    def test_a_signal_stops_it_and_it_says_what_is_kept(self):
        self.study(stability=True, accuracy=True)
        process = subprocess.Popen([running.program, "report", str(self.runs / "study.toml"), "-o", str(self.out)],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.wait_for_cache()
        process.send_signal(signal.SIGTERM)
        _, error = process.communicate(timeout=running.SECONDS)
        self.assertEqual(process.returncode, 75, error)
        self.assertIn("goes on from there", error)
        self.report()

    def test_the_second_of_two_processes_is_told(self):
        self.study(stability=True, accuracy=True)
        first = self.start()
        try:
            self.wait_for_cache()
            second = run("report", self.runs / "study.toml", "-o", self.out)
            self.assertEqual(second.returncode, 1)
            self.assertIn("another mdana report", second.stderr)
        finally:
            self.assertEqual(first.wait(timeout=running.SECONDS), 0)
        self.report()


if __name__ == "__main__":
    main()
