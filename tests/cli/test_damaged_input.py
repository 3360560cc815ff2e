# SPDX-License-Identifier: GPL-3.0-or-later
"""Input that is damaged on the way: the whole frames before the damage are used, which is said, with exit code 3."""

import gzip
import zlib

import dumps
import running
from running import SAMPLE, Case

COMMANDS = ("force", "contact-radius")
CUT = 29  # whole frames before the damage, of 47


class Damaged(Case):
    @classmethod
    def setUpClass(cls):
        cls.texts = dumps.split(dumps.read_text(SAMPLE))
        cls.head_lines = cls.texts[CUT].index("\n", cls.texts[CUT].index("ITEM: ATOMS")) + 1

    def write(self, name, data):
        path = self.dir / name
        path.write_bytes(data if isinstance(data, bytes) else data.encode())
        return path

    def whole(self, count):
        return "".join(self.texts[:count])

    def assert_frames(self, path, count, *says):
        """What comes of the damaged dump is, to the last byte of the table, what comes of its whole frames."""
        reference = self.write("reference.dump", self.whole(count))
        self.assertEqual(self.document("info", path, "--units", "lj", code=3)["frames"], count)
        for command in COMMANDS:
            tables = []
            for dump, code in ((path, 3), (reference, 0)):
                out = self.dir / "out.csv"
                out.unlink(missing_ok=True)
                done = self.mdana(command, dump, "--radius", "5", "--json", "-o", out, code=code)
                document = running.parse_json(done.stdout)
                tables.append(out.read_bytes())
                if code == 3:
                    [warning] = [w for w in document["warnings"] if w.startswith("damaged input")]
                    for text in (f"the {count} whole frames", path, *says):
                        self.assertIn(str(text), warning)
                    self.assertEqual(document["frames"], count)
                self.assertEqual(sorted(p.name for p in self.dir.iterdir() if p.name.startswith(("out", ".out"))),
                                 ["out.csv"])
            self.assertEqual(*tables)
            self.assertEqual(tables[0].count(b"\n"), count + 1)

    def test_cut_anywhere_in_a_frame(self):
        before, frame = self.whole(CUT), self.texts[CUT]
        for name, length in [
            ("in the first word", 3), ("in the header", 60), ("after the header", self.head_lines),
            ("in a number", self.head_lines + 1000), ("one byte early", len(frame) - 1),
            ("half of the last line", len(frame) - 30),
        ]:
            with self.subTest(name):
                path = self.write("cut.dump", before + frame[:length])
                self.assert_frames(path, CUT, f"frame {CUT}")

    def test_cut_between_lines(self):
        lines = self.texts[CUT].splitlines(keepends=True)
        path = self.write("cut.dump", self.whole(CUT) + "".join(lines[:-10]))
        self.assert_frames(path, CUT, "10 whole lines are missing")

    def test_cut_between_frames_is_no_damage(self):
        path = self.write("short.dump", self.whole(CUT))
        self.assertEqual(self.document("force", path, "--radius", "5")["frames"], CUT)

    def test_cut_gzip(self):
        """How much a cut gzip holds is asked of Python's zlib."""
        data = SAMPLE.read_bytes()
        for share in (0.35, 0.62, 0.9):
            with self.subTest(share):
                cut = data[:int(share * len(data))]
                count = len(dumps.split(self.without_last(zlib.decompressobj(31).decompress(cut).decode())))
                path = self.write("cut.gz", cut)
                self.assert_frames(path, count, "gzip")

    def without_last(self, text):
        """The text up to the frame that is cut."""
        count = text.count("ITEM: TIMESTEP\n") - 1
        self.assertTrue(text.startswith(self.whole(count)))
        return self.whole(count)

    def test_gzip_that_lacks_only_its_check_sum(self):
        """All frames are there, but nothing says that they are right."""
        path = self.write("cut.gz", SAMPLE.read_bytes()[:-5])
        self.assert_frames(path, len(self.texts), "gzip")

    def test_gzip_with_a_flipped_bit(self):
        """Somewhere the stream stops making sense, at the latest at its check sum; it must not go unnoticed."""
        data = bytearray(SAMPLE.read_bytes())
        data[len(data) // 2] ^= 16
        path = self.write("flipped.gz", bytes(data))
        for command in ("info", *COMMANDS):
            warnings = self.document(command, path, code=3)["warnings"]
            self.assertTrue(any(w.startswith("damaged input") for w in warnings))

    def test_gzip_in_members(self):
        """Appended gzip files are one text (that is what LAMMPS' append and cat make); not damaged."""
        path = self.write("members.gz", b"".join(gzip.compress(text.encode()) for text in self.texts[:CUT]))
        self.assertEqual(self.document("force", path, "--radius", "5")["frames"], CUT)

    def test_wrong_lines(self):
        """The line is named as file:line."""
        number = self.whole(CUT).count("\n") + self.texts[CUT][:self.head_lines].count("\n") + 5  # the fifth atom
        for name, change, says in [
            ("a word", lambda words: ["x" if k == 3 else w for k, w in enumerate(words)], "'x' in column y"),
            ("a column lost", lambda words: words[:4], "4 columns (the header names 8)"),
            ("an empty line", lambda words: [], "0 columns"),
        ]:
            with self.subTest(name):
                lines = (self.whole(CUT + 3)).splitlines()
                lines[number - 1] = " ".join(change(lines[number - 1].split()))
                path = self.write("wrong.dump", "\n".join(lines) + "\n")
                done = running.run("force", path, "--radius", "5", "--json")
                self.assertEqual(done.returncode, 3)
                document = running.parse_json(done.stdout)
                [warning] = [w for w in document["warnings"] if w.startswith("damaged input")]
                self.assertIn(f"{path}:{number}: ", warning)
                self.assertIn(says, warning)
                self.assertEqual(document["frames"], CUT)

    def test_a_value_that_is_not_finite(self):
        text = self.texts[CUT]
        line = text.splitlines()[-7]
        words = line.split()
        path = self.write("nan.dump", self.whole(CUT) + text.replace(line, " ".join(words[:3] + ["nan"] + words[4:])))
        document = self.document("force", path, "--radius", "5", code=3)
        self.assertEqual(document["frames"], CUT)

    def test_wrong_number_of_atoms(self):
        """One too few: an atom stands where the next header should. One too many: the header stands among the atoms."""
        for count in (1205, 1207):
            with self.subTest(count):
                texts = list(self.texts[:CUT + 3])
                texts[CUT] = texts[CUT].replace("OF ATOMS\n1206\n", f"OF ATOMS\n{count}\n")
                path = self.write("count.dump", "".join(texts))
                done = running.run("force", path, "--radius", "5", "--json")
                if count == 1205 and done.returncode == 1:  # atoms lost, which may as well be real: refused
                    self.assertIn(str(path), done.stderr)
                    self.assertIn("lost", done.stderr)
                    continue
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertEqual(running.parse_json(done.stdout)["frames"], CUT)

    def test_frames_out_of_order(self):
        """As after a restart that went back: the same step again."""
        path = self.write("again.dump", self.whole(CUT) + "".join(self.texts[CUT - 3:]))
        self.assert_frames_in_order(path)

    def assert_frames_in_order(self, path):
        document = self.document("force", path, "--radius", "5", code=3)
        self.assertEqual(document["frames"], CUT)
        self.assertTrue(any("step" in w for w in document["warnings"]))

    def test_damage_in_the_first_frame_leaves_nothing(self):
        path = self.write("first.dump", self.texts[0][:20000])
        for command in ("info", *COMMANDS, "fit-hertz"):
            with self.subTest(command):
                self.refused(command, path, "--radius", "5", says=(path, "frame 0"))


if __name__ == "__main__":
    running.main()
