#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Defects of a real collision followed in time: spheres of radius 10 that stick at v = 0.5, made by LAMMPS, which labels
the atoms of the same frames, too.

With MDANA_LONG_RUNS=DIR the run is kept in DIR, and taken from there if it is there."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "oracles"))

import numpy as np

import lammps
import running

RADIUS, SPACING = 10, 1.091
LABELS = """compute cna all cna/atom 1.317
dump labels all custom 128 labels.dump id c_cna
dump_modify labels sort id
"""


def labels(path):
    """Step -> LAMMPS' labels by id: 1 fcc, 2 hcp, other numbers neither."""
    found, lines = {}, path.read_text().splitlines()
    for k, line in enumerate(lines):
        if line == "ITEM: TIMESTEP":
            step = int(lines[k + 1])
        if line.startswith("ITEM: NUMBER OF ATOMS"):
            count = int(lines[k + 1])
        if line.startswith("ITEM: ATOMS"):
            column = line.split()[2:].index("c_cna")
            found[step] = np.array([int(row.split()[column]) for row in lines[k + 1:k + 1 + count]])
    return found


class Defects(running.Case):
    @classmethod
    def setUpClass(cls):
        folder = lammps.kept_runs(cls)
        cls.run_dir = folder / "defects_r10_v05"
        if not (cls.run_dir / "scene.toml").is_file():
            include = folder / "labels.lmp"
            include.write_text(LABELS)
            lammps.generate("adhesive", "--preset", "small", "--velocity", "0.5", "--dump-interval", "1", "--include",
                            include, "--ranks", lammps.ranks(), "-o", cls.run_dir, timeout=3600)
        cls.dump = cls.run_dir / "dump.lammpstrj.gz"
        done = running.run("defects", cls.dump, "--json", timeout=300)
        if done.returncode:
            raise AssertionError(done.stderr)
        cls.document = running.parse_json(done.stdout)
        cls.frames = cls.document["frames"]

    def test_labels_are_those_of_lammps_but_for_its_fixed_cutoff(self):
        """And but for what the repair finds: at least 98 % of the atoms of every frame (100 % of the first)."""
        theirs = labels(self.run_dir / "labels.dump")
        least = 1.0
        for frame in self.frames:
            wanted = theirs[frame["step"]]
            for name, label in (("fcc", 1), ("hcp", 2)):
                differ = abs(frame["counts"][name] - np.count_nonzero(wanted == label)) / len(wanted)
                least = min(least, 1 - differ)
                self.assertLess(differ, 0.02, f"{name} in step {frame['step']}")
        print(f"at least {least:.2%} of the counts agree")
        self.assertEqual(self.frames[0]["counts"]["fcc"], np.count_nonzero(theirs[0] == 1))

    def test_it_begins_at_the_contact(self):
        """None while the bodies are apart, fewer than the five that count as one before the first, which is within the
        bodies and nearer to the contact than half a radius."""
        first = self.document["first_defect"]
        self.assertGreater(first["delta"], 0)
        self.assertLess(np.linalg.norm(first["place"]), RADIUS / 2)
        for frame in self.frames:
            if frame["step"] < first["step"]:
                self.assertLess(frame["counts"]["hcp"] + frame["counts"]["bulk_defect"], 5)
            if frame["delta"] < -1:
                self.assertEqual(frame["counts"]["hcp"] + frame["counts"]["bulk_defect"], 0)

    def test_areas(self):
        """Faults are within what a plane through both bodies holds; at some time there are some."""
        areas = [frame["fault_area"]["value"] + frame["twin_area"]["value"] for frame in self.frames]
        self.assertEqual(areas[0], 0)
        self.assertGreater(max(areas), 50)
        for frame in self.frames:
            for plane in frame["planes"]:
                self.assertLess(plane["area"]["value"], np.pi * RADIUS**2)

    def test_surfaces_and_patch(self):
        """The radius by the mesh is that of the cut within its error and half a layer; the patch is nothing before touch and
        of the size of the contact radius by the area of atoms after it."""
        radius = self.frames[0]["surface"]["radius"]
        self.assertLess(abs(radius["value"] - RADIUS), 2 * radius["error"])
        self.assertEqual(self.frames[0]["patch_area"]["value"], 0)
        out = self.dir / "contact.csv"
        self.mdana("contact-radius", self.dump, "-o", out, timeout=300)
        table = running.read_csv(out)
        of_step = dict(zip(table["step"], table["contact_radius_alpha"]))
        last = self.frames[-1]
        by_patch = np.sqrt(last["patch_area"]["value"] / np.pi)
        print(f"contact radius {by_patch:.2f} by the patch, {of_step[last['step']]:.2f} by the area of atoms")
        self.assertLess(abs(by_patch / of_step[last["step"]] - 1), 0.5)

    def test_threads_change_no_bit(self):
        one, two = (running.run("defects", self.dump, "--frames", "::8", "--threads", n, "--json", timeout=300) for n in (1, 2))
        frames = [running.parse_json(done.stdout)["frames"] for done in (one, two)]
        self.assertEqual(*frames)


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
