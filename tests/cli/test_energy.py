# SPDX-License-Identifier: GPL-3.0-or-later
"""mdana energy on a bounce with loss in closed form: two cubes that do not turn or warm up; what they lose is in W."""

from dataclasses import replace

import numpy as np

import dumps
import running
from running import SAMPLE, Case

OFFSET = -7.0  # potential energy of an atom at rest


def kinetic(frame):
    """Of all atoms, of mass 1."""
    return 0.5 * np.sum(frame["vx vy vz"] ** 2)


def with_potential(frames, name="c_pe"):
    """W takes what K_p loses, in equal parts for all atoms."""
    start = kinetic(frames[0])
    return [replace(f, columns=f.columns + [name],
                    atoms=np.column_stack([f.atoms, np.full(16, OFFSET + (start - kinetic(f)) / 16)])) for f in frames]


def log(frames, per_atom=False, head="Step KinEng PotEng"):
    scale = 1 / 16 if per_atom else 1
    rows = [f"{f.step} {scale * kinetic(f):.14f} {scale * np.sum(f['c_pe']):.14f}" for f in frames]
    return "\n".join(["LAMMPS (29 Sep 2021)", "units lj", head, *rows, "Loop time of 1 on 1 procs for 1 steps", ""])


class Energy(Case):
    def setUp(self):
        super().setUp()
        bare, _, _, self.lost = dumps.spring_bounce()
        self.frames = with_potential(bare)
        self.start = kinetic(bare[0])
        self.bare = dumps.write(self.dir / "bare.dump", bare)
        self.dump = dumps.write(self.dir / "full.dump", self.frames)
        self.log = self.dir / "log.lammps"
        self.log.write_text(log(self.frames))

    def expect_bounce(self, document):
        close = {"delta_K_p": -self.lost, "delta_K_t": 0, "delta_W": self.lost, "energy_drift": 0}
        for name, wanted in close.items():
            self.assertEqual(set(document[name]), {"value", "error"})
            self.assertAlmostEqual(document[name]["value"], wanted, delta=1e-10, msg=name)
            self.assertLess(document[name]["error"], 1e-10)
        energy = document["energy"]
        for name, wanted in {"W_share": 1, "K_t_share": 0, "converted": 0.75, "one_minus_e2": 0.75, "restitution": 0.5,
                             "across": 0, "K_p_initial": self.start}.items():
            self.assertAlmostEqual(energy[name]["value"], wanted, delta=1e-8, msg=name)
        self.assertEqual(energy["frames_before"], [0, 10])

    def test_from_a_column(self):
        document = self.document("energy", self.dump)
        self.expect_bounce(document)
        self.assertEqual(document["energy"]["potential_source"], "column c_pe")
        self.assertIn("c_pe", document["columns_read"])
        other = dumps.write(self.dir / "other.dump", [replace(f, columns=f.columns[:-1] + ["v_mine"]) for f in self.frames])
        self.expect_bounce(self.document("energy", other, "--potential", "v_mine"))
        self.assertIn("v_mine", self.document("energy", other)["columns_not_read"])

    def test_from_a_log(self):
        self.expect_bounce(self.document("energy", self.bare, "--log", self.log))
        self.log.write_text(log(self.frames, per_atom=True))
        document = self.document("energy", self.bare, "--log", self.log)
        self.expect_bounce(document)
        self.assertTrue(document["energy"]["log_per_atom"])
        self.assertEqual([entry["format"] for entry in document["inputs"]], ["lammps_text", "lammps_log"])

    def test_log_that_was_cut(self):
        self.log.write_text(log(self.frames).split("Loop")[0])
        document = self.document("energy", self.bare, "--log", self.log, code=3)
        self.assertIn("within a run", "".join(document["warnings"]))
        self.expect_bounce(document)

    def test_without_potential_the_rest_is_there(self):
        document = self.document("energy", self.bare)
        self.assertAlmostEqual(document["delta_K_p"]["value"], -self.lost, delta=1e-12)
        self.assertNotIn("delta_W", document)
        self.assertIn("--log", {entry["what"]: entry["reason"] for entry in document["left_out"]}["W"])

    def test_two_columns_are_not_chosen_from(self):
        both = [replace(f, columns=f.columns + ["pe"], atoms=np.column_stack([f.atoms, f["c_pe"]])) for f in self.frames]
        dump = dumps.write(self.dir / "both.dump", both)
        self.assertIn("c_pe, pe", self.document("energy", dump)["left_out"][0]["reason"])
        self.expect_bounce(self.document("energy", dump, "--potential", "pe"))

    def test_table(self):
        table = self.table("energy", self.dump)
        self.assertEqual(list(table), "step time K_p1 K_p2 K_p_rel K_t1 K_t2 rotation1 rotation2 temperature1 temperature2 "
                                      "W1 W2 W_total total".split())
        self.assert_close([a + b for a, b in zip(table["K_p1"], table["K_p2"])], [kinetic(f) for f in self.frames], 1e-14,
                          self.start)
        self.assert_close(table["total"], [self.start + 16 * OFFSET] * len(self.frames), 1e-13, 16 * abs(OFFSET))
        self.assertEqual(max(table["K_t1"]), 0)

    def test_drift_is_told(self):
        """A tenth of the first K_p is missing in W from the middle on."""
        bad = [replace(f, atoms=f.atoms.copy()) for f in self.frames]
        for frame in bad[len(bad) // 2:]:
            frame.atoms[:, -1] -= 0.1 * self.start / 16
        document = self.document("energy", dumps.write(self.dir / "bad.dump", bad))
        self.assertAlmostEqual(document["energy_drift"]["value"], -0.1, delta=1e-8)
        self.assertGreaterEqual(document["delta_W"]["error"], 0.0999 * self.start)
        self.assertIn("total energy changes", "".join(document["warnings"]))

    def test_no_collision(self):
        document = self.document("energy", dumps.write(self.dir / "short.dump", self.frames[:15]))
        self.assertIn("no contact", {e["what"]: e["reason"] for e in document["left_out"]}["changes of energy"])
        self.assertNotIn("delta_K_p", document)

    def test_refused(self):
        self.refused("energy", self.dump, "--potential", "c_pe", "--log", self.log, code=2, says=("--potential", "--log"))
        self.refused("energy", self.dump, "--potential", "c_no", says=("full.dump", "c_no", "--potential"))
        self.refused("energy", self.dump, "--potential", "type", says=("type", "no real numbers"))
        self.refused("energy", self.dump, "--log", self.dir / "none", says=(self.dir / "none",))
        self.refused("energy", self.dump, "--log", self.dump, says=("not a log of LAMMPS",))
        self.log.write_text(log(self.frames, head="Step KinEng Press"))
        self.refused("energy", self.dump, "--log", self.log, says=("log.lammps", "PotEng"))
        self.log.write_text(log(self.frames).replace("units lj", "units metal"))
        self.refused("energy", self.dump, "--log", self.log, says=("metal", "lj"))
        still = dumps.write(self.dir / "still.dump", [f.without("vx", "vy", "vz") for f in self.frames])
        self.refused("energy", still, says=("still.dump", "vx", "velocities"))

    def test_potential_that_is_not_finite(self):
        self.frames[30].atoms[3, -1] = np.nan
        dump = dumps.write(self.dir / "nan.dump", self.frames)
        self.assertIn("is not finite", "".join(self.document("energy", dump, code=3)["warnings"]))

    def test_threads_change_nothing(self):
        documents = [self.document("energy", SAMPLE, "--threads", k) for k in (1, 2)]
        for document in documents:
            del document["seconds"]
        self.assertEqual(*documents)


if __name__ == "__main__":
    running.main()
