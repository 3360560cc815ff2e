#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Work-precision of one stiff collision: error of e against seconds, for `mdana predict` and SciPy's Radau and LSODA over
tolerances 1e-4 to 1e-12, against mdana at 1e-13.

    tests/bench/collisions.py MDANA [--law krijt|stress] [--velocity V]
"""

import argparse
import json
import math
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "oracles"))
sys.dont_write_bytecode = True

import test_collision_laws as oracle  # noqa: E402
from scipy.integrate import LSODA, Radau  # noqa: E402


def predicted(mdana, pair, law, velocity, tolerance, parameters):
    command = [mdana, *map(str, pair.arguments(law, velocity, nu=oracle.NU, spacing=oracle.SPACING, **parameters)),
               "--json", "--tolerance", str(tolerance)]
    runs = [json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout) for _ in range(5)]
    return runs[0]["e"], min(run["seconds"] for run in runs)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mdana")
    parser.add_argument("--law", choices=("krijt", "stress"), default="krijt")
    parser.add_argument("--velocity", type=float, default=0.1)
    options = parser.parse_args()
    pair = oracle.Pair(147)
    if options.law == "krijt":
        parameters, relaxation = {"T_vis": 0.075}, lambda a: 0.075
    else:
        parameters = {"C": 2.1e-4, "B": 6.2, "zeta": 4}
        relaxation = pair.stress_relaxation(2.1e-4, 6.2, 4)
    exact, _ = predicted(options.mdana, pair, options.law, options.velocity, 1e-13, parameters)
    print("integrator  tolerance   error of e   seconds")
    for power in range(-4, -13, -2):
        tolerance = 10.0**power
        e, seconds = predicted(options.mdana, pair, options.law, options.velocity, tolerance, parameters)
        print(f"mdana       {tolerance:9.0e}  {abs(e - exact):11.1e}  {seconds:.6f}")
        for method in (Radau, LSODA):
            start = time.perf_counter()
            e = oracle.free_radius(pair, options.velocity, relaxation, method, max(tolerance, 3e-14))
            error = math.nan if e is None else abs(e - exact)
            print(f"{method.__name__:11} {tolerance:9.0e}  {error:11.1e}  {time.perf_counter() - start:.6f}")


if __name__ == "__main__":
    main()
