# SPDX-License-Identifier: GPL-3.0-or-later
"""A report's pictures of particles: snapshots at start, maximum compression and end, and the 3-D view of lattice defects."""

import base64
import html
import json
import re
import shutil

import numpy as np

import dumps
import running
from running import main
from studies import NAMES, Study
from test_lines import FAMILIES, sheared

LABELS = ["start", "maximum compression", "end"]


def unescaped(text):
    return html.unescape(re.sub("<[^>]*>", "", text))


def told_number(value):
    return f"{value:.4g}".replace("-", "\u2212", 1) if value < 0 else f"{value:.4g}"


def slice_of(frame, thickness):
    """Places of both bodies' atoms in the slice: across the line of centres, along it, above the plane."""
    one, two = dumps.centres(frame)
    along = (two - one) / np.linalg.norm(two - one)
    normal = np.array([0, 0, 1]) - along[2] * along
    normal /= np.linalg.norm(normal)
    across = np.cross(along, normal)
    places = []
    for body in (1, 2):
        r = frame.body(body)["x y z"] - (one + two) / 2
        height = r @ normal
        inside = (-thickness < 2 * height) & (2 * height <= thickness)
        places.append(np.column_stack([r @ across, r @ along, height])[inside])
    return places


def nearest_neighbour(frame):
    """Of each of some atoms the distance to the nearest other one; the middle of these."""
    r = frame["x y z"]
    return np.median([np.partition(np.linalg.norm(r - a, axis=1), 1)[1] for a in r[::7]])


