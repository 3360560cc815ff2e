# SPDX-License-Identifier: GPL-3.0-or-later
"""Binary dumps against text dumps of the same run of LAMMPS: where the text has 17 digits, which tell all doubles apart,
mdana must write the same bytes; where it has 10, the same numbers to these digits."""

import subprocess
import tempfile
import unittest
from pathlib import Path

import lammps
import running
from lammps import generate

COLUMNS = "id type x y z vx vy vz fx fy fz"

# Read just before the collision starts, when `frames`, the dump of the generator itself, is there.
DUMPS = f"""
dump         sorted1 all custom 32 sorted.bin {COLUMNS}
dump         sorted2 all custom 32 sorted.txt {COLUMNS}
dump         any1 all custom 32 any.bin {COLUMNS}
dump         any2 all custom 32 any.txt {COLUMNS}
dump_modify  sorted1 sort id units yes time yes
dump_modify  sorted2 sort id units yes time yes format float %.17g
dump_modify  any1 units yes time yes
dump_modify  any2 units yes time yes format float %.17g
"""

# Two hot slabs in a tilted, periodic box; atoms cross its faces.
TILTED = """
units        lj
atom_style   atomic
boundary     p p f
lattice      fcc 0.8
region       cell prism -2 2 -1 3 0 4 1.3 -0.7 0.4
create_box   2 cell
create_atoms 1 box
mass         * 1
region       above block INF INF INF INF 2 INF
set          region above type 2
pair_style   lj/cut 2.5
pair_coeff   * * 1 1
velocity     all create 8 1
fix          wall all wall/reflect zlo EDGE zhi EDGE
fix          move all nve
dump         custom1 all custom 16 custom.bin id type xu yu zu vx vy vz
dump         custom2 all custom 16 custom.txt id type xu yu zu vx vy vz
dump         atom1 all atom 16 atom.bin
dump         atom2 all atom 16 atom.txt
dump         plain1 all atom 16 plain.bin
dump         plain2 all atom 16 plain.txt
dump_modify  custom1 units yes time yes
dump_modify  custom2 units yes time yes format float %.17g
dump_modify  atom1 image yes time yes
dump_modify  atom2 image yes time yes format line "%d %d %.17g %.17g %.17g %d %d %d"
dump_modify  plain1 scale no time yes
dump_modify  plain2 scale no time yes format line "%d %d %.17g %.17g %.17g"
timestep     0.00390625
run          640
"""


class BinaryDump(running.Case):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        cls.runs = Path(scratch.name)
        (cls.runs / "dumps.lmp").write_text(DUMPS)
        for ranks in {1, lammps.ranks()}:
            generate("hertz", "--radius", 3, "--velocity", 0.3, "--duration", 12, "--columns", COLUMNS, "--ranks", ranks,
                     "--include", cls.runs / "dumps.lmp", "-o", cls.runs / f"collision{ranks}")
            cls.tilted(cls.runs / f"tilted{ranks}", ranks)

    @staticmethod
    def tilted(place, ranks):
        place.mkdir()
        (place / "in.lmp").write_text(TILTED)
        mpi = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks)] if ranks > 1 else []
        done = subprocess.run([*mpi, "lmp", "-in", "in.lmp", "-log", "none"], cwd=place, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=300, check=False)
        if done.returncode:
            raise AssertionError(done.stdout + done.stderr)

    def written(self, *arguments):
        """The bytes of the table that mdana writes."""
        out = self.dir / "table.csv"
        self.mdana(*arguments, "-o", out)
        return out.read_bytes()

    def assert_same_bytes(self, run, name, command, *options):
        binary, text = (self.written(command, self.runs / run / f"{name}.{end}", *options) for end in ("bin", "txt"))
        self.assertGreater(binary.count(b"\n"), 40)
        self.assertEqual(binary, text, f"{run}/{name}")

    def test_format_is_told(self):
        for run, name in (("collision1", "any"), ("tilted1", "atom"), ("tilted1", "custom")):
            binary, text = (self.document("info", self.runs / run / f"{name}.{end}", "--units", "lj")
                            for end in ("bin", "txt"))
            self.assertEqual(binary["format"], "lammps_binary")
            self.assertEqual(text["format"], "lammps_text")
            for key in ("frames", "steps", "atoms", "columns", "box"):
                self.assertEqual(binary[key], text[key], key)

    def test_collision(self):
        for ranks in {1, lammps.ranks()}:
            for name in ("sorted", "any"):
                for source in ("forces", "velocities", "positions"):
                    self.assert_same_bytes(f"collision{ranks}", name, "force", "--source", source)
                self.assert_same_bytes(f"collision{ranks}", name, "contact-radius", "--layer", "3")

    def test_ten_digits(self):
        """Coordinates below 10 are printed within 5e-10, speeds below 1 within 5e-11; so are their means exact within
        that, and distance and speed of two means within sqrt(3) times twice that. A force is the sum over 135 atoms,
        each below 1000 and printed within 5e-8."""
        place, options = self.runs / "collision1", ("--source", "forces", "--radius", "3")
        binary = self.table("force", place / "sorted.bin", *options)
        text = self.table("force", place / "dump.lammpstrj.gz", *options)
        self.assertEqual(binary["step"], text["step"])
        self.assertEqual(binary["time"], text["time"])
        for name, tolerance in (("X", 2e-9), ("delta", 2e-9), ("v", 2e-10), ("F", 135 * 5e-8 * 2)):
            self.assert_close(binary[name], text[name], tolerance, 1, name)

    def test_tilted_box(self):
        for ranks in {1, lammps.ranks()}:
            for name in ("custom", "atom", "plain"):
                self.assert_same_bytes(f"tilted{ranks}", name, "force", "--source", "positions", "--units", "lj")

    def test_unwrapped_and_scaled_with_images_are_the_same_place(self):
        place, options = self.runs / "tilted1", ("--source", "positions", "--units", "lj", "--radius", "1")
        unwrapped = self.table("force", place / "custom.bin", *options)
        images = self.table("force", place / "atom.bin", *options)
        wrapped = self.table("force", place / "plain.bin", *options)
        self.assert_close(images["X"], unwrapped["X"], 1e-13, 10, "X")
        self.assertGreater(max(abs(a - b) for a, b in zip(wrapped["X"], unwrapped["X"])), 0.01, "no atom crossed a face")


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
