# SPDX-License-Identifier: GPL-3.0-or-later
"""What a report writes: rows, documents, HDF5, figures, provenance, fits over runs; `verify` and `plot`."""

import json
import math
import os
import re
import shutil
import time
import unittest

import dumps
import running
from running import ROOT, Case, main, parse_json
from studies import NAMES, SAMPLE, Study, h5py, without_times


class Outputs(Study):
    def test_one_row_a_run(self):
        self.study()
        self.report()
        rows = {row["run"]: row for row in self.rows()}
        self.assertEqual(set(rows), set(NAMES))
        documents = {run["name"]: run for run in self.results()["runs"]}
        for name, row in rows.items():
            self.assertEqual(row["group"], documents[name]["group"])
            self.assertEqual(float(row["delta_max"]), documents[name]["delta_max"]["value"])
            self.assertEqual(float(row["delta_max_error"]), documents[name]["delta_max"]["error"])
        self.assertEqual(rows["adhesive-tiny"]["seed"], "4")
        self.assertEqual(float(rows["adhesive-tiny"]["velocity"]), 0.1)
        self.assertEqual(float(rows["adhesive-tiny"]["orientation_w1"]), -0.3858665539514308)
        self.assertEqual(float(rows["hertz-tiny"]["E_star"]), documents["hertz-tiny"]["E_star"]["value"])
        self.assertEqual(rows["adhesive-tiny"]["E_star"], "")

    def test_numbers_are_those_of_the_single_commands(self):
        self.study()
        self.report()
        documents = {run["name"]: run for run in self.results()["runs"]}
        compress = self.document("compress", SAMPLE / "aggregate-tiny" / "dump.lammpstrj.gz")
        self.assertEqual(documents["aggregate-tiny"]["delta_max"], compress["delta_max"])
        hertz = self.document("fit-hertz", SAMPLE / "hertz-tiny" / "dump.lammpstrj.gz")
        self.assertEqual(documents["hertz-tiny"]["E_star"], hertz["E_star"])
        radius = documents["hertz-tiny"]["R"]["value"]
        single = self.document("collision", SAMPLE / "adhesive-tiny" / "dump.lammpstrj.gz", "--radius", repr(radius))
        for name in ("F_max", "hysteresis_area", "far_side", "outcome"):
            self.assertEqual(documents["adhesive-tiny"][name], single[name], name)

    def test_weak_numbers_are_flagged_wherever_they_stand(self):
        """The dump of hertz-tiny has five digits, and its least force is a hundredth of the greatest."""
        self.study(accuracy=True, stability=True)
        self.report()
        rows = {row["run"]: row for row in self.rows()}
        for run in self.results()["runs"]:
            weak = [r["quantity"] for r in run["stability"] if r["digits"] < 3]
            self.assertEqual(rows[run["name"]]["weak"].split(), weak)
            for check in run["stability"]:
                number = run
                for part in check["quantity"].split("."):
                    number = number[part]
                self.assertEqual(number["stable_digits"], check["digits"], check["quantity"])
                self.assertEqual(number["weak"], check["quantity"] in weak)
        self.assertEqual(rows["hertz-tiny"]["weak"], "F_min_loading")
        self.assertGreater(len(self.results()["runs"][1]["accuracy"]), 0, "of the aggregates")

    def test_any_number_of_jobs_and_threads(self):
        self.study()
        self.report("--jobs", 1, "--threads", 1)
        one = self.files(self.out)
        other = self.dir / "other"
        self.report("--jobs", 3, "--threads", 4, "--memory", 1, out=other)
        self.assertEqual(self.files(other), one)

    def test_provenance(self):
        self.study()
        self.report()
        provenance = self.results()["provenance"]
        self.assertEqual(provenance["command_line"][1], "report")
        self.assertRegex(provenance["program"], r"\A\d+\.\d+\.\d+ xxh3:[0-9a-f]{32}\Z")
        self.assertEqual(provenance["machine"]["cores"], os.cpu_count())
        for library in ("Eigen", "Ceres", "HDF5"):
            self.assertRegex(provenance["libraries"][library], r"\A\d+\.\d+")
        self.assertEqual(provenance["seeds"]["last_digits"], [1, 2, 3, 4])

    def test_figures_and_what_is_left_out(self):
        self.study(defects=True, figures=True)
        self.report()
        results = self.results()
        kinds = {line.split()[0] for line in self.mdana("plot", "--list").stdout.splitlines() if not line.startswith((" ", "P1: "))}
        drawn = {figure["name"] for figure in results["figures"]}
        left_out = {entry["what"].split()[1] for entry in results["left_out"] if entry["what"].startswith("figure ")}
        for kind in kinds:
            there = any(name == kind or name.startswith(kind + "-") for name in drawn | {"snapshots"})
            self.assertTrue(there or kind in left_out, f"{kind} is neither drawn nor left out")
        for kind in ("force", "contact-radius", "non-fcc", "hertz-fit", "compression", "modulus-yield", "grain-force"):
            self.assertTrue(any(name.startswith(kind + "-") for name in drawn), kind)
        self.assertNotIn("snapshots", left_out)  # each run has its own
        self.assertTrue((self.out / "runs" / "hertz-tiny" / "snapshots.csv").is_file())
        self.assertEqual(running.read_csv(self.out / "figures" / "delta-max-size-nano.csv")["point"], ["aggregate-tiny"])
        for name in drawn:
            for ending in ("csv", "gp") + (("svg", "pdf") if shutil.which("gnuplot") else ()):
                self.assertTrue((self.out / "figures" / f"{name}.{ending}").is_file(), f"{name}.{ending}")

    def test_a_figure_shows_the_numbers_of_its_runs(self):
        self.study()
        self.report()
        shown = running.read_csv(self.out / "figures" / "phase-plane-hertz_R_5.csv")
        frames = running.read_csv(self.out / "runs" / "hertz-tiny" / "frames.csv")
        pairs = set(zip(frames["delta"], frames["v"]))
        self.assertGreater(len(shown["delta"]), 10)
        self.assertLessEqual(set(zip(shown["delta"], shown["v"])), pairs)

    def test_the_page_links_figures_with_their_runs(self):
        self.study()
        self.report()
        text = (self.out / "index.html").read_text(encoding="utf-8")
        self.assertEqual(tuple(re.findall('<section class="run" data-run="([^"]*)"', text)), NAMES)
        blocks = {name: json.loads(block) for name, block in
                  re.findall('<script type="application/json" id="([^"]*)">(.*?)</script>', text, re.DOTALL)}
        if not blocks:
            self.skipTest("pages of this build are static")
        self.assertEqual(tuple(blocks["page-data"]["runs"]), NAMES)
        for name in ("adhesive-tiny", "hertz-tiny"):
            of = {series["label"]: series.get("run") for series in blocks[f"figure-runs/{name}/force"]["series"]}
            law = "JKR" if name.startswith("adhesive") else "Hertz"
            self.assertEqual(of, {"loading": name, "unloading": name, law: None})
        pooled = [figure for name, figure in blocks.items() if name.startswith(("figure-force-", "figure-phase-plane-"))]
        of = [(series["label"].split()[0], series.get("run")) for figure in pooled for series in figure["series"]]
        for name in ("adhesive-tiny", "hertz-tiny"):
            self.assertEqual(of.count((name, name)), 2)
        self.assertEqual({label for label, run in of if run is None}, {"JKR", "Hertz"})

    def test_hdf5(self):
        """By the lines that README.md shows."""
        if not h5py:
            self.skipTest("no h5py")
        self.study()
        self.report()
        [lines] = [block for block in re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL)
                   if "results.h5" in block]
        names = {}
        exec(lines.replace("report/results.h5", str(self.out / "results.h5")), names)  # what a reader types
        rows = self.rows()
        self.assertEqual([name.decode() for name in names["runs"]["run"]], [row["run"] for row in rows])
        self.assertEqual(list(names["runs"]["delta_max"]), [float(row["delta_max"]) for row in rows])
        table = running.read_csv(self.out / "runs" / "hertz-tiny" / "frames.csv")
        self.assertEqual(list(names["frames"]["F"]), table["F"])
        self.assertEqual(names["modulus"], {r["name"]: r for r in self.results()["runs"]}["hertz-tiny"]["E_star"]["value"])
        with h5py.File(self.out / "results.h5") as file:
            self.assertEqual(without_times(json.loads(file["document"][()])), without_times(self.results()))

    def test_verify(self):
        self.study()
        self.report()
        self.assertIn("as the report was made", self.mdana("verify", self.out).stdout)
        for file, says in [(self.runs / "hertz-tiny" / "dump.lammpstrj.gz", "input hertz-tiny/dump.lammpstrj.gz has other bytes"),
                           (self.runs / "study.toml", "input study.toml has other bytes"),
                           (self.out / "results.csv", "output results.csv has other bytes")]:
            with self.subTest(says):
                data = file.read_bytes()
                file.write_bytes(data[:-1] + bytes([data[-1] ^ 1]))
                told = self.mdana("verify", self.out, code=1).stdout
                self.assertIn(says, told)
                self.assertIn("1 changed", told)
                file.write_bytes(data)
        (self.out / "index.html").unlink()
        self.assertIn("index.html is no longer there", self.mdana("verify", self.out, code=1).stdout)
        self.assertIn("No such file", self.mdana("verify", self.dir, code=1).stderr)
        for text in ("", "{", "[]", '{"study": 1}', '{"study": {"directory": ""}, "inputs": [1], "outputs": 2}'):
            (self.out / "manifest.json").write_text(text, encoding="utf-8")
            self.assertIn("not the manifest", self.mdana("verify", self.out, code=1).stderr)
            (self.out / "cache" / "hashes.json").write_text(text, encoding="utf-8")
            self.report()
            self.mdana("verify", self.out)

    def test_laws_of_a_group(self):
        """Two collisions of one group are fitted; of one alone it is said that it is not enough."""
        shutil.copytree(SAMPLE / "adhesive-tiny", self.runs / "second")
        self.edit("second", 'name = "adhesive-tiny"', 'name = "second"')
        self.study()
        self.report()
        results = self.results()
        told = results["laws"] + [e for e in results["left_out"] if e["what"].startswith("law jkr")]
        self.assertTrue(any("adhesive" in json.dumps(entry) for entry in told))
        self.assertTrue(any("hertz" in entry["what"] and "at least two" in entry["reason"]
                            for entry in results["left_out"] if entry["what"].startswith("law jkr")))


