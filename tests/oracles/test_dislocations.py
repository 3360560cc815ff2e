#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Dislocations that LAMMPS relaxed: mdana finds the lines that Burgers circuits prove; tests/long has all cases."""
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent.parent / "dislocations"
sys.path.insert(0, str(HERE))
import found  # noqa: E402

CASES = ["edge", "shockley_loop", "shockley_loop_0.05", "frank_interstitial", "prismatic", "tetrahedron"]

with tempfile.TemporaryDirectory() as directory:
    directory = pathlib.Path(directory)
    made = subprocess.run([sys.executable, HERE / "make_cases.py", directory / "cases", *CASES], capture_output=True, text=True)
    assert made.returncode == 0, made.stdout + made.stderr
    for name in CASES:
        print(found.check(sys.argv[1], directory / "cases" / name, directory))
