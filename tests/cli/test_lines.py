# SPDX-License-Identifier: GPL-3.0-or-later
"""mdana defects: dislocation lines in the document, the table of segments, VTP and .ca files, and in time."""

import math
import pathlib
import sys

import numpy as np

from running import SAMPLE, Case, read_csv

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "dislocations"))
import found  # noqa: E402

FAMILIES = ["perfect", "shockley", "stair_rod", "hirth", "frank", "other"]
EDGE = 1.55


def sheared(place):
    """A ball with one Shockley partial through it, at that place in its glide plane."""
    n = np.arange(-9, 10)
    cells = np.array(np.meshgrid(n, n, n, indexing="ij")).reshape(3, -1).T
    atoms = EDGE * np.concatenate([cells + b for b in ([0, 0, 0], [0.5, 0.5, 0], [0.5, 0, 0.5], [0, 0.5, 0.5])])
    atoms = atoms[np.linalg.norm(atoms, axis=1) < 12]
    normal, across = np.array([1, 1, 1]) / math.sqrt(3), np.array([1, 1, -2]) / math.sqrt(6)
    slip = 0.5 + np.arctan(atoms @ across - place) / math.pi
    side = np.where(atoms @ normal > EDGE / math.sqrt(12), 0.5, -0.5)
    return atoms + np.outer(side * slip, EDGE / 6 * np.array([1, 1, -2]))


class Lines(Case):
    def dump(self, places):
        path = self.dir / "made.dump"
        text = "ITEM: UNITS\nlj\n"
        for step, place in enumerate(places):
            atoms = sheared(place)
            text += f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(atoms)}\nITEM: BOX BOUNDS ff ff ff\n" + "-30 30\n" * 3
            text += "ITEM: ATOMS id type x y z\n" + "".join(f"{k + 1} 1 {x!r} {y!r} {z!r}\n" for k, (x, y, z) in enumerate(atoms.tolist()))
        path.write_text(text)
        return path

    def test_document(self):
        document = self.document("defects", self.dump([0]), "--no-surface")
        frame = document["frames"][0]
        self.assertEqual(list(frame["lines"]), FAMILIES)
        self.assertAlmostEqual(sum(frame["lines"][f]["length"]["value"] for f in FAMILIES), frame["total_length"]["value"], 9)
        self.assertEqual(frame["burgers_residual"], 0)
        self.assertEqual(frame["lines"]["shockley"]["segments"], 1)
        (segment,) = frame["segments"]
        self.assertAlmostEqual(segment["length"]["value"], 23, delta=1.5)
        self.assertEqual(segment["ends"], ["surface", "surface"])
        self.assertLess(abs(segment["character_degrees"] - 90), 3 * segment["character_spread_degrees"] + 1)
        np.testing.assert_allclose(sorted(np.abs(segment["burgers"])), np.array([1, 1, 2]) / 6, atol=1e-12)
        text = self.mdana("defects", self.dump([0]), "--no-surface").stdout
        self.assertRegex(text, r"most lines +2\d\.\d.*: shockley 2\d")

    def test_errors_in_the_table(self):
        """Those of the document; what is unresolved is between nothing and twice itself."""
        frame = self.document("defects", SAMPLE, "--no-surface", "--frames", "last")["frames"][0]
        table = self.table("defects", SAMPLE, "--no-surface", "--frames", "last")
        for name, told in [(f"{f}_length", frame["lines"][f]["length"]) for f in FAMILIES] + [
                ("line_length", frame["total_length"]), ("unresolved_length", frame["unresolved_length"])]:
            self.assertEqual(table[name], [told["value"]], name)
            self.assertEqual(table[f"{name}_error"], [told["error"]], name)
            self.assertTrue(0 <= told["error"] <= told["value"], name)
        self.assertGreater(frame["unresolved_length"]["error"], 0)

    def test_left_out(self):
        document = self.document("defects", SAMPLE, "--frames", ":1", "--no-lines")
        self.assertIn("lines", [entry["what"] for entry in document["left_out"]])
        self.assertNotIn("lines", document["frames"][0])
        self.mdana("defects", SAMPLE, "--no-lines", "--ca", self.dir / "x", code=2)

    def test_files(self):
        """VTK reads the length, the .ca file holds the Burgers vector in space, the table the same segment."""
        frame = self.document("defects", self.dump([0]), "--no-surface", "--vtp", self.dir / "p", "--ca", self.dir / "p",
                              "--segments", self.dir / "s.csv")["frames"][0]
        length = frame["total_length"]["value"]
        ((b, points),) = found.read_ca(self.dir / "p.0.ca")
        self.assertAlmostEqual(np.linalg.norm(np.diff(points, axis=0), axis=1).sum() / length, 1, 6)
        # The line runs along [1-10]; what is above (111) moved along [11-2] on one side.
        np.testing.assert_allclose(np.abs(b), EDGE / 6 * np.array([1, 1, 2]), atol=0.06 * EDGE)
        table = read_csv(self.dir / "s.csv")
        self.assertEqual(table["family"], ["shockley"])
        self.assertAlmostEqual(table["length"][0], length, 9)
        try:
            import vtk
        except ImportError:
            self.skipTest("no vtk (Debian: apt install python3-vtk9)")
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(self.dir / "p.lines.0.vtp"))
        reader.Update()
        data = reader.GetOutput()
        self.assertEqual(data.GetNumberOfLines(), 1)
        drawn = np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
        self.assertAlmostEqual(np.linalg.norm(np.diff(drawn, axis=0), axis=1).sum() / length, 1, 5)
        self.assertAlmostEqual(data.GetCellData().GetArray("length").GetValue(0), length, 5)

    def test_in_time(self):
        """A line that moves on by 2 sweeps its length times 2: the shear of the ball."""
        document = self.document("defects", self.dump([-3, -1, 1, 3]), "--no-surface")
        history = document["line_history"]
        self.assertEqual(history["tracks_seen"], 1)
        self.assertEqual(history["stored"], 1)
        (system,) = history["slip_systems"]
        self.assertEqual(system["reversed"], 0)
        volume = len(sheared(0)) * EDGE**3 / 4
        swept = 6 * np.mean([f["total_length"]["value"] for f in document["frames"]])
        shear = EDGE / math.sqrt(6) * swept / volume
        self.assertAlmostEqual(system["shear"] / shear, 1, delta=0.1)  # half a neighbour of 6
        # The line moves to where nothing had slipped: along +[11-2] there was slip already, so it takes slip back.
        normal = np.array([1, 1, 1]) / math.sqrt(3)
        moved = np.array(history["distortion"][0]) @ normal
        np.testing.assert_allclose(moved, -shear * np.array([1, 1, -2]) / math.sqrt(6), atol=0.1 * shear)


if __name__ == "__main__":
    import running

    running.main()