class Together(Case):
    """What runs say together, of motions in closed form."""

    def add_run(self, name, frames, interaction, radius, velocity, more=""):
        place = self.dir / "runs" / name
        place.mkdir(parents=True)
        dumps.write(place / "run.dump", frames)
        body = f"[[body]]\nradius = {radius!r}\n"
        (place / "scene.toml").write_text(
            f'schema = 1\nname = "{name}"\ndump = "run.dump"\nunits = "lj"\ninteraction = "{interaction}"\nsigma = 1.0\n'
            f'bodies = "type"\n{body}{body}{more}[generator]\nvelocity = {velocity!r}\n', encoding="utf-8")
        return place / "run.dump"

    def results(self, toml=()):
        runs, out = self.dir / "runs", self.dir / "report"
        text = self.mdana("study", "init", runs, "--print").stdout.replace("defects = true", "defects = false")
        text = text.replace("accuracy = true", "accuracy = false").replace("stability = true", "stability = false")
        for old, new in toml:
            self.assertIn(old, text)
            text = text.replace(old, new)
        (runs / "study.toml").write_text(text, encoding="utf-8")
        self.mdana("report", runs / "study.toml", "-o", out)
        return parse_json((out / "results.json").read_text(encoding="utf-8"))

    def drawn(self, figure, column):
        """Points by series."""
        table = running.read_csv(self.dir / "report" / "figures" / f"{figure}.csv")
        x = list(table)[1]
        series = {}
        for label, *point in zip(table["series"], table[x], table[column]):
            series.setdefault(label, []).append(tuple(point))
        return series

    def test_hertz_runs_of_one_size(self):
        for k in range(3):
            self.add_run(f"hertz{k}", dumps.hertz_bounce(modulus=60, radius=5, frames=41 + 4 * k), "hertz", 5.0, 0.1)
        [size] = self.results()["sizes"]["sizes"]
        self.assertEqual((size["N"], size["runs"]), (8, 3))
        self.assertAlmostEqual(size["E_star"]["value"], 60, delta=60e-9)
        self.assertAlmostEqual(size["R"]["value"], 5, delta=5e-9)

    def test_restitution_over_velocities(self):
        """A spring that is h times as hard on the way back gives e = 1/sqrt(h); RMS of two runs of one velocity."""
        for name, speed, harder in (("a", 0.25, 4.0), ("b", 0.25, 9.0), ("c", 0.5, 4.0)):
            self.add_run(name, dumps.spring_bounce(speed=speed, harder=harder)[0], "adhesive", 5.0, speed)
        self.results()
        table = running.read_csv(self.dir / "report" / "tables" / "velocities.csv")
        self.assertEqual(table["velocity"], [0.25, 0.5])
        self.assertEqual(table["runs"], [2, 1])
        self.assertEqual(table["stick"], [0, 0])
        self.assertEqual(table["sticking"], [0, 0])
        self.assertAlmostEqual(table["e_rms"][0], ((1 / 4 + 1 / 9) / 2)**0.5, delta=1e-9)
        self.assertAlmostEqual(table["e_rms"][1], 0.5, delta=1e-9)
        figure = running.read_csv(self.dir / "report" / "figures" / "restitution.csv")
        self.assertEqual(figure["e_rms"], table["e_rms"])

    def test_a_law_is_fitted_to_the_group(self):
        """e of JKR's energy loss at three velocities: gamma, which the scenes do not state, comes out; E* is that of the
        Hertz run of the same radius."""
        gamma, modulus, radius, mass = 0.4, 60.0, 5.0, 4.0
        self.add_run("hertz", dumps.hertz_bounce(modulus=modulus, radius=radius), "hertz", radius, 0.1)
        reduced = radius / 2
        a0 = (9 * math.pi * gamma * reduced**2 / modulus)**(1 / 3)
        loss = 0.7722405 * 3 * math.pi * gamma * reduced * a0**2 / (3 * reduced)  # per contact, Johnson et al. 1971
        for k, speed in enumerate((1.5, 2.0, 3.0)):
            e = (1 - 2 * loss / (mass * speed**2))**0.5
            self.add_run(f"adhesive{k}", dumps.spring_bounce(speed=speed, harder=1 / e**2)[0], "adhesive", radius, speed)
        fits = [fit for fit in self.results()["laws"] if fit["group"].startswith("adhesive")]
        self.assertEqual(len(fits), 1, fits)
        self.assertTrue(fits[0]["usable"], fits[0]["reason"])
        self.assertAlmostEqual(fits[0]["parameters"]["gamma"]["value"], gamma, delta=1e-4 * gamma)
        drawn = self.drawn("restitution", "e_rms")["jkr, adhesive, gamma not known, R = 5"]
        for v, e in drawn:
            self.assertAlmostEqual(e, max(0, 1 - 2 * loss / (mass * v**2))**0.5, delta=2e-4 / max(e, 0.05))

    def test_aggregates_are_those_of_mdana_compress(self):
        """The same documents to the last bit, although the report has them from its cache; Andrews' constants come back."""
        modulus, strength, density, radius, dumped = 1.0, 0.2, 7e-4, 20.0, []
        for velocity in (0.3, 0.8, 1.2, 2.0):
            reduced = radius / 2
            mass = 16 * math.pi / 3 * density * reduced**3
            path = dumps.andrews_path(modulus, strength, reduced, mass, velocity, 0.02, 8, 600)
            dumped.append(self.add_run(f"v{velocity}", dumps.rigid_aggregates(path, 0.02, radius, 10, mass * 2), "aggregate",
                                       radius, velocity, "[aggregate]\nfilling_factor = 0.5\n"))
        [together] = self.results()["aggregates"]
        alone = self.document("compress", *dumped)
        self.assertTrue(together["usable"], together.get("left_out"))
        for name in ("E_star", "Y", "elastic_limit", "rigid_plastic_limit", "offset", "with_counted_mass"):
            self.assertEqual(together[name], alone[name], name)
        self.assertAlmostEqual(together["E_star"]["value"], modulus, delta=1e-3)
        self.assertAlmostEqual(together["Y"]["value"], strength, delta=1e-3)
        fillings = running.read_csv(self.dir / "report" / "tables" / "fillings.csv")
        self.assertEqual((fillings["phi"], fillings["Y"]), ([0.5], [together["Y"]["value"]]))
        measured = self.drawn("delta-max-velocity", "delta_max_over_R_eff")
        law = measured.pop("Andrews")
        self.assertEqual(set(measured) & {"elastic limit", "rigid plastic limit"}, {"elastic limit", "rigid plastic limit"})
        for v, delta in measured["aggregate, phi = 0.5, R = 20"]:
            (v0, d0), (v1, d1) = [(a, b) for a, b in zip(law, law[1:]) if a[0] <= v <= b[0]][0]
            self.assertAlmostEqual(d0 + (d1 - d0) * (v - v0) / (v1 - v0), delta, delta=1e-3)
        motion = self.drawn("approach-speed-aggregate_phi_0_5_R_20", "v_rel")
        [(_, one)] = [entry for entry in motion.items() if entry[0].startswith("v0.3 ")]
        model = motion["Andrews"]
        self.assertAlmostEqual(min(model)[1], 0.3, delta=1e-3)
        compared = 0
        for t, speed in one:  # that of the first collision, of which the law was made
            near = [(a, b) for a, b in zip(model, model[1:]) if a[0] <= t <= b[0]]
            if near:
                (t0, s0), (t1, s1) = near[0]
                self.assertAlmostEqual(s0 + (s1 - s0) * (t - t0) / (t1 - t0 or 1), speed, delta=3e-3)
                compared += 1
        self.assertGreater(compared, 100)


