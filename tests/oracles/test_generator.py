# SPDX-License-Identifier: GPL-3.0-or-later
"""sample-data/generate: the same command gives the same bytes, the scene file tells the truth about the dump, what
cannot be made is refused and leaves nothing."""

import gzip
import itertools
import math
import os
import shlex
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
import unittest
from pathlib import Path

import numpy as np

import lammps
import running
from lammps import GENERATE, generate

import dumps  # of tests/cli, where `lammps` has led to

RADIUS = 3.0  # smaller than any preset: 1 s a run
COLUMNS = "id type x y z vx vy vz c_pe"
RUN = ["hertz", "--radius", RADIUS, "--velocity", 0.3, "--duration", 6, "--seed", 7, "--columns", COLUMNS]
LATTICE = (4 / 1.08932)**(1 / 3)


class Scratch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        self.addCleanup(scratch.cleanup)
        self.dir = Path(scratch.name)


class Made(Scratch):
    """One run, looked at from all sides."""

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        cls.place = Path(scratch.name) / "run"
        cls.said = generate(*RUN, "-o", cls.place).stdout
        cls.dump = cls.place / "dump.lammpstrj.gz"
        cls.frames = dumps.read(cls.dump)
        cls.scene = tomllib.loads((cls.place / "scene.toml").read_text(encoding="utf-8"))

    def test_the_command_in_the_scene_makes_it_again(self):
        program, *arguments = shlex.split(self.scene["generator"]["command"])
        self.assertEqual(running.ROOT / program, GENERATE)
        again = self.dir / "run"
        generate(*arguments, "-o", again)
        for name in ("dump.lammpstrj.gz", "scene.toml"):
            self.assertEqual((again / name).read_bytes(), (self.place / name).read_bytes(), name)

    def test_plain_text_is_the_same_text(self):
        plain = self.dir / "run"
        generate(*RUN, "--no-gz", "-o", plain)
        self.assertEqual((plain / "dump.lammpstrj").read_bytes(), gzip.decompress(self.dump.read_bytes()))

    def test_another_seed_is_another_run(self):
        other = self.dir / "run"
        generate(*RUN, "--seed", 8, "-o", other)
        scene = tomllib.loads((other / "scene.toml").read_text(encoding="utf-8"))
        for mine, others in zip(self.scene["body"], scene["body"]):
            self.assertNotEqual(mine["orientation"], others["orientation"])
        first = dumps.read(other / "dump.lammpstrj.gz")[0]
        self.assertGreater(np.max(np.abs(first["x y z"] - self.frames[0]["x y z"])), 0.1)

    def test_unsorted_dump_holds_the_same_atoms(self):
        other = self.dir / "run"
        generate(*RUN, "--unsorted", "-o", other)
        for mine, others in zip(self.frames, dumps.read(other / "dump.lammpstrj.gz"), strict=True):
            order = np.argsort(others["id"][:, 0])
            np.testing.assert_array_equal(mine.atoms, others.atoms[order])

    def test_scene_agrees_with_the_dump(self):
        scene, first = self.scene, self.frames[0]
        self.assertEqual(scene["schema"], 1)
        self.assertEqual(scene["name"], self.place.name)
        self.assertTrue((self.place / scene["dump"]).is_file())
        self.assertEqual(scene["units"], first.units)
        self.assertEqual(scene["interaction"], "hertz")
        self.assertEqual(scene["masses"], {"1": 1.0, "2": 1.0})
        self.assertEqual(first.columns, COLUMNS.split())
        self.assertEqual(len(scene["body"]), 2)
        for body in scene["body"]:
            self.assertEqual(body["atoms"], len(first.body(body["type"]).atoms))
            self.assertEqual(body["radius"], RADIUS)
            self.assertAlmostEqual(np.linalg.norm(body["orientation"]), 1, delta=1e-14)
        made = scene["generator"]
        self.assertEqual((made["velocity"], made["seed"], made["columns"]), (0.3, 7, COLUMNS))
        self.assertEqual(self.frames[-1].step, made["steps"])
        self.assertEqual([f.step for f in self.frames], list(range(0, made["steps"] + 1, 32)))
        for frame in self.frames:  # times are printed with 6 digits or more
            self.assertAlmostEqual(frame.time, frame.step * scene["timestep"], delta=1e-5 * max(1, frame.time))
        self.assertEqual(made["lammps_version"] in self.lammps_help(), True)

    @staticmethod
    def lammps_help():
        return subprocess.run(["lmp", "-h"], capture_output=True, text=True, check=False).stdout

    def test_bodies_are_balls_of_a_crystal(self):
        """As many atoms as lattice points in a ball about one of them, counted one by one; the same in both bodies."""
        half, reach = LATTICE / 2, math.ceil(RADIUS / (LATTICE / 2))
        count = sum(1 for i, j, k in itertools.product(range(-reach, reach + 1), repeat=3)
                    if (i + j + k) % 2 == 0 and (i * i + j * j + k * k) * half**2 <= RADIUS**2)
        self.assertEqual([body["atoms"] for body in self.scene["body"]], [count] * 2)
        self.assertIn(f"2 x {count} atoms", self.said)

    def test_start(self):
        """Centres 2R + gap apart on the x axis, closing at the given speed along it. The first frame is written with
        10 digits, of numbers below 10: 1e-9 each; their mean is better."""
        first, made = self.frames[0], self.scene["generator"]
        left, right = dumps.centres(first)
        np.testing.assert_allclose(right - left, [2 * RADIUS + made["gap"], 0, 0], rtol=0, atol=1e-8)
        left, right = dumps.centres(first, "vx vy vz")
        np.testing.assert_allclose(right - left, [-0.3, 0, 0], rtol=0, atol=1e-9)

    def test_motion_keeps_energy_and_momentum(self):
        """NVE: velocity Verlet with a step h = 2^-7 keeps the energy to about (w h)^2/8 of what goes to and fro, which is
        1e-5 for a contact of w = 1/tau, and 1e-4 with bonds that vibrate in part; momentum to the digits printed."""
        kinetic = np.array([np.sum(frame["vx vy vz"]**2) / 2 for frame in self.frames])
        total = kinetic + np.array([np.sum(frame["c_pe"]) for frame in self.frames])
        self.assertLess(np.ptp(total), 1e-4 * kinetic[0])
        for frame in self.frames:
            np.testing.assert_allclose(np.mean(frame["vx vy vz"], axis=0), 0, atol=1e-9)

    def test_mdana_takes_it(self):
        done = running.run("info", self.dump, "--json")
        document = running.parse_json(done.stdout)
        self.assertEqual(document["scene"], str(self.place / "scene.toml"))
        self.assertEqual(document["interaction"], "hertz")
        self.assertEqual(document["frames"], len(self.frames))
        self.assertEqual(document["warnings"], [])


