# SPDX-License-Identifier: GPL-3.0-or-later
"""A study that several processes do: its tasks, shards that are killed, stopped, missing or of other divisions, and the
report that is merged of them, which is that of a single process."""

import json
import random
import re
import shutil
import signal
import subprocess
import time

import running
from running import main, run
from studies import NAMES, Study


class Sweep(Study):
    def setUp(self):
        super().setUp()
        self.toml = self.runs / "study.toml"

    def task(self, task, of, *arguments, code=0, out=None):
        return self.mdana("run", self.toml, "--task", task, "--of", of, "-o", out or self.out, "--jobs", 1, "--threads", 1,
                          *arguments, code=code)

    def start(self, task, of):
        return subprocess.Popen([running.program, "run", str(self.toml), "--task", str(task), "--of", str(of), "-o", str(self.out),
                                 "--jobs", "1", "--threads", "1"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def all_tasks(self, of):
        """Side by side; what they say."""
        processes = [self.start(task, of) for task in range(1, of + 1)]
        told = [process.communicate(timeout=running.SECONDS)[1] for process in processes]
        self.assertEqual([process.returncode for process in processes], [0] * of, told)
        return told

    def merge(self, *arguments, code=0, out=None):
        return self.mdana("merge", self.toml, "-o", out or self.out, *arguments, code=code)

    def single(self):
        """What one process makes of the study."""
        out = self.dir / "single"
        self.report(out=out)
        return self.files(out)

    def assert_is(self, whole, out=None):
        found = self.files(out or self.out)
        self.assertEqual(found.keys(), whole.keys())
        for name, content in found.items():
            self.assertEqual(content, whole[name], name)

    def shard_files(self):
        return {str(p.relative_to(self.out)): p.stat().st_mtime_ns for p in (self.out / "shards").rglob("*.run")}


class Tasks(Sweep):
    def plan(self, *arguments):
        return self.document("plan", "--tasks", self.toml, *arguments)

    def test_every_run_is_in_one_task(self):
        self.study()
        for of in (1, 2, 3, 5):
            plan = self.plan("--of", of)
            self.assertEqual([(t["task"], t["of"]) for t in plan["tasks"]], [(k + 1, of) for k in range(of)])
            self.assertEqual(sorted(name for t in plan["tasks"] for name in t["runs"]), sorted(NAMES))
            for task in plan["tasks"]:
                # R of the Hertz run places delta of the adhesive one.
                alone = "adhesive-tiny" in task["runs"] and "hertz-tiny" not in task["runs"]
                self.assertEqual(task["besides"], ["hertz-tiny"] if alone else [])
                self.assertEqual(task["command"], f"mdana run {self.toml} --task {task['task']} --of {of} -o OUT")

    def test_times_are_those_of_the_runs(self):
        self.study()
        plan = self.plan("--of", 2)
        seconds = {r["name"]: r["seconds"] for r in plan["runs"]}
        memory = {r["name"]: r["bytes"] for r in plan["runs"]}
        self.assertTrue(all(s > 0 for s in seconds.values()))
        for task in plan["tasks"]:
            names = task["runs"] + task["besides"]
            self.assertAlmostEqual(task["seconds"], sum(seconds[name] for name in names), delta=1e-9)
            self.assertEqual(task["bytes"], max(memory[name] for name in names))
        longest = max(task["seconds"] for task in plan["tasks"])
        self.assertEqual([d["of"] for d in plan["divisions"]], [1, 2])
        self.assertAlmostEqual(plan["divisions"][1]["seconds"], longest, delta=1e-9)

    def test_small_studies_need_no_division(self):
        self.study()
        plan = self.plan()
        self.assertEqual(plan["sensible"], 1)
        self.assertEqual(plan["of"], 1)
        self.assertEqual([d["of"] for d in plan["divisions"]], [1, 2, 3])

    def test_heavy_runs_are_apart(self):
        """Two dumps that are much larger than the others are never in one of two tasks."""
        for k in (1, 2):
            copy = self.runs / f"large-{k}"
            shutil.copytree(self.runs / "aggregate-tiny", copy)
            scene = (copy / "scene.toml").read_text().replace('name = "aggregate-tiny"', f'name = "large-{k}"')
            (copy / "scene.toml").write_text(scene)
            dump = copy / "dump.lammpstrj.gz"
            dump.write_bytes(dump.read_bytes() * 20)
        self.study()
        plan = self.plan("--of", 2)
        self.assertEqual([sum(name.startswith("large") for name in t["runs"]) for t in plan["tasks"]], [1, 1])

    def test_usage(self):
        self.study()
        for arguments in (["--task", 0, "--of", 2], ["--task", 3, "--of", 2], ["--task", 1], ["--of", 2],
                          ["--task", 1, "--of", 10**9]):
            self.assertEqual(run("run", self.toml, "-o", self.out, *arguments).returncode, 2, arguments)
        for arguments in (["--of", 2], ["--tasks", "--only", "h*"], ["--tasks", "--of", 0]):
            self.assertEqual(run("plan", self.toml, *arguments).returncode, 2, arguments)
        self.assertEqual(run("plan", "--tasks", self.runs / "hertz-tiny" / "dump.lammpstrj.gz").returncode, 2)
        self.assertFalse(self.out.exists())

    def test_a_place_with_something_else_is_not_taken(self):
        self.study()
        self.out.mkdir()
        (self.out / "thesis.txt").write_text("years")
        self.assertIn("not a report", self.task(1, 2, code=1).stderr)


class Merged(Sweep):
    def test_any_division_gives_the_report_of_one_process(self):
        self.study()
        whole = self.single()
        for of in (1, 2, 4):
            with self.subTest(of):
                shutil.rmtree(self.out, ignore_errors=True)
                self.all_tasks(of)
                done = self.merge()
                self.assertEqual(done.stdout, f"{self.out / 'index.html'}\n")
                self.assert_is(whole)
                self.assertIn("as the report was made", self.mdana("verify", self.out).stdout)
                self.assertIn("0 analysed anew, 3 from the cache", self.report().stderr)

    def test_each_task_says_what_it_did(self):
        self.study()
        self.all_tasks(2)
        found = {}
        for task in (1, 2):
            document = json.loads((self.out / "shards" / f"{task}-of-2" / "task.json").read_text())
            self.assertEqual((document["task"], document["of"]), (task, 2))
            found |= {r["name"]: r["state"] for r in document["runs"]}
        self.assertEqual(found, {name: "done" for name in NAMES})

    def test_missing_tasks_are_listed(self):
        self.study()
        whole = self.single()
        self.task(1, 2)
        done = self.merge(code=1)
        self.assertIn("task 2 of 2 has not begun", done.stderr)
        self.assertIn(f"mdana run {self.toml} --task 2 --of 2 -o {self.out}\n", done.stderr)
        self.assertNotIn("task 1 of 2", done.stderr)
        self.assertFalse((self.out / "index.html").exists())
        listed = json.loads(self.merge("--json", code=1).stdout)["missing"]
        self.assertEqual([(m["task"], m["begun"]) for m in listed], [(2, False)])
        there = json.loads((self.out / "shards" / "1-of-2" / "task.json").read_text())["runs"]
        self.assertEqual(sorted(listed[0]["runs"] + [r["name"] for r in there]), sorted(NAMES))
        for m in listed:  # the listed commands make what is missing
            self.mdana(*m["command"].split()[1:])
        self.merge()
        self.assert_is(whole)

    def test_a_partial_report_says_what_is_missing(self):
        self.study()
        whole = self.single()
        self.task(1, 2)
        there = {r["name"] for r in json.loads((self.out / "shards" / "1-of-2" / "task.json").read_text())["runs"]}
        done = self.merge("--partial")
        self.assertIn("task 2 of 2 has not begun", done.stderr)
        for document in self.results()["runs"]:
            if document["name"] in there:
                self.assertNotIn("not_run", document)
            else:
                self.assertIn("task 2 of 2", document["not_run"])
        self.assertIn("task 2 of 2", (self.out / "index.html").read_text(encoding="utf-8"))
        self.task(2, 2)
        self.merge()
        self.assert_is(whole)

    def test_without_any_shard(self):
        self.study()
        self.assertIn("mdana run", self.merge(code=1).stderr)

    def test_another_division_takes_what_is_there(self):
        self.study()
        self.all_tasks(2)
        for task in (1, 2, 3):
            told = self.task(task, 3).stderr
            self.assertIn("0 analysed anew", told)
            self.assertIn("from the cache", told)

    def test_a_changed_dump_makes_a_shard_old(self):
        self.study()
        self.all_tasks(2)
        scene = self.runs / "aggregate-tiny" / "scene.toml"
        scene.write_text(scene.read_text() + "\n# another\n")
        done = self.merge(code=1)
        self.assertIn("aggregate-tiny", done.stderr)
        self.assertNotIn("hertz-tiny", done.stderr)

    def test_a_damaged_record_is_missing(self):
        self.study()
        self.all_tasks(2)
        [record] = (self.out / "shards").rglob("aggregate-tiny.run")
        record.write_bytes(record.read_bytes()[:-20])
        self.assertIn("aggregate-tiny", self.merge(code=1).stderr)

    def test_a_run_that_fails_is_told_as_by_one_process(self):
        self.study()
        (self.runs / "adhesive-tiny" / "dump.lammpstrj.gz").write_bytes(b"no dump\n")
        single = self.dir / "single"
        self.report(out=single, code=1)
        whole = self.files(single)
        codes = sorted(self.start_and_wait(task, 2) for task in (1, 2))
        self.assertEqual(codes, [0, 1])
        done = self.merge(code=1)
        self.assertIn("adhesive-tiny: ", done.stderr)
        self.assertNotIn("missing", done.stderr)
        self.assert_is(whole)

    def start_and_wait(self, task, of):
        process = self.start(task, of)
        process.communicate(timeout=running.SECONDS)
        return process.returncode


class Stops(Sweep):
    def test_killed_at_random_moments(self):
        """Three processes side by side, some killed at moments that a seed chooses, started again and killed again, then run to
        the end: no run that was done is done twice, and the report is that of a single process."""
        self.study(stability=True)
        whole = self.single()
        chance = random.Random(20261123)
        started = time.monotonic()
        self.all_tasks(3)
        seconds = time.monotonic() - started
        for round_ in range(2):
            shutil.rmtree(self.out)
            for attempt in range(2):
                processes = [self.start(task, 3) for task in (1, 2, 3)]
                for process in chance.sample(processes, 2):
                    time.sleep(chance.uniform(0, 0.45 * seconds))
                    process.kill()
                for process in processes:
                    process.communicate(timeout=running.SECONDS)
            before = self.shard_files()
            self.all_tasks(3)
            after = self.shard_files()
            self.assertEqual({name: after[name] for name in before}, before, "a run was done twice")
            self.merge()
            self.assert_is(whole)

    def test_signals(self):
        self.study(stability=True, accuracy=True)
        for number in (signal.SIGTERM, signal.SIGUSR1):
            with self.subTest(number.name):
                shutil.rmtree(self.out, ignore_errors=True)
                process = self.start(1, 1)
                deadline = time.monotonic() + running.SECONDS
                while not list(self.out.glob("shards/*/*.run")) and time.monotonic() < deadline:
                    time.sleep(0.01)
                process.send_signal(number)
                _, error = process.communicate(timeout=20)
                self.assertEqual(process.returncode, 75, error)
                self.assertIn("goes on from there", error)
                there = self.shard_files()
                self.assertEqual([p.name for p in self.out.rglob(".*part*")], [])
                told = self.task(1, 1).stderr
                self.assertEqual(len(re.findall("from the cache\n", told)), len(there), told)
                self.merge()


if __name__ == "__main__":
    main()