@unittest.skipUnless(shutil.which("gnuplot"), "no gnuplot")
class Plot(Case):
    DUMP = SAMPLE / "hertz-tiny" / "dump.lammpstrj.gz"

    def test_a_figure_of_a_table(self):
        table = self.dir / "force.csv"
        self.mdana("force", self.DUMP, "-o", table)
        for ending, start in (("svg", b"<?xml"), ("pdf", b"%PDF")):
            figure = self.dir / f"figure.{ending}"
            self.mdana("plot", "force", table, "-o", figure, "--units", "lj")
            first = figure.read_bytes()
            self.assertTrue(first.startswith(start))
            figure.unlink()
            time.sleep(1.1)  # a PDF would tell the second that it was made in
            self.mdana("plot", "force", table, "-o", figure, "--units", "lj")
            self.assertEqual(figure.read_bytes(), first)
        shown = running.read_csv(self.dir / "figure.csv")
        self.assertEqual(set(shown), {"series", "delta", "F"})

    def test_many_curves(self):
        """gnuplot has nothing to complain about, and the key names some of them."""
        tables = [self.dir / f"a-run-with-rather-a-long-name-{k:03}.csv" for k in range(200)]
        for k, table in enumerate(tables):
            table.write_text(f"delta,F\n0,0\n1,{k + 1}\n2,{k + 3}\n", encoding="utf-8")
        for count in (5, 12, 60, 200):
            with self.subTest(count):
                done = self.mdana("plot", "force", *tables[:count], "-o", self.dir / "many.svg")
                self.assertEqual(done.stderr, "")
                script = (self.dir / "many.gp").read_text(encoding="utf-8")
                named = min(count, 12)
                self.assertEqual(script.count(" title 'a-run"), 2 * named)  # SVG and PDF
                self.assertEqual(f"12 of {count} curves, all in many.csv" in script, count > named)
                picture = (self.dir / "many.svg").read_text(encoding="utf-8")
                self.assertEqual(len(set(re.findall("a-run-with-rather-a-long-name-[0-9]+", picture))), named)

    def test_refusals(self):
        table = self.dir / "t.csv"
        table.write_text("a,b\n1,2\n", encoding="utf-8")
        self.assertIn("delta", self.mdana("plot", "force", table, "-o", self.dir / "x.svg", code=1).stderr)
        for arguments in (["plot"], ["plot", "force"], ["plot", "no-such", table, "-o", self.dir / "x.svg"],
                          ["plot", "force", table], ["plot", "force", table, "-o", self.dir / "x.png"],
                          ["plot", "snapshots", table, "-o", self.dir / "x.svg"]):
            with self.subTest(arguments):
                self.mdana(*arguments, code=2)


if __name__ == "__main__":
    main()
