#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What mdana accuracy recommends of one real run, kept by others of its kind: three orientations of a sphere, made by LAMMPS.

With MDANA_LONG_RUNS=DIR the runs are kept in DIR, and taken from there if they are there."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "oracles"))

import lammps
import running

class Recommended(running.Case):
    @classmethod
    def setUpClass(cls):
        folder = lammps.kept_runs(cls)
        cls.dumps = []
        for seed in (1, 2, 3):
            run = folder / f"hertz_r8_s{seed}"
            if not (run / "scene.toml").is_file():
                lammps.generate("hertz", "--radius", 8, "--velocity", "0.3", "--seed", seed, "--ranks", lammps.ranks(), "-o",
                                run, timeout=3600)
            cls.dumps.append(run / "dump.lammpstrj.gz")

    def test_settings_of_one_run_serve_the_others(self):
        for wanted in (0.1, 0.03):
            told = self.document("accuracy", self.dumps[0], "--only", "force", "--knob", "stride", "--judge", "F_max,delta_max",
                                 "--repeat", 1, "--error", wanted)["results"][0]["subjects"][0]["recommended"]
            self.assertTrue(told["met"])
            words = told["settings"]["stride"].split()
            stride = 1 if words[0] == "all" else int(words[2])
            for dump in self.dumps[1:]:
                all_frames, some = self.document("force", dump), self.document("force", dump, "--stride", stride)
                for name in ("F_max", "delta_max"):
                    away = abs(some[name]["value"] / all_frames[name]["value"] - 1)
                    print(f"wanted {wanted}, stride {stride}, {dump.parent.name}, {name}: {away:.2g}")
                    self.assertLessEqual(away, wanted, f"stride {stride}, {dump}, {name}")

    def test_a_command_that_chooses_keeps_its_word(self):
        for dump in self.dumps:
            all_frames, chosen = self.document("force", dump), self.document("force", dump, "--error", 0.1)
            self.assertTrue(chosen["accuracy"]["met"])
            for name in ("F_max", "delta_max"):
                self.assertLessEqual(abs(chosen[name]["value"] / all_frames[name]["value"] - 1), 0.1, name)


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
