# SPDX-License-Identifier: GPL-3.0-or-later
"""The job script and the Snakefile of sample-data/cluster: the script without SLURM, with a scontrol that only notes what it is
asked; the Snakefile where there is Snakemake (Debian: apt install snakemake)."""

import os
import shutil
import signal
import subprocess
import time
import unittest

import running
from running import ROOT, main
from studies import Study

CLUSTER = ROOT / "sample-data" / "cluster"


class Readme(unittest.TestCase):
    def test_it_shows_both_files(self):
        text = (ROOT / "README.md").read_text(encoding="utf-8")
        for name, first in (("sbatch.sh", "#SBATCH --job-name"), ("Snakefile", "STUDY =")):
            whole = (CLUSTER / name).read_text(encoding="utf-8")
            self.assertIn(whole[whole.index(first):] + "```", text)


class JobScript(Study):
    def setUp(self):
        super().setUp()
        self.study(stability=True, accuracy=True)
        programs = self.dir / "programs"
        programs.mkdir()
        (programs / "scontrol").write_text(f'#!/bin/sh\necho "$@" >> {self.dir}/scontrol.txt\n')
        (programs / "scontrol").chmod(0o755)
        self.environment = os.environ | {"MDANA": running.program, "PATH": f"{programs}:{os.environ['PATH']}",
                                         "SLURM_JOB_ID": "4711", "SLURM_CPUS_PER_TASK": "1"}

    def start(self, task, of):
        return subprocess.Popen(["bash", str(CLUSTER / "sbatch.sh"), str(self.runs / "study.toml"), str(self.out), str(of)],
                                env=self.environment | {"SLURM_ARRAY_TASK_ID": str(task)}, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def finish(self, process):
        _, error = process.communicate(timeout=2 * running.SECONDS)
        return process.returncode, error

    def test_a_task_whose_time_is_over_is_queued_again_and_goes_on(self):
        for number in (signal.SIGUSR1, signal.SIGTERM):
            with self.subTest(number.name):
                shutil.rmtree(self.out, ignore_errors=True)
                (self.dir / "scontrol.txt").unlink(missing_ok=True)
                process = self.start(1, 1)
                deadline = time.monotonic() + running.SECONDS
                while not list(self.out.glob("shards/*/*.run")) and time.monotonic() < deadline:
                    time.sleep(0.01)
                process.send_signal(number)  # to the script alone, as --signal=B: does
                code, error = self.finish(process)
                self.assertEqual(code, 75, error)
                self.assertEqual((self.dir / "scontrol.txt").read_text(), "requeue 4711\n")
                code, error = self.finish(self.start(1, 1))
                self.assertEqual(code, 0, error)
                self.assertIn("from the cache", error)
                self.mdana("merge", self.runs / "study.toml", "-o", self.out)

    def test_a_task_that_fails_is_not_queued_again(self):
        (self.runs / "hertz-tiny" / "dump.lammpstrj.gz").write_bytes(b"no dump\n")
        code, error = self.finish(self.start(1, 1))
        self.assertEqual(code, 1, error)
        self.assertFalse((self.dir / "scontrol.txt").exists())

    def test_usage(self):
        done = subprocess.run(["bash", str(CLUSTER / "sbatch.sh")], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("usage", done.stderr)


@unittest.skipUnless(shutil.which("snakemake"), "no snakemake (Debian: apt install snakemake)")
class Snakemake(Study):
    def snakemake(self, *arguments):
        return subprocess.run(["snakemake", "-s", str(CLUSTER / "Snakefile"), "--cores", "2", "--nolock", *arguments, "--config",
                               f"study={self.runs / 'study.toml'}", f"out={self.out}", "tasks=2", f"mdana={running.program}"],
                              cwd=self.dir, env=os.environ | {"HOME": str(self.dir), "XDG_CACHE_HOME": str(self.dir / "cache")},
                              capture_output=True, text=True, check=False, timeout=4 * running.SECONDS)

    def test_tasks_and_report(self):
        self.study()
        single = self.dir / "single"
        self.report(out=single)
        done = self.snakemake()
        self.assertEqual(done.returncode, 0, done.stderr)
        whole, found = self.files(single), self.files(self.out)
        self.assertEqual(found.keys(), whole.keys())
        for name, content in found.items():
            self.assertEqual(content, whole[name], name)
        again = self.snakemake()
        self.assertIn("Nothing to be done", again.stdout + again.stderr)


if __name__ == "__main__":
    main()
