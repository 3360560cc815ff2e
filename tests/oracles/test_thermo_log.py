# SPDX-License-Identifier: GPL-3.0-or-later
"""Logs of one run of LAMMPS in the styles one, custom, multi and yaml: `mdana info` finds the same runs, steps and columns.
Debian's LAMMPS lacks thermo_style yaml; a few lines here write it from the log in the style custom."""

import re
import subprocess
import tempfile
from pathlib import Path

import lammps
import running

try:
    import yaml
except ImportError:
    running.skip("no yaml module (Debian: apt install python3-yaml)")

# 20 steps, 15 more with another time step, which begin with the last row again, and 7 in runs of three.
INPUT = """
variable     twice equal 2*step
units        lj
lattice      fcc 0.8
region       cell block 0 3 0 3 0 3
create_box   1 cell
create_atoms 1 box
mass         1 1
pair_style   lj/cut 2.5
pair_coeff   * * 1 1
velocity     all create 1 123
fix          move all nve
timestep     0.002
thermo       10
thermo_style {0}
run          20
timestep     0.001
print        "Step by step"
run          15
run          7 every 3 'print "twice $(v_twice)"'
"""
STYLES = {"one": "one", "custom": "custom step temp c_thermo_press[1] pe v_twice", "multi": "multi"}
STEPS = [[0, 20], [20, 35], [35, 38], [38, 41], [41, 42]]
ROWS = [3, 3, 2, 3, 2]


def in_yaml(text):
    """The tables of a log as Thermo::header, compute and footer print them for thermo_style yaml."""
    lines, rows = [], False
    for line in text.splitlines():
        words = line.split()
        if words[:2] == ["Step", "Temp"]:
            lines += ["---", "keywords: [" + "".join(f"'{word}', " for word in words) + "]", "data:"]
            rows = True
        elif line.startswith("Loop time"):
            lines += ["...", line]
            rows = False
        else:
            lines.append("  - [" + "".join(f"{word}, " for word in words) + "]" if rows else line)
    return "\n".join(lines + [""])


class ThermoLog(running.Case):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="mdana-test-")
        cls.addClassCleanup(scratch.cleanup)
        cls.runs = Path(scratch.name)
        for name, style in STYLES.items():
            (cls.runs / f"in.{name}").write_text(INPUT.format(style))
            done = subprocess.run(["lmp", "-in", f"in.{name}", "-log", f"log.{name}", "-screen", "none"], cwd=cls.runs,
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120, check=False)
            if done.returncode:
                raise AssertionError(done.stdout + done.stderr)
        (cls.runs / "log.yaml").write_text(in_yaml((cls.runs / "log.custom").read_text()))

    def test_runs_are_the_same_in_all_styles(self):
        for name in (*STYLES, "yaml"):
            document = self.document("info", self.runs / f"log.{name}")
            self.assertEqual(document["format"], "lammps_log")
            self.assertEqual(document["units"], "lj")
            sections = document["sections"]
            self.assertEqual([section["steps"] for section in sections], STEPS, name)
            self.assertEqual([section["rows"] for section in sections], ROWS, name)
            self.assertEqual([section["timestep"] for section in sections], [0.002] + 4 * [0.001], name)
            self.assertTrue(all(section["finished"] for section in sections), name)
            self.assertEqual(document["joined"], {"rows": 9, "steps": [0, 42]}, name)
            self.assertEqual(document["left_out"] if "left_out" in document else [], [], name)

    def test_columns(self):
        columns = {name: self.document("info", self.runs / f"log.{name}")["sections"][0]["columns"]
                   for name in (*STYLES, "yaml")}
        self.assertEqual(columns["one"], "Step Temp E_pair E_mol TotEng Press".split())
        self.assertEqual(columns["custom"], "Step Temp c_thermo_press[1] PotEng v_twice".split())
        self.assertEqual(columns["yaml"], columns["custom"])
        self.assertEqual(columns["multi"], "Step CPU TotEng KinEng Temp PotEng E_bond E_angle E_dihed E_impro E_vdwl E_coul "
                                           "E_long Press".split())

    def test_written_yaml_is_yaml(self):
        documents = re.findall(r"^---\n(.*?)^\.\.\.\n", (self.runs / "log.yaml").read_text(), re.M | re.S)
        self.assertEqual([len(yaml.safe_load(text)["data"]) for text in documents], ROWS)

    def test_last_values(self):
        """Equal where the same digits are printed; multi prints four decimals, which are within half of the last one."""
        values = {name: self.document("info", self.runs / f"log.{name}")["sections"] for name in (*STYLES, "yaml")}

        def last(name, column):
            return [section["last"][section["columns"].index(column)] for section in values[name]]

        self.assertEqual(last("custom", "v_twice"), [2 * steps[1] for steps in STEPS])
        for column in ("Temp", "PotEng"):
            self.assertEqual(last("yaml", column), last("custom", column))
            self.assert_close(last("multi", column), last("custom", column), 0.5e-4 * 1.01, 1, column)
        self.assert_close(last("one", "Temp"), last("custom", "Temp"), 0, 1)
        self.assert_close(last("one", "E_pair"), last("custom", "PotEng"), 0, 1)
        self.assert_close(last("multi", "Press"), last("one", "Press"), 0.5e-4 * 1.01, 1)

    def test_log_of_a_run_that_goes_on(self):
        text = (self.runs / "log.custom").read_text()
        cut = self.dir / "log.lammps"
        cut.write_text(text[:text.rindex("\n      42") + 20])
        document = self.document("info", cut, code=3)
        self.assertEqual(document["sections"][-1]["steps"], [41, 41])
        self.assertFalse(document["sections"][-1]["finished"])
        self.assertIn("the log ends within a run", "".join(document["warnings"]))

    def test_terminal(self):
        text = self.mdana("info", self.runs / "log.one").stdout
        self.assertRegex(text, r"units +lj\n")
        self.assertRegex(text, r"run 2 +3 rows, steps 20 to 35, time step 0.001\n")

    def test_wrong_row_names_file_and_line(self):
        lines = (self.runs / "log.one").read_text().splitlines()
        line = next(k for k, text in enumerate(lines) if text.split()[:1] == ["10"])
        lines[line] += " 1"
        bad = self.dir / "log.bad"
        bad.write_text("\n".join(lines) + "\n")
        self.refused("info", bad, says=[f"log.bad:{line + 1}: 7 values"])


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
