# SPDX-License-Identifier: GPL-3.0-or-later
"""Running the mdana program that a test was given, and what every run of it has to keep."""

import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SAMPLE = ROOT / "sample-data" / "adhesive-tiny" / "dump.lammpstrj.gz"
SKIPPED = 77  # what CTest takes for "skipped"
SECONDS = 60  # no run of these tests takes more than a few; beyond it hangs

program = None  # path of mdana, set by `main`


def run(*arguments, timeout=SECONDS, **settings):
    """mdana with the arguments; standard output and error as text."""
    settings = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | settings
    return subprocess.run([program, *map(str, arguments)], text=True, timeout=timeout, check=False, **settings)


def parse_json(text):
    """The one JSON document that the text is: no NaN, no name twice, nothing before or after."""

    def no_constant(name):
        raise ValueError(f"{name} is not JSON")

    def no_twins(pairs):
        if len({name for name, _ in pairs}) != len(pairs):
            raise ValueError(f"a name stands twice among {[name for name, _ in pairs]}")
        return dict(pairs)

    return json.loads(text, parse_constant=no_constant, object_pairs_hook=no_twins)


def read_csv(path):
    """Columns of a table by name: floats (None where empty) or, if they are no numbers, texts."""
    with open(path, newline="", encoding="utf-8") as file:
        head, *rows = list(csv.reader(file, strict=True))
    if any(len(row) != len(head) for row in rows):
        raise ValueError(f"{path}: a row has another length than the head")
    return {name: [value(row[k]) for row in rows] for k, name in enumerate(head)}


def value(cell):
    try:
        return float(cell) if cell else None
    except ValueError:
        return cell


def without_digits(told):
    """As a single command tells it, which does not move the digits of the dump."""
    if not isinstance(told, dict):
        return told
    return {key: without_digits(value) for key, value in told.items() if key not in ("stable_digits", "weak")}


class Case(unittest.TestCase):
    """A test with a directory of its own that the end of the test removes."""

    maxDiff = None

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        self.addCleanup(scratch.cleanup)
        self.dir = Path(scratch.name)

    def mdana(self, *arguments, code=0, **settings):
        """Runs mdana and insists on its exit code."""
        done = run(*arguments, **settings)
        self.assertEqual(done.returncode, code, f"mdana {' '.join(map(str, arguments))}\n{done.stderr}{done.stdout}")
        return done

    def document(self, *arguments, code=0):
        """The JSON document that mdana prints; nothing else may be on either output."""
        done = self.mdana(*arguments, "--json", code=code)
        self.assertEqual(done.stderr, "")
        return parse_json(done.stdout)

    def table(self, *arguments, code=0):
        """The table that mdana writes."""
        out = self.dir / "table.csv"
        self.mdana(*arguments, "-o", out, code=code)
        return read_csv(out)

    def refused(self, *arguments, code=1, says=()):
        """mdana must fail with the code and say why, print no result and leave no file; its message."""
        place = Path(tempfile.mkdtemp(dir=self.dir))
        done = self.mdana(*arguments, "-o", place / "out.json", code=code)
        self.assertEqual(done.stdout, "", "a failed command prints no results")
        self.assertEqual(os.listdir(place), [], "a failed command leaves no file")
        self.assertRegex(done.stderr, r"\Amdana: \S", "the message begins with the program's name")
        for text in says:
            self.assertIn(str(text), done.stderr)
        return done.stderr

    def told_by_info(self, path, *says):
        """`mdana info` must say of a dump that is readable what keeps everything else from being computed."""
        document = self.document("info", path)
        reasons = "\n".join(entry["reason"] for entry in document["left_out"])
        for text in says:
            self.assertIn(str(text), reasons)
        self.assertGreater(document["frames"], 0)
        return document

    def assert_close(self, found, wanted, tolerance, scale, what=""):
        """|found - wanted| <= tolerance * scale for every element of two series."""
        self.assertEqual(len(found), len(wanted), what)
        for k, (a, b) in enumerate(zip(found, wanted)):
            self.assertLessEqual(abs(a - b), tolerance * scale, f"{what}[{k}]: {a!r} against {b!r}")


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def main():
    """Runs the tests of the calling script with the program that is its first argument."""
    global program
    if len(sys.argv) < 2:
        sys.exit("usage: test_NAME.py PATH-OF-MDANA [unittest options]")
    program = str(Path(sys.argv.pop(1)).resolve())
    done = unittest.main(module="__main__", verbosity=2, exit=False)
    sys.exit(0 if done.result.wasSuccessful() else 1)
