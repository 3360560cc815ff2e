#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the preset `lean`, and compares what it links and says with the whole build.

With MDANA_LEAN_BUILD=DIR it is built there, and goes on from what is there."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

import running
from running import ROOT, SAMPLE

HERTZ = SAMPLE.parents[1] / "hertz-tiny" / "dump.lammpstrj.gz"
NOT_LINKED = ("libhdf5", "libnetcdf", "libmpi", "libgmp", "libmpfr")  # the last two are CGAL's


def libraries(program):
    lines = subprocess.run(["ldd", program], text=True, capture_output=True, check=True).stdout.splitlines()
    return {line.split()[0] for line in lines}


class LeanBuild(running.Case):
    @classmethod
    def setUpClass(cls):
        kept = os.environ.get("MDANA_LEAN_BUILD")
        cls.build = Path(kept) if kept else ROOT / "build-lean-test"
        if not kept:
            cls.addClassCleanup(shutil.rmtree, cls.build, ignore_errors=True)
        for command in (["cmake", "--preset", "lean", "-B", cls.build], ["cmake", "--build", cls.build]):
            done = subprocess.run(command, cwd=ROOT, text=True, capture_output=True, timeout=7000, check=False)
            if done.returncode:
                raise AssertionError(done.stdout[-3000:] + done.stderr[-3000:])
        cls.lean = cls.build / "mdana"

    def lean_run(self, *arguments):
        return subprocess.run([self.lean, *map(str, arguments)], text=True, capture_output=True, timeout=60, check=False)

    def test_links_less(self):
        lean, whole = libraries(self.lean), libraries(running.program)
        self.assertLess(len(lean), len(whole))
        self.assertFalse([name for name in lean if name.startswith(NOT_LINKED)], lean)
        self.assertTrue([name for name in whole if name.startswith("libhdf5")], whole)
        self.assertLess(self.lean.stat().st_size, Path(running.program).stat().st_size)

    def test_has_its_commands_only(self):
        listed = self.lean_run("--help").stdout.split("commands:\n", 1)[1].split("\n\n", 1)[0].split("\n")
        self.assertEqual([line.split()[0] for line in listed if line.strip()], ["force", "fit-hertz"])

    def test_says_the_same(self):
        for command in ("force", "fit-hertz"):
            lean = running.parse_json(self.lean_run(command, HERTZ, "--json").stdout)
            whole = self.document(command, HERTZ)
            for document in (lean, whole):
                for time in ("seconds", "fit_seconds"):
                    document.pop(time, None)
            self.assertEqual(lean, whole)


if __name__ == "__main__":
    running.main()
