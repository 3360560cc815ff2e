#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Defects of real collisions followed in time: spheres of radius 10 and 29 that stick at v = 0.5, made by LAMMPS, which
labels the atoms of the same frames, too. The larger ones (222474 atoms, 20 minutes on two processors) are followed beyond
the greatest compression.

With MDANA_LONG_RUNS=DIR the runs are kept in DIR, and taken from there if they are there."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "oracles"))

import numpy as np

import lammps
import running

RADIUS, LARGE = 10, 29
LABELS = """compute cna all cna/atom 1.317
dump labels all custom {every} labels.dump id c_cna
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


def collision(case, name, every, *arguments):
    """The folder of a run of LAMMPS with its own labels, a frame and labels every so many steps of 2^-7."""
    folder = lammps.kept_runs(case)
    if not (folder / name / "scene.toml").is_file():
        include = folder / f"{name}.lmp"
        include.write_text(LABELS.format(every=every))
        lammps.generate("adhesive", *arguments, "--velocity", "0.5", "--dump-interval", every / 128, "--include", include,
                        "--ranks", lammps.ranks(), "-o", folder / name, timeout=7000)
    return folder / name


class Collision(running.Case):
    """What holds for both."""

    @classmethod
    def follow(cls, run_dir):
        cls.run_dir, cls.dump = run_dir, run_dir / "dump.lammpstrj.gz"
        done = running.run("defects", cls.dump, "--json", timeout=600)
        if done.returncode:
            raise AssertionError(done.stderr)
        cls.document = running.parse_json(done.stdout)
        cls.frames = cls.document["frames"]

    def assert_labels_of_lammps(self):
        """But for its fixed cutoff, and for what the repair finds: at least 98 % of the atoms of every frame (100 % of
        the first)."""
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

    def assert_begins_at_the_contact(self, radius, after):
        """No defects while the bodies are apart, fewer than the five that count as one before the first, which is within the
        bodies, after some delta, and nearer to the contact than half a radius."""
        first = self.document["first_defect"]
        self.assertGreater(first["delta"], after)
        self.assertLess(np.linalg.norm(first["place"]), radius / 2)
        for frame in self.frames:
            if frame["step"] < first["step"]:
                self.assertLess(frame["counts"]["hcp"] + frame["counts"]["bulk_defect"], 5)
            if frame["delta"] < -1:
                self.assertEqual(frame["counts"]["hcp"] + frame["counts"]["bulk_defect"], 0)

    def assert_areas(self, radius):
        """Faults are within what a plane through both bodies holds; at some time there are some."""
        areas = [frame["fault_area"]["value"] + frame["twin_area"]["value"] for frame in self.frames]
        self.assertEqual(areas[0], 0)
        self.assertGreater(max(areas), radius**2 / 2)
        for frame in self.frames:
            for plane in frame["planes"]:
                self.assertLess(plane["area"]["value"], np.pi * radius**2)

    def assert_surface(self, radius):
        """The radius by the mesh is that of the cut within its error and half a layer."""
        mesh = self.frames[0]["surface"]["radius"]
        self.assertLess(abs(mesh["value"] - radius), 2 * mesh["error"])


class Large(Collision):
    @classmethod
    def setUpClass(cls):
        cls.follow(collision(cls, "defects_r29_v05", 256, "--radius", LARGE, "--duration", "36"))

    def test_followed_beyond_the_greatest_compression(self):
        delta = [frame["delta"] for frame in self.frames]
        self.assertGreater(max(delta), 0)
        self.assertLess(delta.index(max(delta)), len(delta) - 1)
        self.assert_labels_of_lammps()
        self.assert_begins_at_the_contact(LARGE, -1)  # they are pulled together
        self.assert_areas(LARGE)
        self.assert_surface(LARGE)

    def test_lines(self):
        """A line ends inside a crystal in one frame at most, and where they are longest few are of no family."""
        self.assertLessEqual(sum(frame["burgers_residual"] > 0 for frame in self.frames), 1)
        most = max(self.frames, key=lambda frame: frame["total_length"]["value"])
        other = most["lines"]["other"]["length"]["value"] / most["total_length"]["value"]
        print(f"most lines {most['total_length']['value']:.0f}, {other:.1%} of them of no family")
        self.assertGreater(most["total_length"]["value"], 10 * LARGE)
        self.assertLess(other, 0.13)

    def test_slabs_change_no_bit(self):
        done = running.run("defects", self.dump, "--frames", "last", "--memory", "8M", "--threads", "1", "--json", timeout=600)
        self.assertEqual(running.parse_json(done.stdout)["frames"], self.last_frame())

    def last_frame(self):
        """Alone, as lattices are told against the first frame that is looked at."""
        done = running.run("defects", self.dump, "--frames", "last", "--json", timeout=600)
        return running.parse_json(done.stdout)["frames"]


class Small(Collision):
    @classmethod
    def setUpClass(cls):
        cls.follow(collision(cls, "defects_r10_v05", 128, "--preset", "small"))

    def test_labels_are_those_of_lammps(self):
        self.assert_labels_of_lammps()

    def test_it_begins_at_the_contact(self):
        self.assert_begins_at_the_contact(RADIUS, 0)

    def test_areas(self):
        self.assert_areas(RADIUS)

    def test_surfaces_and_patch(self):
        """The patch is nothing before touch and of the size of the contact radius by the area of atoms after it."""
        self.assert_surface(RADIUS)
        self.assertEqual(self.frames[0]["patch_area"]["value"], 0)
        out = self.dir / "contact.csv"
        self.mdana("contact-radius", self.dump, "-o", out, timeout=300)
        table = running.read_csv(out)
        of_step = dict(zip(table["step"], table["contact_radius_alpha"]))
        last = self.frames[-1]
        by_patch = np.sqrt(last["patch_area"]["value"] / np.pi)
        print(f"contact radius {by_patch:.2f} by the patch, {of_step[last['step']]:.2f} by the area of atoms")
        self.assertLess(abs(by_patch / of_step[last["step"]] - 1), 0.5)

    def test_lines(self):
        """Nothing ends inside a crystal, and the zone gives the lines of all atoms, but for some at the surface."""
        done = running.run("defects", self.dump, "--no-surface", "--lines-everywhere", "--json", timeout=600)
        everywhere = [f["total_length"]["value"] for f in running.parse_json(done.stdout)["frames"]]
        zone = [f["total_length"]["value"] for f in self.frames]
        self.assertEqual([f["burgers_residual"] for f in self.frames], [0] * len(zone))
        same = sum(abs(a - b) < 0.3 for a, b in zip(zone, everywhere))
        print(f"lines of {same} of {len(zone)} frames are the same, together {sum(zone):.0f} and {sum(everywhere):.0f}")
        self.assertGreaterEqual(same, 0.95 * len(zone))
        self.assertLess(abs(sum(zone) / sum(everywhere) - 1), 0.01)

    def test_threads_change_no_bit(self):
        one, two = (running.run("defects", self.dump, "--frames", "::8", "--threads", n, "--json", timeout=300) for n in (1, 2))
        frames = [running.parse_json(done.stdout)["frames"] for done in (one, two)]
        self.assertEqual(*frames)


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
