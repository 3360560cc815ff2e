# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdana convert`: every number comes out as it went in; what is added has its known value; the file is whole or not
there."""

import os
import shutil
import signal
import subprocess
import time

import numpy as np

import dumps
import running
from running import SAMPLE, Case
from test_signals import long_dump


class Convert(Case):
    def convert(self, dump, name, *options, code=0):
        out = self.dir / name
        return out, self.document("convert", dump, "-o", out, *options, code=code)

    def assert_same_frames(self, found, wanted):
        self.assertEqual(len(found), len(wanted))
        for a, b in zip(found, wanted):
            self.assertEqual((a.step, a.time, a.columns), (b.step, b.time, b.columns))
            np.testing.assert_array_equal(a.atoms, b.atoms)

    def test_text_to_text(self):
        out, document = self.convert(SAMPLE, "out.lammpstrj")
        frames = dumps.read(SAMPLE)
        self.assert_same_frames(dumps.read(out), frames)
        self.assertTrue(out.read_text().startswith("ITEM: UNITS\nlj\nITEM: TIME\n36.5\nITEM: TIMESTEP\n4672\n"))
        self.assertEqual(out.read_text().count("ITEM: UNITS"), 1)
        self.assertIn("ITEM: BOX BOUNDS ff ff ff\n-38.4 38.4\n-25 25\n-25 25\n", out.read_text())
        self.assertEqual(document["frames"], len(frames))
        self.assertEqual(document["atoms"], [1206, 1206])
        self.assertEqual(document["steps"], [4672, 6144])
        self.assertEqual(document["columns"], frames[0].columns)
        self.assertEqual(document["output"], {"path": str(out), "size": out.stat().st_size, "format": "lammps_text"})
        self.assertEqual(document["inputs"][0]["path"], str(SAMPLE))
        self.assertRegex(document["inputs"][0]["hash"], r"\Axxh3:[0-9a-f]{32}\Z")
        again, _ = self.convert(out, "again.dump")
        self.assertEqual(again.read_bytes(), out.read_bytes())
        self.assertEqual(sorted(os.listdir(self.dir)), ["again.dump", "out.lammpstrj"])

    def test_results_are_the_same(self):
        out, _ = self.convert(SAMPLE, "out.lammpstrj.gz")
        shutil.copy(SAMPLE.parent / "scene.toml", self.dir)
        scene = ("--scene", self.dir / "scene.toml")
        self.assertEqual(self.table("force", out, *scene), self.table("force", SAMPLE))

    def test_compressed(self):
        plain, _ = self.convert(SAMPLE, "plain.dump")
        packed, _ = self.convert(SAMPLE, "packed.dump.gz")
        self.assertEqual(packed.read_bytes()[:2], b"\x1f\x8b")
        self.assertEqual(dumps.read_text(packed), plain.read_text())
        done = running.run("convert", SAMPLE, "-o", self.dir / "packed.dump.zst")
        if "without zstd" in done.stderr:
            self.skipTest("no zstd")
        self.assertEqual(done.returncode, 0)
        self.assertEqual((self.dir / "packed.dump.zst").read_bytes()[:4], b"\x28\xb5\x2f\xfd")
        back, _ = self.convert(self.dir / "packed.dump.zst", "back.dump")
        self.assertEqual(back.read_bytes(), plain.read_bytes())
        if tool := shutil.which("zstd"):
            self.assertEqual(subprocess.run([tool, "-dcq", self.dir / "packed.dump.zst"], capture_output=True,
                                            check=True).stdout, plain.read_bytes())

    def test_any_name_with_format(self):
        plain, _ = self.convert(SAMPLE, "plain.dump")
        out, _ = self.convert(SAMPLE, "dump.0", "--format", "lammps_text")
        self.assertEqual(out.read_bytes(), plain.read_bytes())
        out, _ = self.convert(SAMPLE, "out.json", "--format", "lammps_text")
        self.assertEqual(out.read_bytes(), plain.read_bytes())

    def test_threads_change_nothing(self):
        one, _ = self.convert(SAMPLE, "one.dump", "--threads", 1, "--add", "body,xu")
        many, _ = self.convert(SAMPLE, "many.dump", "--threads", 5, "--add", "body,xu")
        self.assertEqual(one.read_bytes(), many.read_bytes())

    def test_columns_and_stride(self):
        out, document = self.convert(SAMPLE, "out.dump", "--columns", "vz,id,x", "--stride", 5)
        wanted = dumps.read(SAMPLE)[::5]
        self.assertEqual(document["columns"], ["vz", "id", "x"])
        self.assert_same_frames(dumps.read(out), [dumps.Frame(f.step, f.time, ["vz", "id", "x"], f["vz id x"])
                                                  for f in wanted])
        self.assertIn("no column 'fx'", self.refused_conversion(SAMPLE, "--columns", "id,fx"))

    def test_numbers_words_and_columns_as_they_stand(self):
        """Image flags, scaled positions and words are not touched; columns and atoms may change between frames."""
        text = ("# a comment\nITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\n"
                "ITEM: BOX BOUNDS xy xz yz pp pp ff\n-5 6.1 2\n-2 3 -1\n0 16 1\n"
                "ITEM: ATOMS id element xs ys zs ix iy iz c_a[1]\n"
                "9007199254740993 Ar 0.1 1e-320 -0 -1 0 2 nan\n-3 H 0.30000000000000004 -inf 1.7976931348623157e+308 0 "
                "0 0 17\n"
                "ITEM: TIMESTEP\n8\nITEM: NUMBER OF ATOMS\n0\nITEM: BOX BOUNDS abc origin pp pp ff\n1 0.1 0 5\n"
                "0.2 1 0 6\n0 0.5 1 7\nITEM: ATOMS mol\n")
        path = self.dir / "in.dump"
        path.write_text(text)
        out, document = self.convert(path, "out.dump")
        # All numbers are as short as can be already, so the text is the same but for the comment.
        self.assertEqual(out.read_text(), text.replace("# a comment\n", ""))
        self.assertEqual(document["atoms"], [0, 2])
        self.assertIsNone(document["units"])
        self.assertTrue(any("columns change" in w for w in document["warnings"]))

    def test_units_and_times_are_stated(self):
        bare = self.dir / "bare.dump"
        frame = dumps.two_cubes(10, None, 12.0, units=None)
        dumps.write(bare, [frame, dumps.two_cubes(20, None, 11.0, units=None)])
        out, document = self.convert(bare, "out.dump", "--units", "metal", "--timestep", 0.25)
        self.assertEqual([(f.units, f.time, f.step) for f in dumps.read(out)], [("metal", 2.5, 10), (None, 5.0, 20)])
        self.assertEqual((document["units"], document["units_source"]), ("metal", "option"))
        out, _ = self.convert(bare, "nothing.dump")
        self.assertNotIn("UNITS", out.read_text())
        self.assertNotIn("ITEM: TIME\n", out.read_text())
        out, _ = self.convert(SAMPLE, "omitted.dump", "--omit", "units,time")
        self.assertEqual([(f.units, f.time) for f in dumps.read(out)], [(None, None)] * 47)
        self.assertIn("units metal by the option", self.refused_conversion(SAMPLE, "--units", "metal"))

    def test_added_columns(self):
        out, document = self.convert(SAMPLE, "out.dump", "--add", "body,mass,ke,xu", "--masses", "1=2,2=3")
        self.assertEqual(document["columns"][-6:], ["c_mdana_body", "c_mdana_mass", "c_mdana_ke", "xu", "yu", "zu"])
        for frame in dumps.read(out):
            kind = frame["type"][:, 0]
            np.testing.assert_array_equal(frame["c_mdana_body"][:, 0], kind)
            np.testing.assert_array_equal(frame["c_mdana_mass"][:, 0], kind + 1)
            # Four products and sums, each rounded by 1.1e-16.
            np.testing.assert_allclose(frame["c_mdana_ke"][:, 0], (kind + 1) / 2 * np.sum(frame["vx vy vz"]**2, axis=1),
                                       rtol=1e-15)
            np.testing.assert_array_equal(frame["xu yu zu"], frame["x y z"])

    def test_bodies_by_rule(self):
        out, _ = self.convert(SAMPLE, "out.dump", "--add", "body", "--bodies", "id:1-100")
        for frame in dumps.read(out):
            np.testing.assert_array_equal(frame["c_mdana_body"], np.where(frame["id"] <= 100, 1, 2))

    def test_kinetic_energy_in_metal_units(self):
        """1 g/mol at 1 Å/ps is 1.0364269e-4 eV twice over (LAMMPS: mvv2e)."""
        path = dumps.write(self.dir / "in.dump", [dumps.two_cubes(0, 0.0, 12.0, speed=2.0, units="metal")])
        out, _ = self.convert(path, "out.dump", "--add", "ke", "--masses", "1=1,2=1")
        np.testing.assert_allclose(dumps.read(out)[0]["c_mdana_ke"], 1.0364269e-4 / 2, rtol=1e-14)
        self.assertIn("--masses", self.refused_conversion(path, "--add", "ke"))

    def test_unwrapped(self):
        box = "ITEM: BOX BOUNDS xy xz yz pp pp ff\n-5 6 2\n-2 3 -1\n0 16 1\n"  # edges (8,0,0) (2,4,0) (-1,1,16)
        columns = "id x y z ix iy iz".split()
        atoms = np.array([[1, 0.5, 0.25, 8, 1, 0, -2], [2, 1, 1, 1, 0, 0, 0]])
        path = dumps.write(self.dir / "in.dump", [dumps.Frame(0, None, columns, atoms, "lj", box)])
        out, _ = self.convert(path, "out.dump", "--add", "xu")
        [frame] = dumps.read(out)
        np.testing.assert_array_equal(frame["x y z"], atoms[:, 1:4])
        np.testing.assert_array_equal(frame["xu yu zu"], [[0.5 + 8 + 2, 0.25 - 2, 8 - 32], [1, 1, 1]])
        again, document = self.convert(out, "again.dump", "--add", "xu")
        self.assertEqual(again.read_bytes(), out.read_bytes())
        self.assertIn("xu", document["left_out"][0]["reason"])
        wrapped, document = self.convert(path, "wrapped.dump", "--columns", "id,x,y,z")
        self.assertEqual(document["warnings"], [])
        _, document = self.convert(wrapped, "jumps.dump", "--add", "xu")
        self.assertIn("image flags", document["warnings"][0])

    def test_added_twice(self):
        out, _ = self.convert(SAMPLE, "out.dump", "--add", "body")
        self.assertIn("c_mdana_body", self.refused_conversion(out, "--add", "body"))

    def test_sort(self):
        """Frames of more than one block, shuffled; ids with gaps."""
        rng = np.random.default_rng(5)
        count = 70_001
        atoms = np.column_stack([3 * rng.permutation(count) - 100, rng.integers(1, 3, count), rng.normal(size=count)])
        path = dumps.write(self.dir / "in.dump", [dumps.Frame(k, None, ["id", "type", "q"], rng.permutation(atoms))
                                                  for k in range(2)])
        wanted = atoms[np.argsort(atoms[:, 0])]
        out, _ = self.convert(path, "out.dump", "--sort", "id")
        for frame in dumps.read(out):
            np.testing.assert_array_equal(frame.atoms, wanted)
        by_type, _ = self.convert(out, "types.dump", "--sort", "type", "--columns", "q,id")
        stable = wanted[np.argsort(wanted[:, 1], kind="stable")]
        for frame in dumps.read(by_type):
            np.testing.assert_array_equal(frame["q id"], stable[:, [2, 0]])
        self.assertIn("no column 'mol'", self.refused_conversion(path, "--sort", "mol"))

    def test_sets_become_one_file(self):
        frames = dumps.split(dumps.read_text(SAMPLE))
        for text in frames:
            (self.dir / f"step.{dumps.parse(text).step}.dump").write_text(text)
        out, document = self.convert(self.dir / "step.*.dump", "all.lammpstrj")
        whole, _ = self.convert(SAMPLE, "whole.lammpstrj")
        self.assertEqual(out.read_bytes(), whole.read_bytes())
        self.assertEqual(len(document["inputs"]), len(frames))
        self.refused_conversion(self.dir / "step.*.dump", out=self.dir / "step.4672.dump", left="is the input")

    def test_a_cut_dump_gives_its_whole_frames(self):
        texts = dumps.split(dumps.read_text(SAMPLE))
        whole = self.dir / "whole.dump"
        whole.write_text("".join(texts[:5]))
        wanted, _ = self.convert(whole, "wanted.dump")
        for name, rest in (("atoms", texts[5][:-1000]), ("header", texts[5][:60]),
                           ("word", texts[5].replace(" ", " x", 30).replace(" x", " ", 29))):
            for sort in ([], ["--sort", "id"]):
                with self.subTest(name, sort=sort):
                    cut = self.dir / "cut.dump"
                    cut.write_text("".join(texts[:5]) + rest)
                    out, document = self.convert(cut, "out.dump", *sort, code=3)
                    self.assertEqual(out.read_bytes(), wanted.read_bytes())
                    self.assertEqual(document["frames"], 5)
                    self.assertIn("the 5 whole frames", document["warnings"][0])
                    self.assertEqual(document["inputs"][0]["size"], cut.stat().st_size)
        first = self.dir / "first.dump"
        first.write_text(texts[0][:-1000])
        self.refused_conversion(first)

    def refused_conversion(self, dump, *options, out=None, left="", code=1):
        """Its message; an older file in the output's place is still there, and no other."""
        target = out or self.dir / "refused.dump"
        if not out:
            target.write_text("older")
        older, names = target.read_bytes(), sorted(os.listdir(self.dir))
        done = self.mdana("convert", dump, "-o", target, *options, code=code)
        self.assertEqual(done.stdout, "")
        self.assertEqual(target.read_bytes(), older)
        self.assertEqual(sorted(os.listdir(self.dir)), names)
        self.assertIn(left, done.stderr)
        return done.stderr

    def test_the_input_is_not_overwritten(self):
        path = self.dir / "in.dump"
        path.write_bytes(dumps.read_text(SAMPLE).encode())
        os.symlink(path, self.dir / "link.dump")
        os.link(path, self.dir / "hard.dump")
        for name in ("in.dump", "link.dump", "hard.dump"):
            self.refused_conversion(path, out=self.dir / name, left="the output is the input")

    def test_usage(self):
        out = ["-o", self.dir / "out.dump"]
        for arguments in ([], ["-o", self.dir / "out.xyz"], ["-o", self.dir / "dump"], [*out, "--format", "magic"],
                          [*out, "--format", "lammps_binary"], [*out, "--add", "colour"], [*out, "--add", "body,body"],
                          [*out, "--columns", ""], [*out, "--columns", "id,,x"], [*out, "--columns", "id,id"],
                          [*out, "--sort", "x"], [*out, "--stride", "0"], [*out, "--omit", "step"],
                          [*out, "--threads", "-1"], [*out, "--radius", "5"]):
            with self.subTest(arguments):
                done = self.mdana("convert", "/no/such/dump", *arguments, code=2)
                self.assertEqual(done.stderr.splitlines()[-1], "Try: mdana convert --help")
        self.assertIn("whole frame", self.mdana("convert", "--help").stdout)

    def test_places_that_cannot_be_written(self):
        self.assertIn("No such file", self.mdana("convert", SAMPLE, "-o", self.dir / "no" / "out.dump", code=1).stderr)
        (self.dir / "taken.dump").mkdir()
        self.assertIn("taken.dump", self.mdana("convert", SAMPLE, "-o", self.dir / "taken.dump", code=1).stderr)
        self.assertEqual(os.listdir(self.dir), ["taken.dump"])

    def test_a_full_disk(self):
        """A limit on the size of files stands for it."""
        import resource

        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1_000_000, 1_000_000))

        done = self.mdana("convert", SAMPLE, "-o", self.dir / "out.dump", code=1, preexec_fn=limit)
        self.assertRegex(done.stderr, rf"\Amdana: {self.dir}/out.dump: cannot write: ")
        self.assertEqual(os.listdir(self.dir), [])

    def test_signals_leave_nothing(self):
        dump = self.dir / "long.gz"
        long_dump(dump)
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 75)):
            for options in ([], ["--sort", "id"]):
                with subprocess.Popen([running.program, "convert", dump, "-o", self.dir / "out.dump", *options],
                                      stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
                    try:
                        deadline = time.monotonic() + 30
                        while len(os.listdir(self.dir)) < 2 and time.monotonic() < deadline:
                            time.sleep(0.01)
                        self.assertEqual(len(os.listdir(self.dir)), 2)  # it is at work
                        process.send_signal(number)
                        out, error = process.communicate(timeout=20)
                    finally:
                        process.kill()
                self.assertEqual((process.returncode, out), (code, ""))
                self.assertIn("nothing was written", error)
                self.assertEqual(os.listdir(self.dir), ["long.gz"])


if __name__ == "__main__":
    running.main()
