# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinetic, thermal and rotational energy, temperature and potential energy of each body against what LAMMPS itself
computes in the same run at the same steps; and that the energy is all accounted for."""

import tempfile
from pathlib import Path

import numpy as np

import lammps
import running
from lammps import generate

# LAMMPS' own chunk computes: centre of mass, its velocity, kinetic energy and temperature about it (without rotation
# taken off: 3N - 3 degrees of freedom), angular velocity and momentum of each body; its c_pe is summed by body.
MEASURE = """
compute  bodies all chunk/atom type
compute  com all com/chunk bodies
compute  vcm all vcm/chunk bodies
compute  inner all temp/chunk bodies temp kecom internal com yes cdof -3
compute  omega all omega/chunk bodies
compute  spin all angmom/chunk bodies
compute  w1 body1 reduce sum c_pe
compute  w2 body2 reduce sum c_pe
fix      inner all ave/time 32 1 32 c_inner[*] mode vector file inner.txt format " %.15g"
fix      turn all ave/time 32 1 32 c_omega[*] c_spin[*] c_com[*] c_vcm[*] mode vector file turn.txt format " %.15g"
fix      w all ave/time 32 1 32 c_w1 c_w2 file w.txt format " %.15g"
thermo_modify norm {norm}
"""
ATOMS = 603  # of each body


def make(folder, name, norm, *arguments):
    (folder / f"{name}.lmp").write_text(MEASURE.format(norm=norm))
    generate(*arguments, "--columns", "id type x y z vx vy vz c_pe", "--include", folder / f"{name}.lmp", "-o", folder / name)
    return folder / name


class LammpsEnergy(running.Case):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        folder = Path(scratch.name)
        # warm, so that rotation and heat are no noise; glancing as the lattices are turned
        cls.run_dir = make(folder, "run", "no", "hertz", "--velocity", "0.3", "--duration", "20",
                           "--temperature", "1e-3")
        cls.dump, cls.log = cls.run_dir / "dump.lammpstrj.gz", cls.run_dir / "log.lammps"
        cls.per_atom = make(folder, "per_atom", "yes", "hertz", "--velocity", "0.3", "--duration", "8")
        out = folder / "energy.csv"
        done = running.run("energy", cls.dump, "-o", out)
        if done.returncode:
            raise AssertionError(done.stderr)
        cls.found = {name: np.array(column, float) for name, column in running.read_csv(out).items()}
        cls.steps = cls.found["step"].astype(int)

    def column(self, path, row, k):
        table = lammps.vectors(self.run_dir / path)
        return np.array([table[step][row, k] for step in self.steps])

    def assert_series(self, name, wanted, tolerance):
        """To a part of the greatest value of the series."""
        difference = np.max(np.abs(self.found[name] - wanted)) / np.max(np.abs(wanted))
        print(f"{name}: {difference:.1e}")
        self.assertLessEqual(difference, tolerance, name)

    def test_run(self):
        self.assertEqual(list(self.steps), list(range(0, 20 * 128 + 1, 32)))
        self.assertGreater(self.found["rotation1"].max(), 1e-4)

    # The dump has ten digits of v, each rounded at random: sums over 603 atoms are good to 1e-10, 1e-9 is asked for.

    def test_translation(self):
        for body in (1, 2):
            self.assert_series(f"K_p{body}", self.column("inner.txt", body - 1, 1), 1e-9)

    def test_thermal(self):
        for body in (1, 2):
            self.assert_series(f"K_t{body}", self.column("inner.txt", body - 1, 2), 1e-9)

    def test_temperature(self):
        """LAMMPS leaves rotation in, with 3N - 3 degrees of freedom."""
        for body in (1, 2):
            found = self.found[f"temperature{body}"] * (3 * ATOMS - 6) / 2 + self.found[f"rotation{body}"]
            wanted = self.column("inner.txt", body - 1, 0) * (3 * ATOMS - 3) / 2
            self.assertLessEqual(np.max(np.abs(found - wanted)), 1e-9 * np.max(wanted))

    def test_rotation(self):
        """E = omega.L/2."""
        for body in (1, 2):
            wanted = sum(self.column("turn.txt", body - 1, k) * self.column("turn.txt", body - 1, 3 + k)
                         for k in range(3)) / 2
            self.assert_series(f"rotation{body}", wanted, 1e-7)

    def test_potential(self):
        table = np.loadtxt(self.run_dir / "w.txt")
        rows = {int(row[0]): row[1:] for row in table}
        for body in (1, 2):
            self.assert_series(f"W{body}", np.array([rows[step][body - 1] for step in self.steps]), 1e-10)

    def logged(self, name):
        """A column of the last runs of the log, by the step."""
        head, rows = None, {}
        for line in self.log.read_text().splitlines():
            words = line.split()
            if words[:1] == ["Step"]:
                head = words
            elif head and len(words) == len(head) and words[0].isdigit():
                rows[int(words[0])] = float(words[head.index(name)])
        return np.array([rows[step] for step in self.steps])

    def test_total_energy_is_that_of_lammps(self):
        """The pair as a whole rests, so that the totals are the same; and no drift is added to LAMMPS' own."""
        scale = self.found["K_p_rel"][0]
        found, wanted = self.found["total"], self.logged("TotEng")
        difference = np.max(np.abs(found - wanted)) / scale
        print(f"total: {difference:.1e}, LAMMPS' own spread {np.ptp(wanted) / scale:.1e} of K_p")
        self.assertLessEqual(difference, 1e-7)  # twelve digits of W = 1e4 in the log, K_p = 1e1
        self.assertLess(np.ptp(wanted) / scale, 0.02)

    def test_budget_closes(self):
        document = self.document("energy", self.dump)
        energy = document["energy"]
        self.assertEqual(energy["potential_source"], "column c_pe")
        total = self.logged("TotEng")
        (a, b), (c, d) = energy["frames_before"], energy["frames_after"]
        drift = (total[c:d + 1].mean() - total[a:b + 1].mean()) / energy["K_p_initial"]["value"]
        self.assertAlmostEqual(document["energy_drift"]["value"], drift, delta=1e-7)
        lost = document["delta_K_p"]["value"] + document["delta_K_t"]["value"] + document["delta_W"]["value"]
        self.assertAlmostEqual(lost / energy["K_p_initial"]["value"], drift, delta=1e-7)

    def test_restitution(self):
        """e from LAMMPS' own velocities along the centre line; what is converted is 1 - e^2 but for the drift and the
        motion across the line, which is some per cent as the spheres glance off each other."""
        document = self.document("energy", self.dump)
        energy = {name: entry["value"] for name, entry in document["energy"].items() if isinstance(entry, dict)}
        x, v = (np.array([[self.column("turn.txt", body, first + k) for k in range(3)] for body in (0, 1)])
                for first in (6, 9))
        line, relative = (x[1] - x[0]).T, (v[1] - v[0]).T
        along = np.sum(line * relative, axis=1) / np.linalg.norm(line, axis=1)
        across = ATOMS / 4 * (np.sum(relative**2, axis=1) - along**2)
        (a, b), (c, d) = document["energy"]["frames_before"], document["energy"]["frames_after"]
        before, after = slice(a, b + 1), slice(c, d + 1)
        e = abs(along[after].mean() / along[before].mean())
        self.assertAlmostEqual(energy["restitution"], e, delta=1e-8)
        self.assertAlmostEqual(energy["across"] * energy["K_p_initial"], across[after].mean() - across[before].mean(),
                               delta=1e-8)
        self.assertGreater(energy["across"], 0.03)
        closed = energy["converted"] - document["energy_drift"]["value"] + energy["across"]
        print(f"1 - e^2 {energy['one_minus_e2']:.6f}, converted, drift and motion across {closed:.6f}")
        self.assertAlmostEqual(closed, energy["one_minus_e2"], delta=1e-3)
        self.assertGreater(energy["one_minus_e2"], 0.1)

    def test_log_says_the_same_as_the_column(self):
        by_column, by_log = self.document("energy", self.dump), self.document("energy", self.dump, "--log", self.log)
        self.assertFalse(by_log["energy"]["log_per_atom"])
        self.assertEqual(by_log["energy"]["log_frames"], len(self.steps))
        self.assertIn("log", by_log["energy"]["potential_source"])
        self.assertNotIn("c_pe", by_log["columns_read"])
        self.assertAlmostEqual(by_log["delta_W"]["value"], by_column["delta_W"]["value"],
                               delta=1e-7 * abs(by_column["delta_K_p"]["value"]))

    def test_energies_per_atom_are_told(self):
        dump, log = self.per_atom / "dump.lammpstrj.gz", self.per_atom / "log.lammps"
        found = self.table("energy", dump, "--log", log)["W_total"]
        by_atoms = self.table("energy", dump)["W_total"]
        self.assertTrue(self.document("energy", dump, "--log", log)["energy"]["log_per_atom"])
        self.assert_close(found, by_atoms, 1e-10, abs(by_atoms[0]), "W")

    def test_log_of_another_run_is_refused(self):
        message = self.refused("energy", self.dump, "--log", self.per_atom / "log.lammps")
        self.assertIn("kinetic energy is not that of the dump", message)


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
