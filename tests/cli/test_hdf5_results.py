# SPDX-License-Identifier: GPL-3.0-or-later
"""Results in HDF5 by h5py and pandas, against the CSV and the JSON of the same command: equal to the last bit."""

import json
import re

import h5py
import numpy as np
import pandas

import running
from running import ROOT, SAMPLE, Case

COMMANDS = {
    "info": ("info", SAMPLE),
    "force": ("force", SAMPLE, "--compare"),
    "contact-radius": ("contact-radius", SAMPLE),
}


def without_seconds(document):
    return {name: value for name, value in document.items() if name != "seconds"}


class Results(Case):
    def write(self, command, ending):
        path = self.dir / f"{command}{ending}"
        self.mdana(*COMMANDS[command], "-o", path)
        return path

    def test_document(self):
        for command in COMMANDS:
            with h5py.File(self.write(command, ".h5")) as file:
                kept = json.loads(file["document"][()])
            told = json.loads(self.write(command, ".json").read_text(encoding="utf-8"))
            self.assertEqual(without_seconds(kept), without_seconds(told), command)

    def test_numbers(self):
        for command in COMMANDS:
            with h5py.File(self.write(command, ".h5")) as file:
                document = json.loads(file["document"][()])
                self.assertGreater(self.compare(file["results"], document), 1, command)

    def compare(self, group, json_object):
        """How many numbers of the document are in the group, with the same bits."""
        count = 0
        for name, value in json_object.items():
            if isinstance(value, dict) and name in group:
                count += self.compare(group[name], value)
            elif isinstance(value, (int, float)) and not isinstance(value, bool):
                self.assertEqual(group[name][()], value, name)
                count += 1
            elif value is None and "value" in json_object:
                self.assertTrue(np.isnan(group[name][()]), name)
        return count

    def test_table(self):
        for command in ("force", "contact-radius"):
            wanted = running.read_csv(self.write(command, ".csv"))
            with h5py.File(self.write(command, ".h5")) as file:
                self.assertEqual(list(file["table"]), list(wanted), command)
                for name, column in file["table"].items():
                    if column.dtype.kind == "S":
                        self.assertEqual([text.decode() for text in column], wanted[name], name)
                        continue
                    np.testing.assert_array_equal(column[:], [np.nan if v is None else v for v in wanted[name]], name)
                    self.assertEqual(len(column.attrs["dimension"]), 3)

    def test_dislocation_lines(self):
        """The segments are the table of --segments; the points of each add up to its length, the middle one among them."""
        self.mdana("defects", SAMPLE, "--no-surface", "-o", self.dir / "lines.h5", "--segments", self.dir / "segments.csv")
        wanted = running.read_csv(self.dir / "segments.csv")
        with h5py.File(self.dir / "lines.h5") as file:
            segments, points = file["lines/segments"], file["lines/points"]
            self.assertEqual(list(segments), list(wanted))
            self.assertEqual([text.decode() for text in segments["family"]], wanted["family"])
            self.assertEqual(points["x"].attrs["unit"], segments["length"].attrs["unit"])
            places = np.column_stack([points[axis] for axis in "xyz"])
            self.assertGreater(len(wanted["length"]), 4)
            for row, length in enumerate(wanted["length"]):
                line = places[points["segment"][:] == row]
                self.assertAlmostEqual(np.linalg.norm(np.diff(line, axis=0), axis=1).sum(), length, 9)
                np.testing.assert_array_equal(line[len(line) // 2], [wanted[axis][row] for axis in "xyz"])

    def test_units_of_columns(self):
        with h5py.File(self.write("force", ".h5")) as file:
            self.assertEqual(file["table/F"].attrs["unit"], "ε/σ")
            self.assertEqual(list(file["table/F"].attrs["dimension"]), [1, 1, -2])

    def test_lines_of_the_readme(self):
        blocks = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL)
        lines, = [block for block in blocks if "force.h5" in block]
        names = {}
        exec(lines.replace("force.h5", str(self.write("force", ".h5"))), names)
        told = json.loads(self.write("force", ".json").read_text(encoding="utf-8"))
        self.assertEqual(names["delta_max"], told["delta_max"]["value"])
        self.assertEqual(names["unit"], "ε/σ")
        wanted = pandas.read_csv(self.write("force", ".csv"), float_precision="round_trip")
        self.assertEqual(list(names["table"]), list(wanted))
        numbers = wanted.select_dtypes("number").columns
        np.testing.assert_array_equal(names["table"][numbers].to_numpy(float), wanted[numbers].to_numpy(float))

    def test_bytes_are_reproducible(self):
        """Two files with documents of one length differ only where the document and the results tell the seconds."""
        files = {}
        for _ in range(20):  # until the seconds of two have as many digits
            path = self.write("force", ".h5")
            data = np.frombuffer(path.read_bytes(), dtype=np.uint8).copy()
            with h5py.File(path) as file:
                width = file["document"].dtype.itemsize
                for name in ("document", "results/seconds"):
                    dataset = file[name]
                    start = dataset.id.get_offset()
                    data[start:start + dataset.id.get_storage_size()] = 0
            if width in files:
                np.testing.assert_array_equal(data, files[width])
                return
            files[width] = data
        self.fail("no two files have the same length of documents")

    def test_endings(self):
        self.assertIn(".csv or .h5", self.mdana("force", SAMPLE, "-o", "x.txt", code=2).stderr)
        self.assertIn(".json or .h5", self.mdana("info", SAMPLE, "-o", "x.csv", code=2).stderr)
        self.assertIn("(.h5)", self.mdana("force", "--help").stdout)


if __name__ == "__main__":
    running.main()
