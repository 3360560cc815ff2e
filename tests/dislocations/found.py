#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the lines that mdana finds with the truth of cases: lengths by family, and Burgers vectors through discs."""
import json
import pathlib
import subprocess

import numpy as np

# Lengths are within the tolerances of truth.json; what is known to fall short, and why.
SHORT = {
    # Within 1.8 of a {110} surface, whose two outer layers have no structure, a line is taken for a part of it.
    "film_across_2.0": 0.16,
    "film_across_2.5": 0.05,
    # Its core is wide while it moves; the shortest way within is taken.
    "shockley_loop_relaxed": 0.045,
}
# Frank loops of vacancies have dissociated after twenty steps (stair-rods 1.3 from Shockley partials all along);
# the partials of twin_crossing are 2.8 apart.
DISSOCIATED = {"frank_vacancy", "twin_crossing"}


def read_ca(path):
    """Burgers vector in space and points of each line of a Crystal Analysis file."""
    lines = iter(path.read_text().splitlines())
    clusters, found = {}, []
    for line in lines:
        word = line.split()
        if word[0] == "CLUSTER":
            assert next(lines) == "CLUSTER_STRUCTURE 1" and next(lines) == "CLUSTER_ORIENTATION"
            clusters[word[1]] = np.array([next(lines).split() for _ in range(3)], float)
        elif word[0] == "DISLOCATIONS":
            for _ in range(int(word[1])):
                next(lines)
                b = np.array(next(lines).split(), float)
                orientation = clusters[next(lines).strip()]
                points = np.array([next(lines).split() for _ in range(int(next(lines)))], float)
                found.append((orientation @ b, points))
            break
    return found


def through(lines, disc):
    """Sum of the Burgers vectors of the lines through a disc."""
    centre, normal = np.array(disc["centre"]), np.array(disc["normal"])
    total = np.zeros(3)
    for b, points in lines:
        height = (points - centre) @ normal
        for k in np.flatnonzero((height[:-1] < 0) != (height[1:] < 0)):
            part = height[k] / (height[k] - height[k + 1])
            place = points[k] + part * (points[k + 1] - points[k])
            if np.linalg.norm(place - centre) < disc["radius"]:
                total += b if height[k] < 0 else -b
    return total


def look(mdana, case, directory):
    """Result of mdana and lines of a case."""
    run = subprocess.run([mdana, "defects", case / "dump.lammpstrj", "--frames", "last", "--no-surface", "--json",
                          "--ca", directory / case.name], capture_output=True, text=True)
    assert run.returncode == 0, f"{case.name}: {run.stderr}"
    (ca,) = directory.glob(f"{case.name}.*.ca")
    return json.loads(run.stdout)["frames"][-1], read_ca(ca)


def check(mdana, case, directory):
    """Throws AssertionError where mdana is wrong about a case; what was found, as text."""
    truth = json.loads((case / "truth.json").read_text())
    frame, lines = look(mdana, case, directory)
    assert frame["burgers_residual"] == 0, f"{case.name}: {frame['burgers_residual']} leads nowhere"
    edge = truth["edge"]
    for disc in truth["discs"]:
        found = through(lines, disc)
        wanted = edge / 6 * np.array(truth["orientation"]) @ disc["burgers"]
        if case.name.startswith("twin"):  # in axes of the twin
            found, wanted = np.linalg.norm(found), np.linalg.norm(wanted)
        assert np.linalg.norm(found - wanted) < 0.12 * edge, f"{case.name}: {found} through a disc with {wanted}"
    families = {name: (told["segments"], told["length"]["value"]) for name, told in frame["lines"].items() if told["segments"]}
    if case.name not in DISSOCIATED:
        check_lengths(case.name, truth, families)
    return f"{case.name}: " + ", ".join(f"{count} {name} {length:.1f}" for name, (count, length) in families.items())


def check_lengths(name, truth, families):
    wanted = truth.get("families")
    if not wanted:
        return
    assert set(wanted) == set(families), f"{name}: {sorted(families)} instead of {sorted(wanted)}"
    tolerance = truth["tolerance"]
    for family, told in wanted.items():
        count, length = families[family]
        assert count == told["lines"], f"{name}: {count} of {family} instead of {told['lines']}"
        allowed = tolerance.get("ends", 0) * told["lines"] + tolerance.get("relative", 0) * told["length"]
        allowed = max(allowed, SHORT.get(name, 0) * told["length"])
        assert abs(length - told["length"]) <= allowed, f"{name}: {family} {length:.2f} instead of {told['length']:.2f} +- {allowed:.2f}"
