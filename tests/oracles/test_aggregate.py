# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene `aggregate` of sample-data/generate and `mdana network` against LAMMPS: what a contact of pair granular
does, that the aggregates are what they are said to be, and that contacts and forces are those of LAMMPS."""

import gzip
import subprocess
import tempfile
import tomllib
import unittest
from pathlib import Path

import numpy as np

import lammps
import running
from lammps import generate

import dumps  # of tests/cli, where `lammps` has led to
import grains

FEW = ["aggregate", "--radius", 5, "--seed", 3]
COLUMNS = "id type x y z fx fy fz radius mass c_touch"


def run_input(directory, **variables):
    """Runs the directory's aggregate.lmp with other settings."""
    command = ["lmp", "-in", "aggregate.lmp"]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    done = subprocess.run(command, cwd=directory, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(done.stdout[-2000:])


def read_local(path):
    """Rows of the entries of each frame of a local dump: step -> array."""
    data = path.read_bytes()
    text = (gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data).decode()
    found = {}
    for part in text.split("ITEM: TIMESTEP\n")[1:]:
        step = int(part.split("\n", 1)[0])
        head, _, rows = part.partition("ITEM: ENTRIES")[2].partition("\n")
        rows = rows.split("ITEM:")[0]
        found[step] = np.array(rows.split(), dtype=float).reshape(-1, len(head.split()))
    return found


class OneContact(unittest.TestCase):
    """Two grains drawn apart by the input of the generator, slowly against nothing: they are moved, not integrated."""

    STEP = 1e-3  # of the overlap, in delta0

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        cls.place = Path(scratch.name) / "run"
        generate(*FEW, "--duration", 0.1, "-o", cls.place)
        cls.scene = tomllib.loads((cls.place / "scene.toml").read_text(encoding="utf-8"))
        cls.jkr = grains.Jkr.of_scene(cls.scene)

    def pull(self, first=2.0, last=-1.2, approach=False, extra=""):
        """Overlap / delta0 and force / F_c on grain 1, repulsive positive, at each step; and LAMMPS' local dump."""
        steps = round((first - last) / self.STEP)
        radius, apart = self.scene["grains"]["radius"], 2 * self.scene["grains"]["radius"]
        begin = apart - (last if approach else first) * self.jkr.delta0
        speed = self.STEP * self.jkr.delta0 / 0.01 / 2 * (-1 if approach else 1)
        (self.place / "grains.data").write_text(
            "two grains, and two that hold the box open\n\n4 atoms\n2 atom types\n\n"
            "-900 900 xlo xhi\n-900 900 ylo yhi\n-900 900 zlo zhi\n\nAtoms # sphere\n\n"
            f"1 1 {2 * radius} 0.001 {-begin / 2!r} 0 0\n2 2 {2 * radius} 0.001 {begin / 2!r} 0 0\n"
            f"3 1 {2 * radius} 0.001 -800 -800 -800\n4 2 {2 * radius} 0.001 800 800 800\n", encoding="utf-8")
        (self.place / "include.lmp").write_text(
            "unfix move\nvelocity all set 0 0 0\ngroup one id 1\ngroup two id 2\n"
            f"fix a one move linear {-speed!r} 0 0\nfix b two move linear {speed!r} 0 0\n{extra}\n"
            "dump grains all custom 1 pull.dump id type x y z fx fy fz\n"
            "dump pairs all local 1 pull.local c_ids[1] c_ids[2] c_pair[1] c_pair[2]\n"
            "dump_modify grains sort id format float %.17g\ndump_modify pairs format float %.17g\n"
            f"run {steps}\nquit\n", encoding="utf-8")
        run_input(self.place, reach=self.jkr.delta0, slide=0.36, roll=3770, roll_max=0.032, twist=1e7, twist_max=1,
                  extra="include include.lmp")
        frames = dumps.read(self.place / "pull.dump")
        self.assertEqual(len(frames), steps + 1)
        overlap = np.array([apart - (f["x"][1, 0] - f["x"][0, 0]) for f in frames]) / self.jkr.delta0
        force = np.array([-f["fx"][0, 0] for f in frames]) / self.jkr.pull
        return overlap, force, read_local(self.place / "pull.local")

    def assert_jkr(self, overlap, force, where):
        """x is exact to 1e-16 of 100, 1e-14 of delta0; LAMMPS' own closed form of a cancels some digits: 1e-9 F_c."""
        exact = self.jkr.forces(overlap[where] * self.jkr.delta0) / self.jkr.pull
        np.testing.assert_allclose(force[where], exact, rtol=0, atol=1e-9)

    def test_force_is_jkr_and_ends_at_its_minimum(self):
        overlap, force, _ = self.pull()
        held = force != 0
        self.assert_jkr(overlap, force, held)
        least = overlap[held].min()
        self.assertAlmostEqual(least, -4**(-2 / 3), delta=1.5 * self.STEP)  # not -(3/4)^(2/3) = -0.825
        self.assertAlmostEqual(force[held].min(), -1, delta=1e-5)
        np.testing.assert_array_equal(held, overlap >= least)

    def test_contact_begins_at_touch(self):
        overlap, force, _ = self.pull(approach=True)
        held = force != 0
        self.assert_jkr(overlap, force, held)
        self.assertAlmostEqual(overlap[held].min(), 0, delta=1.5 * self.STEP)

    def test_new_neighbour_lists_do_not_end_it(self):
        overlap, force, _ = self.pull()
        _, again, _ = self.pull(extra="neigh_modify every 10 check no")
        np.testing.assert_allclose(again, force, rtol=0, atol=1e-12)
        self.assertLess(overlap[again != 0].min(), -0.39)

    def test_local_dump_lacks_forces_near_touch(self):
        """What LAMMPS writes of pairs: the same force, but 0 below +0.397 delta0."""
        overlap, force, local = self.pull(last=-0.9)
        written = np.array([local[step][0][3] for step in range(len(overlap))]) / self.jkr.pull
        there = written != 0
        self.assertAlmostEqual(overlap[there].min(), 4**(-2 / 3), delta=1.5 * self.STEP)
        np.testing.assert_allclose(written[there], force[there], rtol=0, atol=1e-12)
        self.assertEqual(list(local[0][0][:2]), [1, 2])


class Made(unittest.TestCase):
    """A collision of small aggregates with forces, and with what LAMMPS counts of contacts."""

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        cls.place = Path(scratch.name) / "run"
        count = Path(scratch.name) / "count.lmp"
        count.write_text("compute touch all contact/atom\n", encoding="utf-8")
        cls.said = generate(*FEW, "--filling-factor", 0.5, "--duration", 14, "--dump-interval", 1, "--include", count,
                            "--columns", COLUMNS, "--format", "%.15g", "-o", cls.place).stdout
        cls.scene = tomllib.loads((cls.place / "scene.toml").read_text(encoding="utf-8"))
        cls.jkr = grains.Jkr.of_scene(cls.scene)
        run_input(cls.place, slide=0, roll=3770, roll_max=0, twist=1e7, twist_max=0, reach=cls.jkr.delta0,
                  duration=1400, dump_every=100, contact_every=100, format="%.15g", columns=COLUMNS,
                  extra="include include.lmp")  # once more without friction
        cls.dump = cls.place / "dump.lammpstrj.gz"
        cls.frames = dumps.read(cls.dump)
        cls.local = read_local(cls.place / "contacts.dump.gz")
        table = cls.place / "network.csv"
        done = running.run("network", cls.dump, "-o", table)
        assert done.returncode == 0, done.stderr
        cls.table = running.read_csv(table)

    def test_aggregates_are_what_they_are_said_to_be(self):
        first, radius = self.frames[0], self.scene["grains"]["radius"]
        apart = self.scene["body"][0]["radius"] + self.scene["generator"]["gap"] * radius / 2
        for body, side in ((1, -1), (2, 1)):
            x = first.body(body)["x y z"] - [side * apart, 0, 0]
            self.assertEqual(len(x), round(0.5 * 5**3))
            self.assertEqual(len(x), self.scene["body"][body - 1]["atoms"])
            self.assertLessEqual(np.linalg.norm(x, axis=1).max(), 5 * radius)
        _, _, overlaps, _ = grains.pairs(first, least=-0.5 * radius)
        np.testing.assert_allclose(overlaps, self.jkr.delta0, rtol=0, atol=1e-11)  # digits of 1000 nm
        self.assertEqual(self.scene["interaction"], "aggregate")
        self.assertEqual(self.scene["aggregate"]["filling_factor"], 0.5)
        self.assertIn("not the return phase", self.said)

    def test_contacts_are_those_that_lammps_counts(self):
        for k, frame in enumerate(self.frames):
            touching = frame["c_touch"][:, 0]
            self.assertEqual(self.table["contacts"][k], touching.sum() / 2, frame.step)
            self.assertAlmostEqual(self.table["coordination"][k], touching.mean(), delta=1e-12)
        self.assertGreater(self.table["contacts12"][-1], 0)

    def test_forces_are_those_of_lammps(self):
        """Pairs of the local dump, as far as LAMMPS tells their force: overlaps are exact to 2e-12 nm."""
        compared = 0
        for frame in self.frames:
            place = {int(i): k for k, i in enumerate(frame["id"][:, 0])}
            rows = self.local[frame.step]
            rows = rows[rows[:, 3] != 0]
            x = frame["x y z"]
            distance = np.array([np.linalg.norm(x[place[int(a)]] - x[place[int(b)]]) for a, b in rows[:, :2]])
            np.testing.assert_allclose(distance, rows[:, 2], rtol=0, atol=1e-11)
            exact = self.jkr.forces(2 * self.scene["grains"]["radius"] - rows[:, 2])
            np.testing.assert_allclose(rows[:, 3], exact, rtol=0, atol=1e-8 * self.jkr.pull)
            compared += len(rows)
        self.assertGreater(compared, 1000)

    def test_table_of_forces(self):
        """Its columns by numpy, from the dump alone."""
        for k, frame in enumerate(self.frames):
            _, _, overlaps, normals = grains.pairs(frame)
            force = self.jkr.forces(overlaps)
            for name, value in (("force_mean", force.mean()), ("force_rms", np.sqrt(np.mean(force**2))),
                                ("force_min", force.min()), ("force_max", force.max()),
                                ("force_q25", np.quantile(force, 0.25)), ("force_median", np.median(force)),
                                ("force_q95", np.quantile(force, 0.95))):
                self.assertAlmostEqual(self.table[name][k], value, delta=1e-8 * self.jkr.pull, msg=name)
            fabric = np.einsum("ki,kj->ij", normals, normals) / len(normals)
            self.assertAlmostEqual(self.table["fabric_xy"][k], fabric[0, 1], delta=1e-13)
            self.assertAlmostEqual(self.table["fabric_zz"][k], fabric[2, 2], delta=1e-13)

    def test_force_across_is_that_on_the_bodies(self):
        """Without friction, in frames where no pair across is apart but may hold. Forces on grains have 15 digits."""
        compared = 0
        for k, frame in enumerate(self.frames):
            kind = frame["type"][:, 0]
            first, second, overlaps, _ = grains.pairs(frame, least=-0.9 * self.jkr.delta0)
            across = kind[first] != kind[second]
            if not across.any() or (overlaps[across] < 0).any():
                continue
            left, right = dumps.centres(frame)
            axis = (right - left) / np.linalg.norm(right - left)
            on_body2 = frame.body(2)["fx fy fz"].sum(axis=0)
            np.testing.assert_allclose(frame.body(1)["fx fy fz"].sum(axis=0), -on_body2, rtol=0,
                                       atol=1e-9 * self.jkr.pull)
            self.assertAlmostEqual(self.table["force12"][k], on_body2 @ axis, delta=1e-8 * self.jkr.pull)
            compared += 1
        self.assertGreater(compared, 0)


class Generator(unittest.TestCase):
    def test_the_same_command_gives_the_same_bytes(self):
        with tempfile.TemporaryDirectory(prefix="mdana-test-") as scratch:
            runs = [Path(scratch) / name for name in "ab"]
            for run in runs:
                generate(*FEW, "--duration", 1, "-o", run)
            for name in ("dump.lammpstrj.gz", "contacts.dump.gz", "grains.data"):
                self.assertEqual((runs[0] / name).read_bytes(), (runs[1] / name).read_bytes(), name)
            generate(*FEW, "--seed", 4, "--duration", 1, "--force", "-o", runs[1])
            self.assertNotEqual((runs[0] / "grains.data").read_bytes(), (runs[1] / "grains.data").read_bytes())

    def test_refusals(self):
        with tempfile.TemporaryDirectory(prefix="mdana-test-") as scratch:
            for arguments, says in [(["--filling-factor", 0.75], "--filling-factor"), (["--gap", 2], "--gap"),
                                    (["--poisson", 0.6], "--poisson"), (["--radius", 1], "--radius"),
                                    (["--contacts-every", -1], "--contacts-every"),
                                    (["--filling-factor", 0.74, "--radius", 3, "--seed", 2], "close packing")]:
                done = generate("aggregate", *arguments, "-o", "run", code=1, cwd=scratch)
                self.assertIn(says, done.stderr)
                self.assertNotIn("Traceback", done.stderr)
                self.assertFalse((Path(scratch) / "run").exists())

    def test_help(self):
        text = generate("aggregate", "--help").stdout
        for option in ("--filling-factor", "--radius", "--velocity", "--gamma", "--modulus", "--rolling", "--seed",
                       "return phase"):
            self.assertIn(option, text)


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
