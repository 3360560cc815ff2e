# SPDX-License-Identifier: GPL-3.0-or-later
"""What LAMMPS writes during a run by the lines of mdana emit --for lammps-inline, against the dump of the same run at the same
steps: force, energies, fits and their documents."""

import tempfile
from pathlib import Path

import numpy as np

import lammps
import running
from lammps import generate
from running import Case

SAMPLE = running.ROOT / "sample-data" / "hertz-tiny" / "dump.lammpstrj.gz"
EVERY = 32  # steps: a frame of the dump, which here has all digits

# A sum over 603 atoms in another order: 603 roundings of 2^-53, of terms that are larger than the sum where they cancel.
ROUNDING = 603 * 2.0**-53


class LammpsInline(Case):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        folder = Path(scratch.name)
        lines = folder / "inline.lmp"
        done = running.run("emit", "--for", "lammps-inline", SAMPLE, "--every", EVERY, "-o", lines)
        if done.returncode:
            raise AssertionError(done.stderr)
        generate("hertz", "--velocity", "0.3", "--duration", "12", "--columns", "id type x y z vx vy vz fx fy fz c_pe",
                 "--format", "%.17g", "--include", lines, "-o", folder / "run")
        cls.dump = folder / "run" / "dump.lammpstrj.gz"
        cls.log = folder / "run" / "mdana-inline.txt"

    def both(self, *command):
        """Documents and tables of the dump and of the file."""
        found = []
        for path in (self.dump, self.log):
            table = self.table(*command, path)
            found.append((self.document(*command, path), {name: np.array(column) for name, column in table.items()}))
        return found

    def assert_alike(self, a, b, scale, what):
        self.assertEqual(len(a), len(b), what)
        self.assertLessEqual(np.max(np.abs(a - b)), ROUNDING * scale, what)

    def test_force(self):
        (document, dump), (of_log, log) = self.both("force")
        self.assertEqual(len(dump["step"]), 12 * 128 // EVERY + 1)
        self.assertEqual(list(log["step"]), list(dump["step"]))
        self.assertEqual(list(log["time"]), list(dump["time"]))
        self.assertEqual(list(log["phase"]), list(dump["phase"]))
        self.assert_alike(log["X"], dump["X"], max(dump["X"]), "X")
        self.assert_alike(log["v"], dump["v"], max(abs(dump["v"])), "v")
        # Forces within a body, here no larger than those between the bodies, cancel in the sum.
        self.assert_alike(log["F"], dump["F"], max(abs(dump["F"])), "F")
        self.assertEqual(of_log["force_source"], "forces")
        for name in ("F_max", "F_min_loading", "delta_max", "hysteresis_area", "kinetic_loss", "e", "speed_before"):
            a, b = of_log[name], document[name]
            self.assertLessEqual(abs(a["value"] - b["value"]), 1e-9 * abs(document["F_max"]["value"]), name)
            self.assertLessEqual(abs(a["error"] - b["error"]), 1e-6 * max(b["error"], abs(b["value"])), name)
        for name in ("outcome", "units", "radius_source", "cycles"):
            self.assertEqual(of_log[name], document[name], name)
        self.assertEqual(of_log["lost"], 0)

    def test_energy(self):
        (document, dump), (of_log, log) = self.both("energy")
        total = max(dump["K_p_rel"])
        for name in ("K_p1", "K_p2", "K_p_rel", "K_t1", "K_t2", "rotation1", "rotation2"):
            self.assert_alike(log[name], dump[name], total, name)
        for name in ("W1", "W2"):
            self.assert_alike(log[name], dump[name], max(abs(dump[name])), name)
        self.assertEqual(set(log), set(dump))
        for name in ("delta_K_p", "delta_K_t", "delta_W", "energy_drift"):
            if name in document:
                self.assertLessEqual(abs(of_log[name]["value"] - document[name]["value"]), 1e-7 * total, name)
        self.assertIn("exchanged atoms", [entry["what"] for entry in of_log["left_out"]])

    def test_fits(self):
        for command in (("fit-hertz",), ("fit-force", "--law", "hertz", "--free", "E,R")):
            (document, _), (of_log, _) = self.both(*command)
            for name in ("E_star", "R"):
                if name in document:
                    a, b = of_log[name], document[name]
                    self.assertLessEqual(abs(a["value"] - b["value"]), 1e-6 * b["value"], name)
                    self.assertLessEqual(abs(a["error"] - b["error"]), 1e-3 * b["error"], name)

    def test_a_part_of_the_rows(self):
        for choice in (("--stride", "2"), ("--frames", "5:40:3")):
            (_, dump), (_, log) = self.both("force", *choice)
            self.assertEqual(list(log["step"]), list(dump["step"]))

    def test_what_needs_atoms_says_so(self):
        for command in ("contact-radius", "collision", "defects", "info", "check", "compress"):
            error = self.mdana(command, self.log, code=1).stderr
            self.assertRegex(error, "atoms", command)

    def test_without_a_radius_it_is_measured(self):
        """sqrt(5/3) r_g, from moments of inertia."""
        text = self.log.read_text().replace(" radii=5,5 radius_definition=cut", "", 1)
        bare = self.dir / "bare.txt"
        bare.write_text(text)
        lone = self.dir / "dump.lammpstrj.gz"
        lone.write_bytes(self.dump.read_bytes())
        a = self.document("force", bare)
        b = self.document("force", lone)
        self.assertEqual(a["radius_source"], b["radius_source"])
        self.assertLessEqual(abs(a["radius_sum"]["value"] - b["radius_sum"]["value"]), 1e-12 * b["radius_sum"]["value"])


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
