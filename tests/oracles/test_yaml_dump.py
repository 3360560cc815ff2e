# SPDX-License-Identifier: GPL-3.0-or-later
"""YAML dumps against text dumps: the small dump of sample-data, written anew as LAMMPS' dump style yaml writes it (Debian's
LAMMPS lacks it), is read by a YAML library to the numbers of the text, and by mdana to the same tables."""

import gzip

import lammps  # noqa: F401, finds running
import running

try:
    import yaml
except ImportError:
    running.skip("no yaml module (Debian: apt install python3-yaml)")

TEXT = gzip.open(running.SAMPLE, "rt").read()
FASTEST = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


SECTIONS = ("TIMESTEP", "TIME", "UNITS", "NUMBER OF ATOMS", "BOX BOUNDS", "ATOMS")


def frames(text):
    """The sections of each frame of a text dump by name: the words behind the name, then those of its lines. Units, which
    a text dump states in its first frame only, belong to all."""
    frame = {}
    for section in text.split("ITEM: ")[1:]:
        head, *lines = section.splitlines()
        name = next(known for known in SECTIONS if head.startswith(known))
        frame[name] = [head[len(name):].split(), *(line.split() for line in lines)]
        if name == "ATOMS":
            yield frame
            frame = {"UNITS": frame["UNITS"]}


def flow(words):
    return "[ " + "".join(f"{word}, " for word in words) + "]"


def as_yaml(frame):
    """One document, line by line as DumpYAML::write_header and write_data print it."""
    value = {name: lines[1][0] for name, lines in frame.items()}
    lines = ["---", "creator: LAMMPS", f"timestep: {value['TIMESTEP']}", f"units: {value['UNITS']}", f"time: {value['TIME']}",
             f"natoms: {value['NUMBER OF ATOMS']}", f"boundary: {flow(''.join(frame['BOX BOUNDS'][0]))}", "box:"]
    lines += [f"  - [ {low}, {high} ]" for low, high in frame["BOX BOUNDS"][1:]]
    lines += ["keywords: " + flow(frame["ATOMS"][0]).replace(", ]", ",  ]"), "data:"]
    lines += ["  - " + flow(row) for row in frame["ATOMS"][1:]]
    return "\n".join(lines + ["...", ""])


class YamlDump(running.Case):
    @classmethod
    def setUpClass(cls):
        cls.frames = list(frames(TEXT))
        cls.documents = [as_yaml(frame) for frame in cls.frames]

    def put(self, name, data):
        path = self.dir / name
        path.write_bytes(data.encode() if isinstance(data, str) else data)
        return path

    def bytes_of(self, command, dump, *options):
        out = self.dir / "table.csv"
        self.mdana(command, dump, "-o", out, *options)
        return out.read_bytes()

    def test_library_reads_the_numbers_of_the_text(self):
        self.assertEqual(len(self.frames), 47)
        for k in (0, 20, 46):
            frame, document = self.frames[k], yaml.load(self.documents[k], FASTEST)
            self.assertEqual(document["timestep"], int(frame["TIMESTEP"][1][0]))
            self.assertEqual(document["time"], float(frame["TIME"][1][0]))
            self.assertEqual(document["box"], [list(map(float, row)) for row in frame["BOX BOUNDS"][1:]])
            self.assertEqual(document["natoms"], len(document["data"]))
            self.assertEqual(document["keywords"], frame["ATOMS"][0])
            self.assertEqual([list(map(float, row)) for row in document["data"]],
                             [list(map(float, row)) for row in frame["ATOMS"][1:]])

    def test_same_tables_to_the_last_byte(self):
        whole = "".join(self.documents)
        text = self.put("dump.lammpstrj", TEXT)
        dumps = [self.put("dump.yaml", whole), self.put("dump.yaml.gz", gzip.compress(whole.encode(), 1)),
                 self.put("windows.yaml", whole.replace("\n", "\r\n"))]
        for command in ("force", "contact-radius"):
            wanted = self.bytes_of(command, text)
            self.assertEqual(wanted.count(b"\n"), 48)
            for dump in dumps:
                self.assertEqual(self.bytes_of(command, dump), wanted, dump.name)
        self.assertEqual(self.bytes_of("force", dumps[0], "--source", "positions"),
                         self.bytes_of("force", text, "--source", "positions"))

    def test_info_tells_the_same(self):
        text = self.document("info", self.put("dump.lammpstrj", TEXT))
        found = self.document("info", self.put("dump.yaml", "".join(self.documents)))
        self.assertEqual(found["format"], "lammps_yaml")
        for key in ("frames", "steps", "atoms", "columns", "box", "units", "bodies"):
            self.assertEqual(found[key], text[key], key)

    def test_a_file_a_step(self):
        for k, document in enumerate(self.documents):
            self.put(f"step.{k}.yaml", document)
        whole = self.put("dump.yaml", "".join(self.documents))
        self.assertEqual(self.bytes_of("force", self.dir / "step.*.yaml"), self.bytes_of("force", whole))

    def test_cut_within_a_frame(self):
        whole = "".join(self.documents)
        cut = self.put("cut.yaml", whole[:-len(self.documents[-1]) // 2])
        document = self.document("info", cut, code=3)
        self.assertEqual(document["frames"], 46)
        self.assertIn("the file ends within the atoms of frame 46", "".join(document["warnings"]))

    def test_bad_row_names_file_and_line(self):
        whole = "".join(self.documents).split("\n")
        line = next(k for k, text in enumerate(whole) if text == "data:") + 5
        whole[line] = whole[line].replace(", ]", "")
        self.refused("force", self.put("bad.yaml", "\n".join(whole)), says=[f"bad.yaml:{line + 1}: '- [ "])


if __name__ == "__main__":
    running.main()
