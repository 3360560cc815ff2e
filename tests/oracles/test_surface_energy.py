# SPDX-License-Identifier: GPL-3.0-or-later
"""Bulk energy and surface energy against LAMMPS: a periodic crystal and a ball, both relaxed."""

import itertools
import math
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import lammps
import running

import dumps  # of tests/cli, where `lammps` has led to

POTENTIAL = """
mass          * 1.0
pair_style    lj/cut {cutoff}
pair_coeff    * * 1.0 1.0
pair_modify   shift {shift}
neighbor      0.3 bin
"""
BULK = """
units         lj
boundary      p p p
lattice       fcc 1.08932
region        box block 0 4 0 4 0 4
create_box    1 box
create_atoms  1 region box
""" + POTENTIAL + """
variable      each equal pe/atoms
thermo_style  custom step atoms pe lx press v_each
thermo_modify norm no format float %.15g
fix           free all box/relax iso 0.0 vmax 0.001
minimize      0.0 1.0e-12 2000 20000
print         "bulk $(lx:%.15g) $(v_each:%.15g)"
"""
BALL = """
units         lj
boundary      f f f
lattice       fcc 1.08932
region        box block -12 12 -12 12 -12 12 units box
region        ball sphere 0 0 0 {radius} units box
create_box    1 box
create_atoms  1 region ball
""" + POTENTIAL + """
compute       pe all pe/atom
compute       sum all reduce sum c_pe
thermo_style  custom step atoms pe c_sum
thermo_modify norm no format float %.15g
min_style     cg
minimize      0.0 1.0e-10 2000 20000
print         "ball $(atoms) $(pe:%.15g)"
write_dump    all custom cold.dump id type x y z vx vy vz c_pe modify units yes format float %.{digits}g
"""
HEAT = """
velocity      all create {temperature} 7 mom yes rot yes dist gaussian
timestep      0.005
fix           heat all langevin {half} {half} 0.5 11
fix           nve all nve
run           2000
velocity      all zero linear
velocity      all zero angular
write_dump    all custom warm.dump id type x y z vx vy vz c_pe modify units yes format float %.12g
"""
RADIUS = 7


def lmp(place, text):
    """Runs LAMMPS in the directory; the words behind each `bulk` or `ball` that it prints."""
    (place / "in.lmp").write_text(text)
    done = subprocess.run(["lmp", "-in", "in.lmp", "-log", "none"], cwd=place, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=300, check=False)
    if done.returncode:
        raise AssertionError(done.stdout[-2000:] + done.stderr)
    lines = [line.split() for line in done.stdout.splitlines()]
    return next(([float(w) for w in words[1:]] for words in lines if words[:1] in (["bulk"], ["ball"])), None)


def brute_force(cutoff, shift, distance):
    """e_1 of the crystal, pair by pair."""
    def pair(square):
        return 4 * (square**-6 - square**-3)

    n = int(cutoff / distance * math.sqrt(2)) + 1
    squares = [(i * i + j * j + k * k) / 2 * distance**2
               for i, j, k in itertools.product(range(-n, n + 1), repeat=3) if (i + j + k) % 2 == 0]
    offset = pair(cutoff**2) if shift == "yes" else 0
    return math.fsum(0.5 * (pair(s) - offset) for s in squares if 0 < s < cutoff**2)


