# SPDX-License-Identifier: GPL-3.0-or-later
"""Converted dumps in the hands of other programs: LAMMPS' own text of the same run, LAMMPS reading them back,
MDAnalysis and ASE."""

import importlib.util
import re
import subprocess
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np

import lammps
import running

import dumps  # of tests/cli, where `lammps` has led to

COLUMNS = "id type x y z ix iy iz vx vy vz fx fy fz"

# Two hot slabs in a box, tilted or not, periodic in x and y; atoms cross its faces.
RUN = """
units        lj
atom_style   atomic
boundary     p p f
lattice      fcc 0.8
region       cell {cell}
create_box   2 cell
create_atoms 1 region cell
mass         1 1.25
mass         2 3.5
region       above block INF INF INF INF 2 INF
set          region above type 2
pair_style   lj/cut 2.5
pair_coeff   * * 1 1
velocity     all create 8 1
fix          wall all wall/reflect zlo EDGE zhi EDGE
fix          move all nve
compute      ke all ke/atom
dump         1 all custom 20 run.bin {columns}
dump         2 all custom 20 run.txt {columns}
dump         3 all custom 20 energy.txt id c_ke
dump_modify  1 units yes time yes
dump_modify  2 units yes time yes format float %.17g
dump_modify  3 sort id format float %.17g
thermo       20
thermo_style custom step pe ke pxx pxy
thermo_modify format float %.17g
timestep     0.00390625
run          100
"""
CELLS = {"tilted": "prism -3 3 -2 4 0 5 1.3 -0.7 0.4", "straight": "block -3 3 -2 4 0 5"}

# The frames of a dump put into the same system; energies, pressures and forces of each.
RERUN = """
units        lj
atom_style   atomic
boundary     p p f
region       cell {cell} units box
create_box   2 cell
mass         1 1.25
mass         2 3.5
pair_style   lj/cut 2.5
pair_coeff   * * 1 1
fix          move all nve
dump         1 all custom 20 {out} id fx fy fz
dump_modify  1 sort id format float %.17g
thermo       20
thermo_style custom step pe ke pxx pxy
thermo_modify format float %.17g
rerun        {dump} dump x y z ix iy iz vx vy vz purge yes replace no add keep box yes
"""


def run_lammps(place, name, text):
    """The lines of thermodynamic output: step -> numbers."""
    (place / f"{name}.in").write_text(text)
    done = subprocess.run(["lmp", "-in", f"{name}.in", "-log", "none"], cwd=place, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=300, check=False)
    if done.returncode:
        raise AssertionError(done.stdout + done.stderr)
    table = {}
    for line in done.stdout.splitlines():
        if re.fullmatch(r" *\d+( +[-+.e\d]+){4} *", line):
            step, *numbers = line.split()
            table[int(step)] = [float(number) for number in numbers]
    return table


def bounding_cell(dump):
    """The box of the first frame as a region of LAMMPS, in lengths of the box."""
    rows = [[float(word) for word in line.split()] for line in dumps.read(dump)[0].box.splitlines()[1:]]
    if len(rows[0]) == 2:
        return "block " + " ".join(f"{value!r}" for row in rows for value in row)
    (xlo, xhi, xy), (ylo, yhi, xz), (zlo, zhi, yz) = rows
    xlo, xhi = xlo - min(0, xy, xz, xy + xz), xhi - max(0, xy, xz, xy + xz)
    ylo, yhi = ylo - min(0, yz), yhi - max(0, yz)
    return f"prism {xlo!r} {xhi!r} {ylo!r} {yhi!r} {zlo!r} {zhi!r} {xy!r} {xz!r} {yz!r}"