def numbers(packed):
    """As page.md says of AT."""
    return np.array(packed["origin"] * (len(base64.b64decode(packed["int16"])) // 6)) + packed["step"] * np.frombuffer(
        base64.b64decode(packed["int16"]), "<i2")


class Pictures(Study):
    def pictures(self, *kinds, **settings):
        """A report with these kinds of figures only."""
        file = self.study(**settings)
        text = re.sub(r'(?m)^kinds = .*', f"kinds = {json.dumps(kinds)}", file.read_text(encoding="utf-8"))
        file.write_text(text, encoding="utf-8")
        self.report()
        self.page = (self.out / "index.html").read_text(encoding="utf-8")

    def section(self, name):
        return re.search(f'<section class="run" data-run="{name}">(.*?)</section>', self.page, re.DOTALL)[1]

    def figure(self, name, says):
        """Picture and caption of the one figure of a run with that in its caption."""
        [(picture, text)] = [(base64.b64decode(picture).decode(), unescaped(text)) for picture, text in re.findall(
            r'<figure[^>]*>\s*<img [^>]*base64,([^"]*)">\s*<figcaption>(.*?)</figcaption>', self.section(name), re.DOTALL) if says in text]
        return picture, text

    def test_snapshots(self):
        self.pictures("snapshots")
        runs = {run["name"]: run for run in self.results()["runs"]}
        for name in NAMES:
            with self.subTest(name):
                place = self.out / "runs" / name
                frames = running.read_csv(place / ("approach.csv" if name.startswith("aggregate") else "frames.csv"))
                most = int(np.argmax(frames["delta"]))
                told = runs[name]["snapshots"]
                self.assertEqual([s["shows"] for s in told], LABELS)
                self.assertEqual([s["step"] for s in told], [frames["step"][k] for k in (0, most, -1)])
                self.assertEqual([s["delta"] for s in told], [frames["delta"][k] for k in (0, most, -1)])
                picture, text = self.figure(name, "Slice through both centres")
                for letter, s in zip("abc", told):
                    self.assertIn(f"({letter}) {s['shows']}: step {s['step']}, t = {told_number(s['time'])} ", text)
                    self.assertIn(f"δ = {told_number(s['delta'])} ", text)
                    self.assertIn(f"({letter}) {s['shows']}</text>", picture)
                self.assertEqual(picture.count("h0"), sum(s["atoms"] for s in told))
                self.assertLess(len(picture), 20_000)
                for ending in ("csv", "gp", "svg") + (("pdf",) if shutil.which("gnuplot") else ()):
                    self.assertTrue((place / f"snapshots.{ending}").is_file(), ending)

    def test_a_slice_is_that_of_the_dump(self):
        self.pictures("snapshots")
        frames = {frame.step: frame for frame in dumps.read(self.runs / "hertz-tiny" / "dump.lammpstrj.gz")}
        table = running.read_csv(self.out / "runs" / "hertz-tiny" / "snapshots.csv")
        columns = {name: np.array(column) for name, column in table.items()}
        thickness = columns["diameter"][0]
        first = frames[columns["step"][0]]
        self.assertAlmostEqual(thickness, nearest_neighbour(first), delta=0.01 * thickness)
        for k, label in enumerate(LABELS):
            shown = columns["snapshot"] == label
            wanted = slice_of(frames[columns["step"][shown][0]], thickness)
            for body in (1, 2):
                mine = shown & (columns["body"] == body)
                found = np.column_stack([columns[axis][mine] for axis in "xyz"])
                self.assertEqual(len(found), len(wanted[body - 1]))
                for axis in range(3):
                    np.testing.assert_allclose(np.sort(found[:, axis]), np.sort(wanted[body - 1][:, axis]), atol=1e-4)

    def test_no_snapshots_unless_they_are_asked_for(self):
        self.pictures("force")
        self.assertNotIn("Slice through both centres", self.page)
        self.assertFalse((self.out / "runs" / "hertz-tiny" / "snapshots.svg").exists())
        self.assertIn("to run: changed: settings", self.plan_after("force", "snapshots")["hertz-tiny"])

    def plan_after(self, *kinds):
        file = self.runs / "study.toml"
        file.write_text(re.sub(r'(?m)^kinds = .*', f"kinds = {json.dumps(kinds)}", file.read_text(encoding="utf-8")), encoding="utf-8")
        return self.plan()

    def made_run(self):
        """Two balls of fcc that meet and part; from the third frame on one has a Shockley partial through it."""
        place = self.runs / "sheared"
        place.mkdir()
        whole, frames = sheared(1e6), []
        for step in range(11):
            distance = 22 + 0.08 * (step - 5) ** 2
            bodies = [sheared(0) if step >= 3 else whole, whole + [distance, 0, 0]]
            rows = [(k + 1, body + 1, *r) for body, atoms in enumerate(bodies) for k, r in enumerate(atoms.tolist())]
            rows = np.array([(k + 1, *row[1:]) for k, row in enumerate(rows)])
            frames.append(dumps.Frame(step, None, "id type x y z".split(), rows))
        dumps.write(place / "dump.lammpstrj.gz", frames)
        (place / "scene.toml").write_text('schema = 1\nname = "sheared"\ndump = "dump.lammpstrj.gz"\nunits = "lj"\ntimestep = 1.0\n'
                                          'interaction = "adhesive"\nbodies = "type"\n[masses]\n1 = 1.0\n2 = 1.0\n')

    def test_view_of_defects(self):
        self.made_run()
        self.pictures("force", defects=True)
        [run] = [run for run in self.results()["runs"] if run["name"] == "sheared"]
        table = running.read_csv(self.out / "runs" / "sheared" / "defects.csv")
        shown = run["defects"]["shown_frames"]
        self.assertEqual([f["shows"] for f in shown], ["start of defects", "maximum compression", "end"])
        self.assertEqual([f["step"] for f in shown], [3, 5, 10])
        for frame in shown:
            row = table["step"].index(frame["step"])
            self.assertEqual(frame["hcp"], table["hcp"][row])
            self.assertEqual(frame["lines"]["shockley"]["segments"], 1)
            self.assertAlmostEqual(frame["lines"]["shockley"]["length"]["value"], 23, delta=1.5)
            self.assertEqual(list(frame["lines"]), FAMILIES)
        still, text = self.figure("sheared", "dislocation lines")
        for says in ("start of defects, δ", "maximum compression, δ", "end, δ"):
            self.assertIn(says, text)
        for says in ("hcp atoms", "Shockley partials", "intrinsic faults"):
            self.assertIn(says, still)
        cells = [[unescaped(c).strip() for c in re.findall("<td.*?</td>", row, re.DOTALL)]
                 for row in re.findall("<tr>.*?</tr>", self.section("sheared"), re.DOTALL)]
        [row] = [row for row in cells if row and row[0] == "start of defects"]
        self.assertEqual(row[8], f"{shown[0]['lines']['shockley']['length']['value']:.4g} (1)")

        block = re.search(r'<script type="application/json" id="scene-runs/sheared/defects">(.*?)</script>', self.page, re.DOTALL)
        if not block:
            self.skipTest("pages of this build are static")
        frames = json.loads(block[1])["frames"]
        self.assertEqual(len(frames), 3)
        for frame, of in zip(frames, shown):
            row = table["step"].index(of["step"])
            counts = {atoms["name"]: len(numbers(atoms["at"])) // 3 for atoms in frame["atoms"]}
            self.assertEqual(counts.get("hcp atoms", 0), table["hcp"][row])
            self.assertEqual(counts.get("bulk defects", 0), table["bulk_defect"][row])
            lines = [line for line in frame["lines"] if not line["guide"]]
            self.assertEqual([line["name"] for line in lines], ["Shockley partials"])
            self.assertEqual(len(frame["lines"]), 5)  # two circles a body

    def test_no_defects_are_told_in_words(self):
        self.pictures("force", defects=True)
        self.assertIn("No lattice defects", unescaped(self.section("hertz-tiny")))
        self.assertNotIn('data-scene="runs/hertz-tiny', self.page)
        for name in ("aggregate-tiny", "hertz-tiny"):
            self.assertNotIn("all lines", self.section(name))
        self.assertNotIn("attice defects", unescaped(self.section("aggregate-tiny")))


if __name__ == "__main__":
    main()