class Options(Scratch):
    def test_aligned_adhesive(self):
        """Aligned bodies are not turned; adhesive scenes begin beyond the cutoff and know their surface energy only at
        full attraction."""
        for attraction, known in ((1, True), (0.4, False)):
            run = self.dir / f"run-{attraction}"
            generate("adhesive", "--attraction", attraction, "--radius", 2, "--duration", 1, "--aligned",
                     "--temperature", 0, "-o", run)
            scene = tomllib.loads((run / "scene.toml").read_text(encoding="utf-8"))
            self.assertEqual([body["orientation"] for body in scene["body"]], [[1, 0, 0, 0]] * 2)
            self.assertEqual("gamma" in scene["material"], known)
            self.assertGreater(scene["generator"]["gap"], scene["cutoff"])
            left, right = dumps.centres(dumps.read(run / "dump.lammpstrj.gz")[0])
            np.testing.assert_allclose(right - left, [4 + scene["generator"]["gap"], 0, 0], rtol=0, atol=1e-8)

    def test_dump_from(self):
        run = self.dir / "run"
        generate("hertz", "--radius", 2, "--duration", 2, "--dump-from", 1, "--dump-interval", 0.5, "-o", run)
        self.assertEqual([frame.step for frame in dumps.read(run / "dump.lammpstrj.gz")], [128, 192, 256])

    def test_force_replaces(self):
        run = self.dir / "run"
        quick = ["hertz", "--radius", 2, "--duration", 1, "--temperature", 0]
        generate(*quick, "-o", run)
        before = (run / "dump.lammpstrj.gz").read_bytes()
        (run / "notes").touch()
        self.assertIn("exists", generate(*quick, "--velocity", 0.2, "-o", run, code=1).stderr)
        self.assertEqual((run / "dump.lammpstrj.gz").read_bytes(), before)
        generate(*quick, "--velocity", 0.2, "--force", "-o", run)
        self.assertNotEqual((run / "dump.lammpstrj.gz").read_bytes(), before)
        self.assertEqual(os.listdir(self.dir), ["run"])


