# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdana check` end to end: nothing is found in a whole dump, and in a damaged one every fault at its place."""

import gzip
import random

import dumps
import running
from running import SAMPLE, Case

FRAMES = 6


def small_dump():
    """Lines of a dump of six frames of 16 atoms with times and units."""
    frames = [dumps.two_cubes(10 * k, 0.5 * k, 12.0 + k) for k in range(FRAMES)]
    return "".join(frame.text() for frame in frames).splitlines()


class Check(Case):
    def setUp(self):
        super().setUp()
        self.lines = small_dump()
        self.atom_lines = [k for k, line in enumerate(self.lines) if line[0].isdigit() and len(line.split()) > 10]
        self.headers = [k for k, line in enumerate(self.lines) if line == "ITEM: UNITS"]
        self.assertEqual(len(self.atom_lines), 16 * FRAMES)

    def write(self, text=None, name="some.dump"):
        path = self.dir / name
        text = "\n".join(self.lines) + "\n" if text is None else text
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def check(self, path, *arguments, code=3):
        return self.document("check", path, *arguments, code=code)

    def places(self, document):
        return [(fault["kind"], fault["line"]) for fault in document["faults"]]

    def word(self, line, column, text):
        words = self.lines[line].split()
        words[column] = text
        self.lines[line] = " ".join(words)

    def test_whole_dumps(self):
        document = self.check(SAMPLE, code=0)
        self.assertEqual((document["faults"], document["counts"], document["errors"], document["notes"]), ([], {}, 0, 0))
        self.assertEqual((document["frames"], document["atoms"]), (47, 47 * 1206))
        self.assertEqual(document["checked"], {"columns": "id type x y z vx vy vz".split(), "ids_compared": True,
                                               "to_the_end": True})
        self.assertEqual(document["inputs"][0]["path"], str(SAMPLE))
        text = self.mdana("check", SAMPLE).stdout
        self.assertIn("no faults", text)
        whole = "\n".join(self.lines) + "\n"
        for name, data in (("unix", whole), ("dos", whole.replace("\n", "\r\n")), ("zip", gzip.compress(whole.encode())),
                           ("tail", whole + "\n# end\n \n")):
            with self.subTest(name):
                self.assertEqual(self.check(self.write(data, name), code=0)["faults"], [])

    def test_one_word_anywhere(self):
        """Seeded: exactly the line of the word that is no number is told."""
        dice = random.Random(7)
        for _ in range(60):
            self.lines = small_dump()
            line = dice.choice(self.atom_lines)
            column = dice.randrange(len(dumps.COLUMNS))
            word = dice.choice(["x", "1.2.3", "--1", "0x1f", "1,5", "NA", "1e", "é"])
            self.word(line, column, word)
            with self.subTest(f"{word} in line {line + 1}, column {column}"):
                [fault] = self.check(self.write())["faults"]
                self.assertEqual((fault["kind"], fault["line"], fault["column"]),
                                 ("word", line + 1, dumps.COLUMNS[column]))
                frame = sum(start < line for start in self.headers) - 1
                self.assertEqual((fault["frame"], fault["step"]), (frame, 10 * frame))
                self.assertEqual((fault["severity"], fault["file"]), ("error", str(self.dir / "some.dump")))

    def test_each_damage_in_each_frame(self):
        for frame in range(FRAMES):
            atom = 16 * frame + 5

            def columns(line):
                self.lines[line] += " 1"

            def infinite(line):
                self.word(line, 5, "inf")

            def no_type(line):
                self.word(line, 1, "0")

            def twice(line):
                self.word(line, 0, self.lines[line - 1].split()[0])

            for kind, damage in (("line", columns), ("not_finite", infinite), ("type", no_type),
                                 ("duplicate_id", twice)):
                with self.subTest(f"{kind} in frame {frame}"):
                    self.lines = small_dump()
                    line = self.atom_lines[atom]
                    damage(line)
                    document = self.check(self.write())
                    errors = [fault for fault in document["faults"] if fault["severity"] == "error"]
                    self.assertEqual([(f["kind"], f["line"], f["frame"]) for f in errors], [(kind, line + 1, frame)])
                    self.assertEqual(document["errors"], 1)

    def test_two_faults_in_one_frame(self):
        first, second = self.atom_lines[20], self.atom_lines[27]
        self.word(first, 4, "?")
        self.lines[second] = "1 2 3"
        document = self.check(self.write())
        self.assertEqual(sorted(self.places(document)), [("line", second + 1), ("word", first + 1)])

    def test_headers_and_counts(self):
        """The frames behind a wrong header and behind a wrong number of atoms are looked at."""
        count = self.lines.index("ITEM: NUMBER OF ATOMS", self.headers[2]) + 1
        last = self.atom_lines[-1]
        for text, kind in (("many", "header"), ("17", "atom_count"), ("15", "atom_count"), ("0", "atom_count"),
                           ("999999999999999999", "atom_count"), ("-1", "header")):
            with self.subTest(text):
                self.lines = small_dump()
                self.lines[count] = text
                self.word(last, 3, "?")
                document = self.check(self.write())
                errors = [f for f in document["faults"] if f["severity"] == "error"]
                self.assertEqual([(f["kind"], f["frame"]) for f in errors], [(kind, 2), ("word", FRAMES - 1)])
                self.assertTrue(document["checked"]["to_the_end"])

    def test_cut_files(self):
        whole = ("\n".join(self.lines) + "\n").encode()
        packed = gzip.compress(whole)
        for name, data in (("cut", whole[:-100]), ("cut.gz", packed[:len(packed) * 3 // 4])):
            with self.subTest(name):
                document = self.check(self.write(data, name))
                [fault] = [f for f in document["faults"] if f["severity"] == "error"]
                self.assertEqual((fault["kind"], fault["file"]), ("truncated", str(self.dir / name)))
                self.assertFalse(document["checked"]["to_the_end"])
                self.assertEqual(len(document["warnings"]), 1)

    def test_notes_are_no_errors(self):
        self.word(self.atom_lines[40], 0, "99")
        document = self.check(self.write(), code=0)
        self.assertEqual(document["counts"], {"ids_lost": 1, "ids_gained": 1})
        self.assertEqual({fault["severity"] for fault in document["faults"]}, {"note"})

    def test_limit_and_threads(self):
        for line in self.atom_lines[10:60]:
            self.word(line, 6, "?")
        path = self.write()
        document = self.check(path)
        self.assertEqual((len(document["faults"]), document["counts"]), (20, {"word": 50}))
        for limit in (0, 1, 50, 100):
            found = self.check(path, "--limit", limit, "--threads", 1 + limit % 3)
            self.assertEqual(len(found["faults"]), min(limit, 50))
            self.assertEqual(found["counts"], {"word": 50})
            self.assertEqual(found["faults"][:20], document["faults"][:limit])

    def test_text_and_file(self):
        line = self.atom_lines[33]
        self.word(line, 2, "0.5.5")
        path, out = self.write(), self.dir / "out.json"
        text = self.mdana("check", path, "-o", out, code=3).stdout
        self.assertIn(f"{path}:{line + 1}: '0.5.5' in column x is not a number (frame 2, step 20)", text)
        document = running.parse_json(out.read_text())
        self.assertEqual(self.places(document), [("word", line + 1)])

    def test_not_readable_at_all(self):
        for name, data in (("empty", ""), ("none", "this is no dump\n")):
            self.refused("check", self.write(data, name), says=[name])
        self.refused("check", self.dir / "missing", says=["missing"])
        self.mdana("check", SAMPLE, "--limit", "-1", code=2)
        self.mdana("check", SAMPLE, "-o", "x.csv", code=2)

    def test_the_others_say_what_they_did_not_look_at(self):
        document = self.document("contact-radius", SAMPLE)
        self.assertEqual(document["columns_read"], "type x y z".split())
        self.assertEqual(document["columns_not_read"], "id vx vy vz".split())
        self.assertIn("vx", self.document("force", SAMPLE)["columns_read"])
        self.assertIn("columns_not_read", self.document("fit-hertz", SAMPLE))


if __name__ == "__main__":
    running.main()
