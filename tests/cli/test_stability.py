# SPDX-License-Identifier: GPL-3.0-or-later
"""mdana stability: of laws, fits and made-up dumps; of a dump as many digits stay as it prints."""

import math
import re

import dumps
import running
from running import SAMPLE, Case


def with_digits(frames, digits):
    """The same text, with so many significant digits in each real number."""
    text = "".join(f.text() for f in frames)
    return re.sub(r"-?\d+\.\d+(e[+-]?\d+)?", lambda m: f"{float(m[0]):.{digits}g}", text)


class Catalogues(Case):
    def test_nothing_is_lost(self):
        for what, least in (("laws", 200), ("fits", 45), ("dumps", 50)):
            with self.subTest(what):
                found = self.document("stability", what)
                self.assertGreaterEqual(found["cases"], least)
                self.assertEqual(found["lost"], 0, [c for c in found["results"] if not c["kept"]])

    def test_refusals_say_why(self):
        refused = [c for c in self.document("stability", "dumps")["results"] if c["verdict"] == "refused"]
        self.assertGreaterEqual(len(refused), 10)
        for case in refused:
            self.assertGreater(len(case["told"]), 10)

    def test_table(self):
        rows = self.table("stability", "fits")
        self.assertEqual(len(rows["case"]), self.document("stability", "fits")["cases"])
        self.assertGreater(max(rows["condition"]), 1e6)


class OfADump(Case):
    def digits(self, printed):
        frames = dumps.spring_bounce()[0]
        path = self.dir / f"{printed}.dump"
        path.write_text(with_digits(frames, printed))
        found = self.document("stability", path, "--bodies", "type", "--radius", "5")
        return {r["quantity"]: r for r in found["results"]}, found

    def test_as_many_as_are_printed(self):
        """Distances of 10 and speeds of 0.25 of bodies of 8 atoms: each printed digit more keeps one more."""
        few, _ = self.digits(6)
        many, _ = self.digits(9)
        for name in ("F_max", "delta_max", "hysteresis_area"):
            gained = many[name]["digits"] - few[name]["digits"]
            self.assertAlmostEqual(gained, 3, delta=1, msg=name)  # the moves are drawn anew: a factor of ten at most
            self.assertFalse(many[name]["weak"], name)

    def test_weak_numbers_are_flagged(self):
        rows, found = self.digits(3)
        weak = [r for r in rows.values() if r["weak"]]
        self.assertTrue(weak)
        self.assertEqual(found["weak"], len(weak))
        for row in weak:
            self.assertLess(row["digits"], 3)
            self.assertIn("weak", row["verdict"].lower())

    def test_change_is_told_in_units_of_the_value(self):
        for row in self.digits(6)[0].values():
            if row["change"] > 0 and row["value"] != 0:
                wanted = min(15, max(0, -math.log10(row["change"] / abs(row["value"]))))
                self.assertAlmostEqual(row["digits"], wanted, places=6)

    def test_of_the_samples(self):
        hertz = self.document("stability", SAMPLE.parent.parent / "hertz-tiny/dump.lammpstrj.gz")
        self.assertGreater(hertz["condition"]["hertz"], 1)
        self.assertIn("E_star", [r["quantity"] for r in hertz["results"]])
        grains = self.document("stability", SAMPLE.parent.parent / "aggregate-tiny/dump.lammpstrj.gz")
        self.assertIn("delta_max", [r["quantity"] for r in grains["results"]])

    def test_what_is_not_there(self):
        self.refused("stability", self.dir / "none.dump", says=["none.dump"])


if __name__ == "__main__":
    running.main()
