# SPDX-License-Identifier: GPL-3.0-or-later
"""What the oracle tests share: the helpers of tests/cli, and runs of sample-data/generate."""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
sys.dont_write_bytecode = True

import numpy as np  # noqa: E402

import running  # noqa: E402

GENERATE = running.ROOT / "sample-data" / "generate"


def need_lammps():
    """Ends the test as skipped if there is no LAMMPS."""
    if not shutil.which("lmp"):
        running.skip("no LAMMPS: 'lmp' is not in the PATH (Debian: apt install lammps)")


def generate(*arguments, code=0, timeout=300, **settings):
    """Runs the generator and insists on its exit code."""
    done = subprocess.run([sys.executable, GENERATE, *map(str, arguments)], stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=timeout, check=False, **settings)
    if done.returncode != code:
        raise AssertionError(f"generate {' '.join(map(str, arguments))}: exit {done.returncode}, not {code}\n"
                             f"{done.stdout}{done.stderr}")
    return done


def ranks():
    """Two where MPI is there, which halves the time."""
    return 2 if shutil.which("mpirun") else 1


def vectors(path):
    """Rows of numbers for each step of a `mode vector` file of LAMMPS, without their indices: step -> array."""
    found, lines = {}, [line.split() for line in path.read_text().splitlines() if not line.startswith("#")]
    while lines:
        step, rows = lines.pop(0)
        found[int(step)] = np.array([[float(word) for word in lines.pop(0)[1:]] for _ in range(int(rows))])
    return found


def kept_runs(case):
    """The folder of a test class for runs: DIR of MDANA_LONG_RUNS=DIR, else one that goes with the class."""
    if kept := os.environ.get("MDANA_LONG_RUNS"):
        Path(kept).mkdir(parents=True, exist_ok=True)
        return Path(kept)
    scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
    case.addClassCleanup(scratch.cleanup)
    return Path(scratch.name)