class SurfaceEnergy(running.Case):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        cls.place = Path(scratch.name)
        cls.ball = lmp(cls.place, BALL.format(cutoff=5, shift="yes", radius=RADIUS, digits=12)
                       + HEAT.format(temperature=2e-3, half=1e-3))
        cls.cold, cls.warm = cls.place / "cold.dump", cls.place / "warm.dump"

    def measure(self, dump, *options):
        return self.document("surface-energy", dump, "--bodies", "type", *options)

    def test_bulk(self):
        """LAMMPS adds 256 atoms' pairs one by one: 6e4 additions to a sum of 2000, the same few terms again and again,
        are rounded by up to 1e-16 of it each, 5e-12 an atom at worst times the bias. e_1 to 2e-11; D from a pressure
        below 1e-5: 1e-7."""
        for cutoff, shift in ((2.5, "no"), (2.5, "yes"), (3, "yes"), (5, "yes")):
            with self.subTest(f"{cutoff} {shift}"):
                edge, energy = lmp(self.dir, BULK.format(cutoff=cutoff, shift=shift))
                document = self.measure(self.cold, "--cutoff", cutoff, "--shift", shift, "--energy", -1e4)
                found, distance = document["e_1"]["value"], document["D"]["value"]
                print(f"cutoff {cutoff}, shift {shift}: e_1 {found!r}, of LAMMPS {energy!r}; D {distance!r}, "
                      f"of LAMMPS {edge / 4 / math.sqrt(2)!r}")
                self.assertAlmostEqual(found, energy, delta=2e-11 * abs(energy))
                self.assertAlmostEqual(distance, edge / 4 / math.sqrt(2), delta=1e-6)
                self.assertAlmostEqual(found, brute_force(cutoff, shift, distance), delta=1e-13 * abs(energy))
                self.assertAlmostEqual(document["lattice_constant"]["value"], distance * math.sqrt(2), delta=1e-15)

    def test_ball(self):
        """N and U are LAMMPS' own; gamma follows from them by P1 C1 with each of the radii."""
        atoms, energy = self.ball
        document = self.measure(self.cold, "--cutoff", 5, "--shift", "yes", "--radius", RADIUS)
        self.assertEqual(document["N"], atoms)
        self.assertEqual(document["energy_source"], "sum of c_pe")
        error = document["U"]["error"]
        self.assertLess(abs(document["U"]["value"] - energy), 8 * error + 1e-13 * abs(energy))
        self.assertLess(error, 1e-8)
        x = dumps.read(self.cold)[0]["x y z"]
        gyration = math.sqrt(5 / 3 * np.mean(np.sum((x - np.mean(x, axis=0))**2, axis=1)))
        distance = document["D"]["value"]
        volume = (3 / (4 * math.pi) * atoms * distance**3 / math.sqrt(2))**(1 / 3)
        excess = energy - atoms * brute_force(5, "yes", distance)
        for how, radius in (("cut", RADIUS), ("volume", volume), ("gyration", gyration)):
            wanted = excess / (4 * math.pi * radius**2)
            gamma = document["gamma"][how]
            print(f"{how}: R {radius:.5f}, gamma {gamma['value']:.6f} +- {gamma['error']:.1g}")
            self.assertAlmostEqual(document["radius"][how]["value"], radius, delta=1e-9 * radius)
            self.assertAlmostEqual(gamma["value"], wanted, delta=1e-9)
            self.assertGreater(gamma["value"], 2.8)  # P1: 3.17 for R above 29
            self.assertLess(gamma["value"], 3.5)
            self.assertLess(gamma["error"], 1e-9)

    def test_given_energy(self):
        """--energy in place of the column; its error is that of the digits."""
        options = ("--cutoff", 5, "--shift", "yes", "--radius", RADIUS)
        summed = self.measure(self.cold, *options)
        given = self.measure(self.cold, *options, "--energy", "-1.1211e4")
        self.assertEqual(given["U"]["value"], -11211)
        self.assertAlmostEqual(given["U"]["error"], 1 / math.sqrt(12), delta=1e-12)
        self.assertLess(abs(given["gamma"]["cut"]["value"] - summed["gamma"]["cut"]["value"]),
                        2 * given["gamma"]["cut"]["error"])

    def test_printed_digits_give_the_error(self):
        """The same ball printed with four digits: energies of 8 are off by 3e-4 each, in a crystal all of them alike."""
        lmp(self.dir, BALL.format(cutoff=5, shift="yes", radius=RADIUS, digits=4))
        document = self.measure(self.dir / "cold.dump", "--cutoff", 5, "--shift", "yes")
        expected = 1e-3 / math.sqrt(12) * self.ball[0]
        self.assertGreater(document["U"]["error"], expected / 3)
        self.assertLess(document["U"]["error"], expected * 3)
        off = abs(document["U"]["value"] - self.ball[1])
        print(f"four digits: U off by {off:.3f}, stated {document['U']['error']:.3f}")
        self.assertLess(off, 2 * document["U"]["error"])

    def test_heat_is_taken_out(self):
        """At kT = 1e-3 the heat is 1.5e-3 N = 2.3, and as much of it is potential energy: without it gamma is that of
        the cold ball within the stated error."""
        options = ("--cutoff", 5, "--shift", "yes", "--radius", RADIUS)
        cold, warm = self.measure(self.cold, *options), self.measure(self.warm, *options)
        v = dumps.read(self.warm)[0]["vx vy vz"]
        heat = 0.5 * np.sum((v - np.mean(v, axis=0))**2)
        self.assertAlmostEqual(warm["thermal_energy"]["value"], heat, delta=1e-9 * heat)
        self.assertAlmostEqual(warm["kT"]["value"], 2 * heat / (3 * self.ball[0]), delta=1e-12)
        self.assertEqual(cold["kT"]["value"], 0)
        raised = warm["U"]["value"] + heat - cold["U"]["value"]
        print(f"kT {warm['kT']['value']:.4g}: U is raised by {raised:.4f}, heat {heat:.4f}, "
              f"error {warm['U']['error']:.4f}")
        self.assertGreater(raised, 5 * warm["U"]["error"])  # or the test says nothing
        self.assertLess(abs(raised - heat), 3 * warm["U"]["error"])

    def test_refusals(self):
        for options, says in (
                ((), "--cutoff"),
                (("--cutoff", 5), "--shift"),
                (("--cutoff", 1, "--shift", "no"), "free of pressure"),
                (("--cutoff", 5, "--shift", "no", "--energy-column", "c_x"), "c_x"),
                (("--cutoff", 5, "--shift", "no", "--energy-column", "id"), "no energies"),
                (("--cutoff", 5, "--shift", "no", "--body", 2), "body 2")):
            with self.subTest(says):
                self.refused("surface-energy", self.cold, "--bodies", "type", *options, says=[says])
        for options in (("--cutoff", "far"), ("--cutoff", -1), ("--shift", "maybe"), ("--body", 3),
                        ("--energy", "low"), ("--energy", "nan")):
            with self.subTest(options):
                self.refused("surface-energy", self.cold, *options, code=2)


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