class Converted(running.Case):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        cls.runs, cls.thermo = Path(scratch.name), {}
        for name, cell in CELLS.items():
            (cls.runs / name).mkdir()
            cls.thermo[name] = run_lammps(cls.runs / name, "run", RUN.format(cell=cell, columns=COLUMNS))
            assert len(cls.thermo[name]) == 6, cls.thermo[name]

    def convert(self, run, out, *options, dump="run.bin"):
        path = self.runs / run / out
        self.mdana("convert", self.runs / run / dump, "-o", path, *options)
        return path

    def assert_same(self, found, wanted):
        self.assertEqual(len(found), len(wanted))
        for a, b in zip(found, wanted):
            self.assertEqual((a.step, a.time, a.units, a.columns), (b.step, b.time, b.units, b.columns))
            self.assertEqual(a.box.splitlines()[0], b.box.splitlines()[0])
            for row, other in zip(a.box.splitlines()[1:], b.box.splitlines()[1:]):
                self.assertEqual([float(w) for w in row.split()], [float(w) for w in other.split()])
            np.testing.assert_array_equal(a.atoms, b.atoms)

    def test_binary_becomes_the_text_that_lammps_writes(self):
        """Both hold the same doubles: 17 digits tell them all apart."""
        for run in CELLS:
            text = dumps.read(self.runs / run / "run.txt")
            self.assertEqual([frame.step for frame in text], list(range(0, 101, 20)))
            for dump, name in (("run.bin", "from_binary.dump"), ("run.txt", "from_text.dump.gz")):
                path = self.convert(run, name, dump=dump)
                self.assert_same(dumps.read(path), text)
                self.assertEqual(self.box(path), self.box(self.runs / run / dump))

    def test_kinetic_energy_is_that_of_lammps(self):
        """Both multiply and add four numbers; 1e-15 are nine roundings."""
        for run in CELLS:
            ours = dumps.read(self.convert(run, "ke.dump", "--sort", "id", "--add", "ke", "--masses", "1=1.25,2=3.5"))
            for frame, energy in zip(ours, dumps.read(self.runs / run / "energy.txt"), strict=True):
                np.testing.assert_array_equal(frame["id"], energy["id"])
                np.testing.assert_allclose(frame["c_mdana_ke"], energy["c_ke"], rtol=1e-15)

    def test_lammps_reads_them_back(self):
        """`rerun` of a converted dump gives, to the last bit, what `rerun` of LAMMPS' own dump gives; and both give the
        energies and pressures of the run itself, of order 1e3 in sum and of atoms in another order: 1e-12. (Here an
        upper bound of the box that is wrong in its last place changes the energy by a per cent: the atoms of a new
        lattice lie on the faces of the box.)"""
        for run in CELLS:
            place = self.runs / run
            cell = bounding_cell(place / "run.txt")
            own = run_lammps(place, "own", RERUN.format(cell=cell, dump="run.txt", out="own.txt"))
            for name, options in (("plain.dump", []), ("packed.dump.gz", []), ("sorted.dump", ["--sort", "id"]),
                                  ("extended.dump", ["--add", "body,mass,ke,xu", "--masses", "1=1.25,2=3.5"]),
                                  ("omitted.dump", ["--omit", "units,time"])):
                self.convert(run, name, *options)
                ours = run_lammps(place, "ours", RERUN.format(cell=cell, dump=name, out="ours.txt"))
                self.assertEqual(sorted(ours), sorted(self.thermo[run]))
                for step, wanted in self.thermo[run].items():
                    np.testing.assert_allclose(ours[step], wanted, rtol=1e-12, atol=1e-12, err_msg=f"{name} {step}")
                if "sorted" not in name:
                    self.assertEqual(ours, own, name)
                    self.assertEqual((place / "ours.txt").read_bytes(), (place / "own.txt").read_bytes(), name)

    @unittest.skipUnless(importlib.util.find_spec("MDAnalysis"), "no MDAnalysis")
    def test_mdanalysis(self):
        """It has single precision, sorts by id, counts positions from the corner of the box, and does not know the
        lines that state units and times."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            import MDAnalysis
            from MDAnalysis.lib.mdamath import triclinic_box

            for run in CELLS:
                path = self.convert(run, "md.lammpstrj", "--omit", "units,time", "--add", "body", "--bodies", "type")
                frames = dumps.read(self.runs / run / "run.txt")
                universe = MDAnalysis.Universe.empty(len(frames[0].atoms))
                universe.load_new(str(path), format="LAMMPSDUMP")
                self.assertEqual(len(universe.trajectory), len(frames))
                box = np.array(self.box(self.runs / run / "run.bin")["edges"])
                origin = np.array(self.box(self.runs / run / "run.bin")["origin"])
                for state, frame in zip(universe.trajectory, frames):
                    self.assertEqual(state.data["step"], frame.step)
                    ordered = np.argsort(frame["id"][:, 0])
                    np.testing.assert_allclose(state.dimensions, triclinic_box(*box), rtol=1e-6)
                    np.testing.assert_allclose(state.positions, frame["x y z"][ordered] - origin, atol=2e-6)
                    np.testing.assert_allclose(state.velocities, frame["vx vy vz"][ordered], rtol=1e-6)
                    np.testing.assert_allclose(state.forces, frame["fx fy fz"][ordered], rtol=1e-6)

    def box(self, dump):
        return self.document("info", dump)["box"]

    @unittest.skipUnless(importlib.util.find_spec("ase"), "no ASE")
    def test_ase(self):
        """It keeps the added columns, because of their names."""
        import ase.io

        for run in CELLS:
            path = self.convert(run, "ase.lammpstrj", "--add", "body,mass,ke", "--bodies", "type", "--masses",
                                "1=1.25,2=3.5")
            frames = dumps.read(self.runs / run / "run.txt")
            images = ase.io.read(path, index=":", format="lammps-dump-text")
            self.assertEqual(len(images), len(frames))
            edges = self.box(self.runs / run / "run.bin")["edges"]
            for atoms, frame, ours in zip(images, frames, dumps.read(path)):
                ordered = np.argsort(frame["id"][:, 0])
                kind = frame["type"][ordered]
                np.testing.assert_allclose(atoms.cell.array, edges, rtol=1e-12, atol=1e-12)
                self.assertEqual(list(atoms.pbc), [True, True, False])
                np.testing.assert_allclose(atoms.positions, frame["x y z"][ordered], rtol=1e-12, atol=1e-12)
                np.testing.assert_array_equal(atoms.arrays["c_mdana_body"].reshape(-1, 1), kind)
                np.testing.assert_array_equal(atoms.arrays["c_mdana_mass"].reshape(-1, 1),
                                              np.where(kind == 1, 1.25, 3.5))
                np.testing.assert_array_equal(atoms.arrays["c_mdana_ke"].reshape(-1, 1), ours["c_mdana_ke"][ordered])


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
