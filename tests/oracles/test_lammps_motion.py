# SPDX-License-Identifier: GPL-3.0-or-later
"""Centres of mass, velocities and force against what LAMMPS itself computes in the same run at the same steps."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import lammps
import running
from lammps import generate

import dumps  # of tests/cli, where `lammps` has led to

# Read just before the collision starts. 32 steps is the dump interval of 0.25 tau.
MEASURE = """
compute  bodies all chunk/atom type
compute  com all com/chunk bodies
compute  vcm all vcm/chunk bodies
compute  f1 body1 reduce sum fx fy fz
compute  f2 body2 reduce sum fx fy fz
fix      com all ave/time 32 1 32 c_com[*] mode vector file com.txt format " %.15g"
fix      vcm all ave/time 32 1 32 c_vcm[*] mode vector file vcm.txt format " %.15g"
fix      f all ave/time 32 1 32 c_f1[*] c_f2[*] file f.txt format " %.15g"
"""
MASS = 603.0  # of each body: its atoms
DIGITS = 10   # of the dump's numbers, %.10g


def printing_error(values):
    """Standard deviation of the sum of printed values: each is uniform within one unit of its last digit."""
    sizes = np.abs(values[values != 0])
    units = 10.0 ** (np.floor(np.log10(sizes)) - DIGITS + 1)
    return np.sqrt(np.sum(units**2) / 12)


class LammpsMotion(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        cls.dir = Path(scratch.name)
        (cls.dir / "measure.lmp").write_text(MEASURE)
        run = cls.dir / "run"
        generate("hertz", "--velocity", "0.3", "--duration", "12", "--columns", "id type x y z vx vy vz fx fy fz",
                 "--format", f"%.{DIGITS}g", "--include", cls.dir / "measure.lmp", "-o", run)
        cls.dump = run / "dump.lammpstrj.gz"
        cls.frames = dumps.read(cls.dump)
        cls.steps = [frame.step for frame in cls.frames]
        com, vcm = lammps.vectors(run / "com.txt"), lammps.vectors(run / "vcm.txt")
        cls.com = np.array([com[step] for step in cls.steps])
        cls.vcm = np.array([vcm[step] for step in cls.steps])
        f = {int(row[0]): row[1:].reshape(2, 3) for row in np.loadtxt(run / "f.txt")}
        cls.f = np.array([f[step] for step in cls.steps])
        cls.line = cls.com[:, 1] - cls.com[:, 0]
        cls.tables = {source: cls.table(source) for source in ("forces", "velocities", "positions")}

    @classmethod
    def table(cls, source):
        out = cls.dir / f"{source}.csv"
        done = running.run("force", cls.dump, "--source", source, "-o", out)
        if done.returncode:
            raise AssertionError(done.stderr)
        return {name: np.array(column) for name, column in running.read_csv(out).items()}

    def tolerance(self, columns):
        """Eight standard deviations of the difference of the bodies' means, from the digits that were printed (over 50
        frames one in 1e13 tests fails by chance). LAMMPS' own 15 digits are far finer."""
        return 8 * max(np.hypot(*(printing_error(frame.body(b)[columns]) / MASS for b in (1, 2)))
                       for frame in self.frames)

    def test_run(self):
        """Frames at all steps, of a collision: approach, contact, the way back."""
        self.assertEqual(self.steps, list(range(0, 12 * 128 + 1, 32)))
        table = self.tables["forces"]
        self.assertEqual(list(table["step"]), self.steps)
        self.assertEqual(list(table["time"]), [step / 128 for step in self.steps])
        self.assertGreater(table["v"][0], 0.29)
        self.assertLess(table["v"][-1], -0.1)

    def test_distance(self):
        tolerance = self.tolerance("x y z")
        self.assertLess(tolerance, 1e-8)  # or the test says nothing
        wanted = np.linalg.norm(self.line, axis=1)
        for source, table in self.tables.items():
            self.assertLessEqual(np.max(np.abs(table["X"] - wanted)), tolerance, source)

    def test_velocity(self):
        tolerance = self.tolerance("vx vy vz")
        self.assertLess(tolerance, 1e-9)
        wanted = -dumps.along(self.vcm[:, 1] - self.vcm[:, 0], self.line)
        self.assertLessEqual(np.max(np.abs(self.tables["velocities"]["v"] - wanted)), tolerance)
        self.assertLessEqual(np.max(np.abs(self.tables["forces"]["v"] - wanted)), tolerance)

    def test_force(self):
        """m* (F2/m2 - F1/m1) along the centre line. The printed forces of single atoms are large and cancel in the sum:
        the tolerance is theirs, not the sum's."""
        reduced = MASS / 2
        tolerance = reduced * self.tolerance("fx fy fz")
        wanted = reduced * dumps.along((self.f[:, 1] - self.f[:, 0]) / MASS, self.line)
        self.assertLess(tolerance, 1e-7 * max(wanted))
        self.assertLessEqual(np.max(np.abs(self.tables["forces"]["F"] - wanted)), tolerance)

    def test_derivatives_agree_with_forces(self):
        """The force is a peak of some 4 tau, w = 1.6/tau: a quartic over five points with a step h = 0.25 loses of the
        order of (h w)^4/30 = 1e-3 of F_max, the sphere's own vibrations come on top. Root mean square below 0.3 %,
        greatest below 1 %; twice that from positions, which are differentiated twice. (A wrong sign, factor or a shift
        by a frame would give ten per cent and more.)"""
        exact = self.tables["forces"]["F"]
        for source, typical, greatest in (("velocities", 0.003, 0.01), ("positions", 0.006, 0.02)):
            difference = np.abs(self.tables[source]["F"] - exact) / max(exact)
            rms = np.sqrt(np.mean(difference**2))
            print(f"{source}: rms {rms:.2e}, greatest {max(difference):.2e} of F_max")
            self.assertLess(rms, typical, source)
            self.assertLess(max(difference), greatest, source)

    def test_work_is_the_change_of_kinetic_energy(self):
        """Over the whole run F does the work on the relative motion that LAMMPS' velocities show. The spheres glance
        off each other a little: their transverse velocity u is part of it, by X'' = F/m* + u^2/X. Trapezoids over frames of
        0.25 tau under a smooth peak of 3 tau that begins and ends at zero, and LAMMPS' own time step of 2^-7, are
        right to some 1e-4 of the energy; 1e-3 is asked for."""
        table, reduced = self.tables["forces"], MASS / 2
        velocity = self.vcm[:, 1] - self.vcm[:, 0]
        energy = reduced / 2 * np.sum(velocity**2, axis=1)
        radial = reduced / 2 * table["v"]**2
        turning = 2 * (energy - radial) / table["X"]  # m* u^2/X
        work = np.trapz((table["F"] + turning) * table["v"], table["time"])
        print(f"work {work:.5f}, change of energy {radial[0] - radial[-1]:.5f}, of {energy[0]:.2f}")
        self.assertAlmostEqual(work, radial[0] - radial[-1], delta=1e-3 * energy[0])


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
