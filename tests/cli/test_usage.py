# SPDX-License-Identifier: GPL-3.0-or-later
"""Help, usage errors and the exit codes of commands that end by themselves."""

import re
import shlex

import running
from running import ROOT, SAMPLE, Case

RUN = ["--scene", "--units", "--masses", "--bodies", "--radius", "--timestep", "--json", "--output", "-o", "--help"]
SWEEP = ["--stride"]
OPTIONS = {
    "info": RUN,
    "check": ["--limit", "--threads", "--memory", "--json", "--output", "-o", "--help"],
    "plan": RUN + SWEEP + ["--for", "--report", "--only", "--modulus", "--log", "--tasks", "--of"],
    "force": RUN + SWEEP + ["--source"],
    "contact-radius": RUN + SWEEP + ["--layer", "--spacing", "--neighbour-cutoff", "--modulus", "--surface-energy"],
    "collision": RUN + SWEEP + ["--layer", "--spacing", "--modulus", "--potential", "--log"],
    "compress": RUN + SWEEP + ["--split", "--offset"],
    "energy": RUN + SWEEP + ["--potential", "--log"],
    "network": RUN + SWEEP + ["--grain-radius", "--grain-modulus", "--poisson-ratio", "--surface-energy", "--contacts"],
    "defects": RUN + SWEEP + ["--dump", "--csp", "--coordination", "--label", "--spacing", "--neighbours"],
    "convert": [o for o in RUN if o != "--radius"] + SWEEP + ["--format", "--columns", "--add", "--sort", "--omit"],
    "predict": ["--law", "--parameter", "-p", "--trajectory", "--sensitivities", "--sticking-velocity", "--peak",
                "--tolerance", "--time-limit", "--json", "--output", "-o", "--help"],
    "law": ["--law", "--parameter", "-p", "--delta", "--profile", "--delta-max", "--json", "--output", "-o", "--help"],
    "study": ["--print", "--force", "--output", "-o", "--help"],
    "report": ["--jobs", "--only", "--dry-run", "--threads", "--memory", "--json", "--output", "-o", "--help"],
    "run": ["--task", "--of", "--jobs", "--threads", "--memory", "--json", "--output", "-o", "--help"],
    "merge": ["--of", "--partial", "--jobs", "--threads", "--memory", "--json", "--output", "-o", "--help"],
    "emit": ["--for", "--parameter", "-p", "--every", "--file", "--no-potential", "--scene", "--bodies", "--output", "-o", "--help"],
    "plot": ["--list", "--units", "--title", "--output", "-o", "--help"],
    "accuracy": RUN + SWEEP + ["--error", "--only", "--knob", "--judge", "--repeat", "--law", "--layer", "--potential"],
    "stability": RUN + SWEEP,
    "fit-hertz": RUN + SWEEP + ["--method", "--min-force-fraction", "--max-force-fraction", "--phase", "--loss",
                                "--weights"],
    "fit-force": RUN + SWEEP + ["--law", "--free", "--parameter", "--part", "--min-delta-fraction", "--loss"],
}

WITHOUT_INPUT = ("law", "predict", "stability", "aggregate", "selfcheck")  # their examples need no dump


def examples(text):
    return [line.strip() for line in text.split("examples:\n", 1)[1].splitlines() if line.strip()]


class Help(Case):
    def commands(self):
        text = self.mdana("--help").stdout
        listed = text.split("commands:\n", 1)[1].split("\n\n", 1)[0]
        return [line.split()[0] for line in listed.splitlines()]

    def test_overview_lists_the_commands_and_exit_codes(self):
        done = self.mdana("--help")
        self.assertEqual(done.stderr, "")
        self.assertLessEqual(set(OPTIONS), set(self.commands()))
        for code in ("0", "1", "2", "3", "4", "75", "130"):
            self.assertRegex(done.stdout, rf"\b{code} [a-z]")
        for spelling in ("-h", "help"):
            self.assertEqual(self.mdana(spelling).stdout, done.stdout)

    def test_version(self):
        self.assertRegex(self.mdana("--version").stdout, r"\Amdana \d+\.\d+\.\d+\S*\n\Z")

    def test_every_command_has_usage_examples_and_options(self):
        for command in self.commands():
            with self.subTest(command):
                done = self.mdana(command, "--help")
                self.assertEqual(done.stderr, "")
                self.assertTrue(done.stdout.startswith(f"usage: mdana {command} "))
                self.assertEqual(self.mdana(command, "-h").stdout, done.stdout)
                lines = examples(done.stdout)
                self.assertTrue(lines)
                for line in lines:
                    self.assertTrue(line.startswith(f"mdana {command} "), line)
                for option in OPTIONS.get(command, ["--help"]):
                    self.assertRegex(done.stdout, rf"(?m)^  .*{re.escape(option)}\b")

    def test_examples_are_right(self):
        """Those with the sample data or without any run; those with dumps that are not there fail for just that."""
        (self.dir / "sample-data").symlink_to(ROOT / "sample-data")  # a root of the repository that may be written to
        with_sample = set()
        for command in self.commands():
            for line in examples(self.mdana(command, "--help").stdout):
                with self.subTest(line):
                    there = "sample-data" in line or "--list" in line or command in WITHOUT_INPUT or "accuracy --law" in line
                    done = self.mdana(*shlex.split(line)[1:], cwd=self.dir, code=0 if there else 1)
                    if there:
                        with_sample.add(command)
                    else:
                        self.assertRegex(done.stderr, "[Nn]o such|not there|missing")
        self.assertLessEqual(set(OPTIONS), with_sample)


