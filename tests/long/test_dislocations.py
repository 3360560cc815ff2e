#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""All crystals with known dislocations of tests/dislocations; some 4 minutes, or seconds with kept ones: MDANA_LONG_RUNS
names a folder whose folder dislocations/ is kept."""
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent.parent / "dislocations"
sys.path.insert(0, str(HERE))
import found  # noqa: E402
import make_cases  # noqa: E402

with tempfile.TemporaryDirectory() as directory:
    directory = pathlib.Path(directory)
    kept = pathlib.Path(os.environ.get("MDANA_LONG_RUNS", directory)) / "dislocations"
    missing = [name for name in make_cases.CASES if not (kept / name / "truth.json").exists()]
    if missing:
        made = subprocess.run([sys.executable, HERE / "make_cases.py", kept, *missing], capture_output=True, text=True)
        assert made.returncode == 0, made.stdout + made.stderr
    failures = []
    for name in make_cases.CASES:
        try:
            print(found.check(sys.argv[1], kept / name, directory))
        except AssertionError as error:
            failures.append(str(error))
    print("\n".join(failures))
    sys.exit(1 if failures else 0)
