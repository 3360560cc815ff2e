#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Work-precision of one stiff collision: error of e against milliseconds and evaluations of the right-hand side, for
`mdana predict` (with its check of the error) and SciPy's Radau and LSODA over tolerances 1e-4 to 1e-12; the error is the
difference from mdana at 1e-13. The table is Markdown.

    tests/bench/collisions.py MDANA [--law krijt|stress] [--velocity V]
"""

import argparse
import json
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "oracles"))
sys.dont_write_bytecode = True

import test_collision_laws as oracle  # noqa: E402
from scipy.integrate import LSODA, Radau  # noqa: E402


def predicted(mdana, pair, law, velocity, tolerance, parameters):
    """e, seconds (the best of five) and evaluations."""
    command = [mdana, *map(str, pair.arguments(law, velocity, nu=oracle.NU, spacing=oracle.SPACING, **parameters)),
               "--json", "--tolerance", str(tolerance)]
    runs = [json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout) for _ in range(5)]
    return runs[0]["e"], min(run["seconds"] for run in runs), runs[0]["evaluations"]


def by_scipy(method, pair, velocity, relaxation, tolerance):
    """The same; e is None if the integrator gives up."""
    evaluations = 0

    def counted(a):  # once in every right-hand side
        nonlocal evaluations
        evaluations += 1
        return relaxation(a)

    start = time.perf_counter()
    e = oracle.free_radius(pair, velocity, counted, method, max(tolerance, 3e-14))
    return e, time.perf_counter() - start, evaluations


def cell(found, exact):
    e, seconds, evaluations = found
    error = "gives up" if e is None else f"{abs(e - exact):.0e}"
    return f"{error}, {1e3 * seconds:.3g} ms, {evaluations}"


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
    ask = (options.mdana, pair, options.law, options.velocity)
    exact = predicted(*ask, 1e-13, parameters)[0]
    print("| tolerance | mdana: error of e, time, evaluations | SciPy's Radau | SciPy's LSODA |\n|---|---|---|---|")
    for power in range(-4, -13, -2):
        tolerance = 10.0**power
        cells = [cell(predicted(*ask, tolerance, parameters), exact)]
        cells += [cell(by_scipy(method, pair, options.velocity, relaxation, tolerance), exact) for method in (Radau, LSODA)]
        print(f"| {tolerance:.0e} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