class Usage(Case):
    def test_refusals_come_with_a_hint(self):
        for command, arguments in [
            ("", []),
            ("", ["forse", SAMPLE]),
            ("force", ["force"]),
            ("info", ["info", "--json"]),
            ("force", ["force", "--no-such-option", SAMPLE]),
            ("force", ["force", SAMPLE, SAMPLE]),
            ("force", ["force", SAMPLE, "--units"]),
            ("force", ["force", SAMPLE, "--units", "lj", "--units", "lj"]),
            ("force", ["force", SAMPLE, "--stride", "0"]),
            ("force", ["force", SAMPLE, "--stride", "-3"]),
            ("force", ["force", SAMPLE, "--stride", "1.5"]),
            ("force", ["force", SAMPLE, "--memory", "0"]),
            ("force", ["force", SAMPLE, "--timestep", "0"]),
            ("force", ["force", SAMPLE, "--timestep", "-0.1"]),
            ("force", ["force", SAMPLE, "--timestep", "inf"]),
            ("force", ["force", SAMPLE, "--timestep", "fast"]),
            ("force", ["force", SAMPLE, "--source", "magic"]),
            ("force", ["force", SAMPLE, "-o", "table.txt"]),
            ("force", ["force", SAMPLE, "-o", "table"]),
            ("contact-radius", ["contact-radius", SAMPLE, "--layer", "0"]),
            ("contact-radius", ["contact-radius", SAMPLE, "--layer", "nan"]),
            ("contact-radius", ["contact-radius", SAMPLE, "--layer", "inf"]),
            ("report", ["report", SAMPLE.parent]),
            ("report", ["report", SAMPLE.parent, "-o", "out", "--jobs", "-1"]),
            ("run", ["run", SAMPLE.parent, "-o", "out", "--task", "1"]),
            ("run", ["run", SAMPLE.parent, "-o", "out", "--task", "3", "--of", "2"]),
            ("run", ["run", SAMPLE.parent, "-o", "out", "--task", "0", "--of", "2"]),
            ("merge", ["merge", SAMPLE.parent, "-o", "out", "--of", "0"]),
            ("plan", ["plan", SAMPLE, "--tasks"]),
            ("emit", ["emit", SAMPLE, "--for", "lammps-inline", "--every", "0"]),
            ("emit", ["emit", SAMPLE, "--for", "lammps-inline", "--file", "a b"]),
            ("emit", ["emit", SAMPLE, "--for", "lammps-inline", "--file", "$(shell)"]),
            ("study", ["study", "init"]),
            ("study", ["study", "list", SAMPLE.parent]),
            ("study", ["study", "init", SAMPLE.parent, "-o", "elsewhere.toml"]),
            ("fit-hertz", ["fit-hertz", SAMPLE, "--method", "other"]),
            ("fit-hertz", ["fit-hertz", SAMPLE, "--phase", "unloading"]),
            ("fit-hertz", ["fit-hertz", SAMPLE, "--loss", "l1"]),
            ("fit-hertz", ["fit-hertz", SAMPLE, "--min-force-fraction", "-0.1"]),
            ("fit-hertz", ["fit-hertz", SAMPLE, "--min-force-fraction", "0.6", "--max-force-fraction", "0.5"]),
            ("fit-hertz", ["fit-hertz", SAMPLE, "--min-force-fraction", "nan"]),
        ]:
            with self.subTest(arguments[1:] or arguments):
                done = self.mdana(*arguments, code=2, cwd=self.dir)
                self.assertEqual(done.stdout, "")
                self.assertEqual(done.stderr.splitlines()[-1], f"Try: mdana {command + ' ' if command else ''}--help")
                self.assertRegex(done.stderr, r"\Amdana: \S")
                self.assertEqual(list(self.dir.iterdir()), [])

    def test_usage_is_checked_before_the_input_is_read(self):
        for arguments in (["--source", "magic"], ["-o", "x.txt"], ["--stride", "0"]):
            self.mdana("force", "/no/such/dump", *arguments, code=2)
        self.mdana("info", "/no/such/dump", "-o", "x.csv", code=2)  # info has no table

    def test_wrong_syntax_of_run_options(self):
        """1 or 2: it is the command line that is wrong, but the exit code of these was 1 from the start."""
        for option, text in [
            ("--masses", "1"), ("--masses", "1=abc"), ("--masses", "1=-1,2=1"), ("--masses", "one=1,2=1"),
            ("--masses", "1=1;2=1"), ("--masses", "1=0,2=1"), ("--masses", "1=inf,2=1"),
            ("--masses", "1=1,1=2,2=1"),
            ("--radius", "five"), ("--radius", "-5"), ("--radius", "0"), ("--radius", "5,"), ("--radius", "5,4,3"),
            ("--radius", "nan"), ("--radius", "inf"),
            ("--bodies", "colour"), ("--bodies", "id:"), ("--bodies", "id:5"), ("--bodies", "id:9-3"),
            ("--bodies", "id:a-b"), ("--units", "imperial"), ("--units", "LJ"),
        ]:
            with self.subTest(f"{option} {text}"):
                self.refused_option("force", option, text)
        for option, text in [("--units", "imperial"), ("--bodies", "colour"), ("--masses", "1")]:
            with self.subTest(f"info {option} {text}"):
                self.refused_option("info", option, text)

    def refused_option(self, command, option, text):
        done = running.run(command, SAMPLE, option, text)
        self.assertIn(done.returncode, (1, 2), done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertIn(option[2:].replace("masses", "mass"), done.stderr, "the message says which option is wrong")


class ExitCodes(Case):
    """The codes that a shell script may rely on; 75 and 130 are in test_signals.py."""

    def test_table(self):
        text = (running.ROOT / "tests" / "cli" / "dumps.py").read_text(encoding="utf-8")
        (self.dir / "not.dump").write_text(text, encoding="utf-8")
        import dumps

        whole = dumps.read_text(SAMPLE)
        (self.dir / "cut.dump").write_text(whole[:len(whole) // 2], encoding="utf-8")
        for code, arguments in [
            (0, ["force", SAMPLE]),
            (1, ["force", self.dir / "not.dump"]),
            (2, ["force"]),
            (3, ["force", self.dir / "cut.dump"]),
        ]:
            with self.subTest(code):
                self.mdana(*arguments, code=code)

    def test_unwritable_output(self):
        missing = self.dir / "missing" / "out.csv"
        self.assertIn("No such file", self.mdana("force", SAMPLE, "-o", missing, code=1).stderr)
        (self.dir / "taken.csv").mkdir()
        done = self.mdana("force", SAMPLE, "-o", self.dir / "taken.csv", code=1)
        self.assertIn("taken.csv", done.stderr)
        self.assertEqual([p.name for p in self.dir.iterdir()], ["taken.csv"], "no temporary file is left")
        for arguments in (["force", SAMPLE], ["force", SAMPLE, "--json"], ["--help"], ["force", "--help"],
                          ["--version"]):
            with self.subTest(f"full disk: {arguments}"), open("/dev/full", "w", encoding="utf-8") as full:
                done = self.mdana(*arguments, code=1, stdout=full)
                self.assertRegex(done.stderr, r"mdana: .*output")

    def test_an_older_result_survives_a_failure(self):
        out = self.dir / "out.csv"
        out.write_text("older", encoding="utf-8")
        self.mdana("force", self.dir / "missing", "-o", out, code=1)
        self.assertEqual(out.read_text(encoding="utf-8"), "older")
        self.mdana("force", SAMPLE, "-o", out)
        self.assertNotEqual(out.read_text(encoding="utf-8"), "older")
        self.assertEqual([p.name for p in self.dir.iterdir()], ["out.csv"])


if __name__ == "__main__":
    running.main()
