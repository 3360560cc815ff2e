#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Seconds of a fit of C, B, zeta (law stress) to 4 radii x 9 velocities from 8 starts, and of the same with profiles
and 200 bootstrap draws; with the collisions solved, and how far the fit is from what made the data (noise of e 0.005).
The peer is what it does without: as many collisions one by one. The table is Markdown.

    tests/bench/fits.py MDANA
"""

import argparse
import json
import random
import resource
import subprocess
import tempfile
from pathlib import Path

RADII = {29.6: 113637, 58.9: 914443, 88.4: 3120599, 147: 14434147}
VELOCITIES = (0.04, 0.06, 0.08, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5)
TRUTH = {"C": 2.1e-4, "B": 6.2, "zeta": 4}
MATERIAL = {"E": 55, "gamma": 3.17, "nu": 0.25, "spacing": 1.091}
NOISE = 0.005


def mdana(program, *arguments):
    """The document, and CPU seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, *map(str, arguments), "--json"], check=True, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return json.loads(done.stdout), after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def options(values):
    return [word for name, value in values.items() for word in ("-p", f"{name}={value!r}")]


def make_table(program, path):
    """Writes the table; CPU seconds of a collision."""
    noise, seconds = random.Random(1), 0.0
    lines = ["R,m,v,e,sigma"]
    for radius, mass in RADII.items():
        for v in VELOCITIES:
            found, took = mdana(program, "predict", "--law", "stress", *options({"R": radius, "m": mass, "v": v} | MATERIAL | TRUTH))
            seconds += found["seconds"]
            e = "" if found["outcome"] == "stick" else max(0.001, found["e"] + noise.gauss(0, NOISE))
            lines.append(f"{radius},{mass},{v},{e},{NOISE if e else ''}")
    path.write_text("\n".join(lines) + "\n")
    return seconds / (len(lines) - 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mdana")
    program = parser.parse_args().mdana
    with tempfile.TemporaryDirectory() as folder:
        table = Path(folder) / "runs.csv"
        each = make_table(program, table)
        print("| fit | CPU s | collisions | times one by one | greatest error of a parameter | standard errors |\n|---|---|---|---|---|---|")
        for what, more in (("8 starts", []), ("8 starts, profiles, 200 draws", ["--intervals", "--bootstrap", 200])):
            found, seconds = mdana(program, "fit-contact", "--law", "stress", table, *options(MATERIAL), *more)
            off = max((abs(p["value"] / TRUTH[name] - 1), p["error"] / TRUTH[name]) for name, p in found["parameters"].items())
            print(f"| {what} | {seconds:.1f} | {found['collisions']} | {seconds / (each * found['collisions']):.2f} | {off[0]:.1%} "
                  f"| {off[0] / off[1]:.1f} |", flush=True)


if __name__ == "__main__":
    main()