class Refusals(Scratch):
    QUICK = ["hertz", "--radius", 2, "--duration", 1, "--temperature", 0]

    def refused(self, *arguments, code=1, says=(), **settings):
        done = generate(*arguments, code=code, **settings)
        for text in says:
            self.assertIn(text, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done

    def test_what_cannot_be_run(self):
        (self.dir / "work").mkdir()
        for arguments, says in [
            (["hertz", "--attraction", "1.5"], "--attraction"),
            (["hertz", "--attraction", "-0.1"], "--attraction"),
            (["hertz", "--gap", "1"], "--gap"),
            (["adhesive", "--gap", "4"], "cutoff"),
            (["hertz", "--cutoff", "1"], "--cutoff"),
            (["hertz", "--ranks", "0"], "--ranks"),
            (["hertz", "--include", "missing.lmp"], "missing.lmp"),
            (["adhesive", "--preset", "paper"], "--long"),
            (["hertz", "--dump-interval", "0.013"], "--dump-interval"),
            (["hertz", "--dump-interval", "0.001"], "--dump-interval"),
            ([*self.QUICK, "--dump-from", "3"], "--dump-from"),
        ]:
            with self.subTest(arguments):
                self.refused(*arguments, "-o", "run", says=[says], cwd=self.dir / "work")
                self.assertEqual(os.listdir(self.dir / "work"), [])

    def test_usage(self):
        for arguments in ([], ["dust"], ["hertz", "--preset", "huge"], ["hertz", "--velocity", "fast"],
                          ["hertz", "--velocity", "-1"], ["hertz", "--velocity", "nan"], ["hertz", "--radius", "inf"],
                          ["hertz", "--no-such-option"], ["hertz", "--seed", "1.5"]):
            with self.subTest(arguments):
                self.refused(*arguments, code=2, says=["usage: "], cwd=self.dir)
                self.assertEqual(os.listdir(self.dir), [])

    def test_a_directory_that_is_no_run_is_kept(self):
        mine = self.dir / "mine"
        mine.mkdir()
        (mine / "thesis.tex").touch()
        self.refused(*self.QUICK, "--force", "-o", mine, says=["scene.toml"])
        self.assertEqual(os.listdir(mine), ["thesis.tex"])

    def test_no_lammps(self):
        self.refused(*self.QUICK, "-o", self.dir / "run", says=["lmp", "apt install lammps"],
                     env=os.environ | {"PATH": str(self.dir)})
        self.assertEqual(os.listdir(self.dir), [])

    def test_error_in_lammps(self):
        with tempfile.TemporaryDirectory(prefix="mdana-test-") as other:
            fragment = Path(other) / "wrong.lmp"
            fragment.write_text("fix wrong all no/such/fix\n", encoding="utf-8")
            self.refused(*self.QUICK, "--include", fragment, "-o", self.dir / "run", says=["LAMMPS", "no/such/fix"])
        self.assertEqual(os.listdir(self.dir), [])

    def test_stopped(self):
        """By SIGTERM or SIGINT in the middle of the run: LAMMPS is ended, nothing stays."""
        for number in (signal.SIGTERM, signal.SIGINT):
            with self.subTest(number.name), subprocess.Popen(
                [sys.executable, GENERATE, "hertz", "--radius", "5", "-o", self.dir / "run"], text=True,
                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            ) as process:
                try:
                    for line in process.stdout:
                        if "relaxing" in line:
                            break
                    time.sleep(0.3)
                    process.send_signal(number)
                    _, error = process.communicate(timeout=30)
                finally:
                    process.kill()
                self.assertEqual(process.returncode, 130, error)
                self.assertIn("nothing was written", error)
                self.assertEqual(os.listdir(self.dir), [])


class Help(unittest.TestCase):
    def test_help(self):
        self.assertIn("examples:", generate("--help").stdout)
        for scene in ("hertz", "adhesive"):
            text = generate(scene, "--help").stdout
            for option in ("-o", "--preset", "--radius", "--attraction", "--seed", "--aligned", "--temperature",
                           "--velocity", "--gap", "--cutoff", "--duration", "--dump-interval", "--columns", "--ranks",
                           "--gz"):
                self.assertIn(option, text)


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
