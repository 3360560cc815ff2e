# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdana report`: one self-contained page, the same numbers as the single commands, broken runs told."""

import html.parser
import re
import shutil

from running import SAMPLE as DUMP
from running import Case, main, parse_json, without_digits

SAMPLE = DUMP.parent


class Page(html.parser.HTMLParser):
    """Headings, pictures, and whatever the page would load from elsewhere."""

    def __init__(self, text):
        super().__init__()
        self.headings, self.pictures, self.loads, self.blocks, self.scripts = [], [], [], [], 0
        self.inside = None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.inside = tag
        if tag == "script" and attributes.get("type") == "application/json":
            self.blocks.append(attributes["id"])
        elif tag == "script":
            self.scripts += 1
        if tag == "img":
            self.pictures.append(attributes)
        for name in ("src", "href", "srcset", "poster"):
            target = attributes.get(name, "")
            if target and not target.startswith(("data:", "#")):
                self.loads.append(target)

    def handle_data(self, data):
        if self.inside in ("h1", "h2", "h3") and data.strip():
            self.headings.append(data.strip())
        self.inside = None


class Report(Case):
    def setUp(self):
        super().setUp()
        self.out = self.dir / "report"

    def report(self, directory=SAMPLE, code=0):
        return self.mdana("report", directory, "-o", self.out, code=code)

    def results(self):
        return parse_json((self.out / "results.json").read_text())["runs"]

    def copy_of_sample(self, name):
        place = self.dir / "runs" / name
        shutil.copytree(SAMPLE, place)
        return place

    def test_page_stands_alone_and_has_its_sections(self):
        self.report()
        text = (self.out / "index.html").read_text()
        page = Page(text)
        self.assertEqual(page.loads, [])
        self.assertLessEqual(page.scripts, 1)  # none in a build without npm
        self.assertNotIn("unsafe", re.search("Content-Security-Policy.*", text)[0])
        self.assertEqual(len(page.blocks), len(set(page.blocks)))
        self.assertEqual(bool(page.scripts), "page-data" in page.blocks)
        self.assertNotIn("url(", re.sub("<script>.*?</script>", "", text, flags=re.DOTALL))
        for section in ("Error against run time", "Numerical stability", "What was left out and why"):
            self.assertIn(section, page.headings)
        self.assertIn("coefficient of restitution", text)  # a sticking run has none
        self.assertIn("Hertz fit", text)  # left out of an adhesive scene
        self.assertGreaterEqual(len(page.pictures), 3)  # force, contact radius, accuracy
        for picture in page.pictures:
            self.assertTrue(picture.get("alt"))
            self.assertTrue(picture["src"].startswith("data:image/svg+xml;base64,"))

    def test_numbers_are_those_of_the_single_commands(self):
        self.report()
        entry = self.results()[0]
        force = self.document("force", DUMP)
        contact = self.document("contact-radius", DUMP)
        for name in ("outcome", "F_max", "F_min_loading", "delta_max", "hysteresis_area"):
            self.assertEqual(without_digits(entry[name]), force[name], name)
        self.assertEqual(without_digits(entry["contact_radius"]), contact["contact_radius"])
        for name in ("size", "hash", "format"):
            self.assertEqual(entry["inputs"][0][name], force["inputs"][0][name])
        self.assertEqual(entry["inputs"][0]["path"], DUMP.name)  # from the directory of the study

    def test_stability_bounds_what_the_printed_digits_can_do(self):
        """delta_max is a difference of means of 603 positions printed with 8 digits (unit 1e-7 or
        1e-8 of a coordinate of order 1 to 10): it cannot move by more than a unit."""
        self.report()
        entry = self.results()[0]
        rows = {row["quantity"]: row for row in entry["stability"]}
        self.assertGreater(rows["delta_max"]["change"], 0)
        self.assertLess(rows["delta_max"]["change"], 2e-7)

    def test_a_broken_run_does_not_stop_the_others(self):
        self.copy_of_sample("whole")
        broken = self.copy_of_sample("broken")
        (broken / "dump.lammpstrj.gz").unlink()
        scene = broken / "scene.toml"
        scene.write_text(re.sub(r'name = "adhesive-tiny"', 'name = "<b>broken</b>"', scene.read_text()))
        done = self.report(broken.parent, code=1)
        self.assertIn("dump.lammpstrj.gz", done.stderr)
        text = (self.out / "index.html").read_text()
        self.assertNotIn("<b>broken", text)
        self.assertIn("&lt;b&gt;broken", text)
        self.assertEqual(sorted("failure" in entry for entry in self.results()), [False, True])

    def test_only_a_report_is_replaced(self):
        self.out.mkdir()
        (self.out / "thesis.tex").write_text("precious")
        self.report(code=1)
        self.assertEqual([p.name for p in self.dir.iterdir()], ["report"])
        self.assertEqual([p.name for p in self.out.iterdir()], ["thesis.tex"])

        (self.out / "thesis.tex").unlink()
        for _ in range(2):  # into the empty directory, then over the first report
            self.report()
        self.assertEqual([p.name for p in self.dir.iterdir()], ["report"])

    def test_a_directory_without_runs_is_told(self):
        done = self.report(self.dir, code=1)
        self.assertIn("scene.toml", done.stderr)
        self.assertFalse(self.out.exists())


if __name__ == "__main__":
    main()
