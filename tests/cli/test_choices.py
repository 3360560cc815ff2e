#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of a dump: frames, atoms, and what damage does with and without --strict."""

import gzip
import os
import re

import running
from running import SAMPLE

SCENE = ("--scene", SAMPLE.parent / "scene.toml")
LAST_COLUMNS = "type x y z vx vy vz\n"


def with_more_atoms(frame):
    """A frame of the sample with five atoms of type 3 before its own."""
    head, atoms = frame.split(LAST_COLUMNS)
    count = int(head.split("NUMBER OF ATOMS\n")[1].split("\n")[0])
    more = "".join(f"{count + k} 3 {k}.5 0 0 0 0 0\n" for k in range(1, 6))
    return head.replace(f"ATOMS\n{count}\n", f"ATOMS\n{count + 5}\n") + LAST_COLUMNS + more + atoms


class Choices(running.Case):
    def test_frames_are_a_slice(self):
        whole = self.table("force", SAMPLE)
        for choice, part in ((":20", slice(20)), ("5:", slice(5, None)), ("3:41:2", slice(3, 41, 2))):
            chosen = self.table("force", SAMPLE, "--frames", choice)
            for name in ("step", "X", "x1", "vx2"):
                self.assertEqual(chosen[name], whole[name][part], choice)
        self.assertEqual(self.table("force", SAMPLE, "--stride", 4),
                         self.table("force", SAMPLE, "--frames", "::4"))

    def test_what_is_no_choice(self):
        for options in (("--frames", "5"), ("--frames", "9:3"), ("--frames", "::2", "--stride", "2"),
                        ("--select", "x:1-2"), ("--select", "id:3-1")):
            self.refused("force", SAMPLE, *options, code=2, says=[options[0].strip("-")[:6]])
        self.refused("force", SAMPLE, "--frames", "1000:", says=["none chosen"])

    def test_atoms_that_are_not_selected_are_not_there(self):
        text = gzip.decompress(SAMPLE.read_bytes()).decode()
        first, *frames = text.split("ITEM: UNITS\n")[-1].split("ITEM: TIMESTEP\n")
        dump = self.dir / "more.lammpstrj"
        dump.write_text("ITEM: UNITS\n" + first +
                        "".join("ITEM: TIMESTEP\n" + with_more_atoms(frame) for frame in frames))
        plain = self.document("force", SAMPLE)
        selected = self.document("force", dump, *SCENE, "--select", "type:1-2")
        for name in ("F_max", "delta_max", "hysteresis_area", "outcome"):
            self.assertEqual(selected[name], plain[name])
        self.refused("force", dump, *SCENE, "--bodies", "type", says=["3 bodies"])

    def test_large_files_get_an_index(self):
        """Comments before some frames make the file larger than 256 MiB."""
        text = gzip.decompress(SAMPLE.read_bytes())
        filler = (b"# " + b"-" * 1021 + b"\n") * (90 << 10)
        large = self.dir / "large.lammpstrj"
        first, *frames = text.split(b"ITEM: TIME\n")[1:]
        with open(large, "wb") as file:
            file.write(text.split(b"ITEM: TIME\n")[0] + b"ITEM: TIME\n" + first)
            for k, frame in enumerate(frames):
                file.write((filler if k in (5, 20, 30) else b"") + b"ITEM: TIME\n" + frame)
        whole = self.table("force", large, *SCENE)
        self.assertEqual(whole["X"], self.table("force", SAMPLE)["X"])
        index = large.with_name(large.name + ".mdana-index")
        self.assertEqual(index.read_text().split()[:2], ["mdana-index", "1"])
        self.assertEqual(self.table("force", large, *SCENE, "--frames", "20:47:3")["step"], whole["step"][20::3])
        old = index.read_text()
        os.utime(large)  # another time: the index is of no use, and made anew by the next who reads all
        self.assertEqual(self.table("force", large, *SCENE)["X"], whole["X"])
        self.assertNotEqual(index.read_text(), old)

    def test_timings(self):
        """Of one thread stages follow each other: they add up to all, and no result changes."""
        done = self.mdana("force", SAMPLE, "--threads", "1", "--timings")
        stages = [(name, float(seconds)) for name, seconds in re.findall(r"(?m)^(.+?)  +([\d.]+) s +[\d.]+ %$", done.stderr)]
        *parts, (last, whole) = stages
        self.assertEqual((len(parts), last), (5, "in all"))
        self.assertAlmostEqual(sum(seconds for _, seconds in parts), whole, delta=0.1 * whole + 0.003)
        self.assertEqual(self.mdana("force", SAMPLE, "--threads", "1").stderr, "")

    def test_strict_refuses_what_else_is_used_in_part(self):
        cut = self.dir / "cut.lammpstrj"
        cut.write_bytes(gzip.decompress(SAMPLE.read_bytes())[:-100])
        for command in ("force", "contact-radius"):
            self.assertIn("damaged input", str(self.document(command, cut, *SCENE, code=3)["warnings"]))
            self.refused(command, cut, *SCENE, "--strict", says=["the file ends"])
            self.mdana(command, SAMPLE, "--strict")


if __name__ == "__main__":
    running.main()
