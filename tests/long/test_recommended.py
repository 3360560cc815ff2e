#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What mdana accuracy recommends of one real run, kept by others of its kind, made by LAMMPS: three orientations of a sphere, three
aggregates.

With MDANA_LONG_RUNS=DIR the runs are kept in DIR, and taken from there if they are there."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "oracles"))

import lammps
import running

SPHERES = ("hertz", "--radius", 8, "--velocity", "0.3")
AGGREGATES = ("aggregate", "--preset", "small", "--velocity", 20, "--contacts-every", 5)


def at(document, path):
    """The number at a path, "parameters/E*"."""
    for key in path.split("/"):
        document = document[key]
    return document["value"] if isinstance(document, dict) else document


class OfAKind(running.Case):
    """Three runs that differ by their seed. `CHECKED`: command, its arguments, wanted errors, and the judged numbers with the
    places in its document of the number and of what errors are parts of."""

    @classmethod
    def make(cls, name, arguments):
        folder = lammps.kept_runs(cls)
        cls.dumps = []
        for seed in (1, 2, 3):
            run = folder / f"{name}_s{seed}"
            if not (run / "scene.toml").is_file():
                lammps.generate(*arguments, "--seed", seed, "--ranks", lammps.ranks(), "-o", run, timeout=3600)
            cls.dumps.append(run / "dump.lammpstrj.gz")
        cls.full = {}

    def all_frames(self, command, arguments, dump):
        if (command, dump) not in self.full:
            self.full[command, dump] = self.document(command, *arguments, dump)
        return self.full[command, dump]

    def away(self, found, full, place, size):
        return abs(at(found, place) - at(full, place)) / abs(at(full, size))

    def check_settings_of_one_run_serve_the_others(self):
        for command, arguments, wanted_errors, numbers in self.CHECKED:
            for wanted in wanted_errors:
                told = self.document("accuracy", self.dumps[0], "--only", command, "--knob", "stride", "--judge", ",".join(numbers),
                                     "--repeat", 1, "--error", wanted)["results"][0]["subjects"][0]["recommended"]
                self.assertTrue(told["met"], f"{command}, {wanted}: {told}")
                words = told["settings"]["stride"].split()
                stride = 1 if words[0] == "all" else int(words[2])
                for dump in self.dumps[1:]:
                    some = self.document(command, *arguments, dump, "--stride", stride)
                    for name, (place, size) in numbers.items():
                        away = self.away(some, self.all_frames(command, arguments, dump), place, size)
                        print(f"{command}, wanted {wanted}, stride {stride}, {dump.parent.name}, {name}: {away:.2g}")
                        self.assertLessEqual(away, wanted, f"{command}, stride {stride}, {dump}, {name}")

    def check_a_command_that_chooses_keeps_its_word(self):
        for command, arguments, wanted_errors, numbers in self.CHECKED:
            for dump in self.dumps:
                done = running.run(command, *arguments, dump, "--error", wanted_errors[0], "--json", timeout=300)
                chosen = running.parse_json(done.stdout)
                self.assertEqual(done.returncode, 0 if chosen["accuracy"]["met"] else 4)
                print(f"{command}, wanted {wanted_errors[0]}, {dump.parent.name}: {chosen['accuracy']['settings']}, "
                      f"error {chosen['accuracy']['error']:.2g} ({chosen['accuracy']['quantity']})")
                for name, (place, size) in numbers.items():
                    away = self.away(chosen, self.all_frames(command, arguments, dump), place, size)
                    self.assertLessEqual(away, max(wanted_errors[0], chosen["accuracy"]["error"]), f"{command}, {dump}, {name}")


class Spheres(OfAKind):
    CHECKED = [("force", (), (0.1, 0.03), {"F_max": ("F_max", "F_max"), "delta_max": ("delta_max", "delta_max")}),
               ("collision", (), (0.1, 0.03), {"F_max": ("F_max", "F_max"), "delta_max": ("delta_max", "delta_max")}),
               ("fit-force", ("--law", "hertz"), (0.1, 0.05), {"E*": ("parameters/E*", "parameters/E*"), "R": ("parameters/R", "parameters/R")})]

    @classmethod
    def setUpClass(cls):
        cls.make("hertz_r8", SPHERES)

    def test_settings_of_one_run_serve_the_others(self):
        self.check_settings_of_one_run_serve_the_others()

    def test_a_command_that_chooses_keeps_its_word(self):
        self.check_a_command_that_chooses_keeps_its_word()


class Aggregates(OfAKind):
    CHECKED = [("compress", (), (0.1, 0.03), {"delta_max": ("delta_max", "delta_max"), "t_max": ("t_max", "t_max")}),
               ("network", (), (0.1, 0.05), {name: (f"frame/at_delta_max/{name}", "frame/at_delta_max/contacts")
                                             for name in ("contacts", "contacts12", "made", "broken", "tension")})]

    @classmethod
    def setUpClass(cls):
        cls.make("aggregate_small_v20", AGGREGATES)

    def test_settings_of_one_run_serve_the_others(self):
        self.check_settings_of_one_run_serve_the_others()

    def test_a_command_that_chooses_keeps_its_word(self):
        self.check_a_command_that_chooses_keeps_its_word()


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
