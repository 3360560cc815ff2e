#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that lose atoms or exchange them, on made-up bounces whose answers are known."""

import itertools
import math

import numpy as np

import dumps
import running

EDGE = 6
GRID = np.array(list(itertools.product(range(EDGE), repeat=3))) - (EDGE - 1) / 2.0
ATOMS = len(GRID)  # of a body
COLUMNS = ["id", "type", "x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz", "c_pe"]


def bounce():
    """The bounce of dumps.spring_bounce (e = 1/2) with cubes of 6 x 6 x 6 atoms: a list of frames, all atoms of body 1
    first. The masses are 27 times as large, and so are the forces."""
    frames = []
    for frame in dumps.spring_bounce()[0]:
        rows = []
        for body in (1, 2):
            centre, velocity, force = (dumps.mean(frame.body(body)[names]) for names in ("x y z", "vx vy vz", "fx fy fz"))
            for k, place in enumerate(GRID):
                rows.append([ATOMS * (body - 1) + k + 1, body, *(centre + place), *velocity, *force, -1.0])
        frames.append(dumps.Frame(frame.step, frame.time, COLUMNS, np.array(rows)))
    return frames


class Lost(running.Case):
    def lose(self, atoms, first):
        """The bounce in which so many atoms of body 1, from the middle of a face, are gone from a frame on."""
        frames = bounce()
        middle = np.argsort(np.abs(GRID).sum(axis=1))[:atoms]  # which moves the centre least
        for k in range(first, len(frames)):
            frames[k].atoms = np.delete(frames[k].atoms, middle, axis=0)
        return dumps.write(self.dir / "dump.lammpstrj", frames), len(frames)

    def test_a_few_are_measured_and_told(self):
        path, frames = self.lose(2, 45)  # of 216: 0.93 %
        for command in ("force", "energy", "collision", "contact-radius"):
            with self.subTest(command):
                layer = ("--layer", 4) if command in ("collision", "contact-radius") else ()
                document = self.document(command, path, "--radius", 5, *layer)
                self.assertEqual(document["frames"], frames)
                self.assertEqual(document["lost"], 2)
                [warning] = [w for w in document["warnings"] if "other atoms" in w]
                self.assertIn("frame 45", warning)
                self.assertIn("up to 2 fewer", warning)
        for command in ("force", "energy", "collision"):
            lost = self.table(command, path, "--radius", 5)["lost"]
            self.assertEqual(lost, [0] * 45 + [2] * (frames - 45), command)
        whole = dumps.write(self.dir / "whole.lammpstrj", bounce())
        self.assertEqual(self.document("force", whole, "--radius", 5)["lost"], 0)
        e = [self.document("force", p, "--radius", 5)["e"]["value"] for p in (path, whole)]
        self.assertAlmostEqual(e[0], e[1], delta=1e-9)

    def test_more_than_one_per_cent_is_refused(self):
        path, _ = self.lose(3, 45)
        for command in ("force", "energy", "collision"):
            message = self.refused(command, path, "--radius", 5, says=(path, "213", "lost", "--frames"))
            self.assertIn("more than 1 %", message)
        self.assertEqual(self.document("force", path, "--radius", 5, "--frames", ":45")["frames"], 45)

    def test_a_doubtful_count_is_not_a_loss(self):
        """A frame that says it has an atom less than stand in it: what follows cannot be read, and it does not count."""
        frames = bounce()
        texts = [frame.text() for frame in frames]
        texts[45] = texts[45].replace(f"ATOMS\n{2 * ATOMS}\n", f"ATOMS\n{2 * ATOMS - 1}\n")
        path = self.dir / "count.lammpstrj"
        path.write_text("".join(texts))
        document = self.document("force", path, "--radius", 5, code=3)
        self.assertEqual(document["frames"], 45)
        self.assertEqual(document["lost"], 0)


class Exchanged(running.Case):
    def test_both_memberships(self):
        """One atom of type 1 flies with body 2. By type body 1 is one of 215 atoms with V1 and one with V2; its velocity
        is off by (V2 - V1)/216, and its atoms' own motion is 215/216 (V2 - V1)^2/2."""
        frames = bounce()
        for frame in frames:
            frame.atoms[0, 2:] = frame.atoms[ATOMS, 2:]
            frame.atoms[0, 2] += EDGE  # beyond the last plane of atoms along x
        path = dumps.write(self.dir / "dump.lammpstrj", frames)
        last = frames[-1].atoms
        speed = np.linalg.norm(last[-1, 5:8] - last[1, 5:8])
        share = (ATOMS - 1) / ATOMS
        for command in ("energy", "collision"):
            with self.subTest(command):
                document = self.document(command, path, "--radius", 5)
                self.assertEqual([document["exchanged"][name] for name in ("from_body1", "from_body2", "loose")],
                                 [1, 0, 0])
                first, final = document["by_first_frame"], document["by_final_clusters"]
                self.assertAlmostEqual(first["K_t_after"]["value"], share * speed**2 / 2, delta=1e-12)
                self.assertAlmostEqual(final["K_t_after"]["value"], 0, delta=1e-12)
                self.assertAlmostEqual(first["K_p_after"]["value"], ATOMS / 4 * (share * speed)**2, delta=1e-12)
                reduced = (ATOMS - 1) * (ATOMS + 1) / (2 * ATOMS)
                self.assertAlmostEqual(final["K_p_after"]["value"], reduced * speed**2 / 2, delta=1e-12)
                self.assertAlmostEqual(first["e"]["value"], 0.5, delta=1e-9)
                self.assertAlmostEqual(final["e"]["value"], 0.5 / share, delta=1e-9)
                self.assertAlmostEqual(final["e_total"]["value"], 0.5 / share, delta=1e-9)
                self.assertTrue(any("1 atoms of body 1" in w for w in document["warnings"]))

    def test_a_loose_atom(self):
        frames = bounce()
        for frame in frames:
            frame.atoms[0, 2:5] += [30, 30, 30]
        document = self.document("energy", dumps.write(self.dir / "dump.lammpstrj", frames), "--radius", 5)
        self.assertEqual([document["exchanged"][name] for name in ("from_body1", "from_body2", "loose")], [0, 0, 1])

    def test_none(self):
        document = self.document("collision", dumps.write(self.dir / "dump.lammpstrj", bounce()), "--radius", 5)
        self.assertEqual([document["exchanged"][name] for name in ("from_body1", "from_body2", "loose")], [0, 0, 0])
        self.assertEqual(document["by_first_frame"], document["by_final_clusters"])
        self.assertFalse([w for w in document["warnings"] if "other one" in w])
        stick = self.document("collision", running.SAMPLE)
        self.assertIn("exchanged atoms", [entry["what"] for entry in stick["left_out"]])


class Series(running.Case):
    def series(self):
        """Two bounces with e = 1/2, one with e = 1, one that sticks, one that cannot be read."""
        paths = [dumps.write(self.dir / "a.lammpstrj", dumps.spring_bounce()[0]),
                 dumps.write(self.dir / "b.lammpstrj", dumps.spring_bounce(stiffness=80)[0]),
                 dumps.write(self.dir / "c.lammpstrj", dumps.spring_bounce(harder=1.0)[0])]
        stick = self.dir / "stick.lammpstrj"
        dumps.write(stick, sticking())
        return [*paths, stick, self.dir / "missing.lammpstrj"]

    def test_summary(self):
        paths = self.series()
        done = self.mdana("collision", *paths, "--radius", 5, "--json", code=1)
        self.assertIn("missing.lammpstrj", done.stderr)
        document = running.parse_json(done.stdout)
        self.assertEqual([run.get("outcome") for run in document["runs"]], ["bounce"] * 3 + ["stick", None])
        self.assertIn("missing", document["runs"][4]["failure"])
        summary = document["summary"]
        self.assertEqual([summary[name] for name in ("runs", "bounce", "stick", "unresolved", "failed")], [5, 3, 1, 0, 1])
        share = summary["sticking_probability"]
        self.assertEqual(share["value"], 0.25)
        for p in (share["low"], share["high"]):  # Wilson: where 1/4 lies 1.96 standard deviations from p
            self.assertAlmostEqual((0.25 - p)**2, 1.959964**2 * p * (1 - p) / 4, 6)
        self.assertAlmostEqual(summary["e_rms"]["value"], math.sqrt((0.25 + 0.25 + 1 + 0) / 4), delta=1e-6)
        self.assertAlmostEqual(summary["e_rms"]["spread"], np.std([0.5, 0.5, 1, 0], ddof=1), delta=1e-6)
        self.assertAlmostEqual(summary["e_rms_bouncing"]["value"], math.sqrt(1.5 / 3), delta=1e-6)
        self.assertEqual(summary["e_rms_bouncing"]["runs"], 3)

    def test_runs_are_what_they_are_alone(self):
        paths = self.series()[:2]
        document = self.document("collision", *paths, "--radius", 5)
        for path, run in zip(paths, document["runs"]):
            alone = self.document("collision", path, "--radius", 5)
            for different in (run, alone):
                del different["seconds"]
            self.assertEqual(run, alone)
        self.assertEqual(document["summary"]["failed"], 0)

    def test_table_has_a_row_a_run(self):
        paths = self.series()
        table = self.table("collision", *paths, "--radius", 5, code=1)
        self.assertEqual(table["dump"], [str(path) for path in paths])
        self.assertEqual(table["outcome"], ["bounce"] * 3 + ["stick", "failed"])
        self.assertIsNone(table["e"][4])
        self.assertEqual(table["e"][3], 0)

    def test_other_commands_take_one(self):
        self.mdana("force", running.SAMPLE, running.SAMPLE, code=2)


def sticking(stiffness=50.0, speed=0.25, touch=10.0, mass=4.0, damping=1.0):
    """A spring with damping that also pulls: the pair oscillates."""
    w = math.sqrt(stiffness / mass)
    frames = []
    for k in range(-20, 200):
        t = 0.03 * k
        if k <= 0:
            delta, v, force = speed * t, speed, 0.0
        else:
            s = math.exp(-damping * t) * speed / w
            delta = s * math.sin(w * t)
            v = s * (w * math.cos(w * t) - damping * math.sin(w * t))
            force = mass * (2 * damping * v + (w * w + damping**2) * delta)
        frames.append(dumps.two_cubes(1000 + k, t + 0.6, touch - delta, -v, force))
    return frames


class Overlays(running.Case):
    def test_scales_and_columns(self):
        frames, top, depth, _ = dumps.spring_bounce()
        path = dumps.write(self.dir / "dump.lammpstrj", frames)
        gamma, modulus, reduced = 2.0, 40.0, 2.5
        options = ("collision", path, "--radius", 5, "--surface-energy", gamma, "--modulus", modulus)
        document, table = self.document(*options), self.table(*options)
        pull = 3 * math.pi * gamma * reduced
        a0 = (9 * math.pi * gamma * reduced**2 / modulus)**(1 / 3)
        self.assertAlmostEqual(document["F_c"]["value"], pull, 12)
        self.assertAlmostEqual(document["delta_0"]["value"], a0**2 / (3 * reduced), 12)
        for column, of, unit in (("F_over_F_c", "F", pull), ("delta_over_delta0", "delta", a0**2 / (3 * reduced))):
            self.assert_close(table[column], [v / unit for v in table[of]], 1e-14, max(map(abs, table[column])), column)
        # Loading F = k delta, unloading from delta_max with 4 k: the loop is widest where unloading ends.
        loop = [v for v in table["loop_over_F_c"] if v is not None]
        widest = 0.75 * top / pull
        self.assertAlmostEqual(max(loop), widest, delta=0.02 * widest)
        self.assertAlmostEqual(document["loop_over_F_c"]["max"]["value"], max(loop), 12)
        self.assertAlmostEqual(document["loop_over_F_c"]["at_delta"]["value"], 0.75 * depth, delta=0.02 * depth)
        hertz = [4 / 3 * modulus * math.sqrt(reduced) * max(d, 0)**1.5 for d in table["delta"]]
        self.assert_close(table["F_hertz"], hertz, 1e-12, max(hertz), "F_hertz")
        self.assertEqual(len(table["F_jkr"]), len(hertz))

    def test_without_gamma_they_are_left_out(self):
        path = dumps.write(self.dir / "dump.lammpstrj", dumps.spring_bounce()[0])
        document = self.document("collision", path, "--radius", 5)
        self.assertIn("F/F_c", [entry["what"] for entry in document["left_out"]])
        self.assertNotIn("F_c", document)


class FarSide(running.Case):
    def test_a_bump(self):
        """A plane of atoms of body 2 stands out by one spacing at its far end after the turn."""
        along = GRID @ dumps.DIRECTION
        behind = np.argsort(along)[-8:] + ATOMS
        turn = 36
        for bump in (0.0, 1.0):
            frames = bounce()
            for frame in frames[turn:]:
                frame.atoms[behind, 2:5] += bump * dumps.DIRECTION
            document = self.document("collision", dumps.write(self.dir / "dump.lammpstrj", frames), "--radius", 5)
            growth = document["far_side"]["body2"]
            wanted = bump * (1 - 8 / ATOMS)  # the centre of mass follows
            self.assertAlmostEqual(growth["value"], wanted, delta=1e-9)
            self.assertAlmostEqual(document["far_side"]["body1"]["value"], 0, delta=1e-9)
            reason = document["plastic_reasons"][-1]
            self.assertIn("a bump" if bump else "no bump", reason)

    def test_rotation(self):
        """Body 2 turns about its centre with w = 0.1 after the bounce; body 1 does not."""
        frames = bounce()
        spin = np.array([0, 0, 0.1])
        for frame in frames[40:]:
            frame.atoms[ATOMS:, 5:8] += np.cross(spin, GRID)
        path = dumps.write(self.dir / "dump.lammpstrj", frames)
        energy = 0.5 * 0.01 * np.sum(GRID[:, 0]**2 + GRID[:, 1]**2)
        for command in ("force", "collision"):
            rotation = self.document(command, path, "--radius", 5)["rotation"]
            self.assertAlmostEqual(rotation["body2_after"]["value"], energy, delta=1e-9)
            for name in ("body1_before", "body1_after", "body2_before"):
                self.assertAlmostEqual(rotation[name]["value"], 0, delta=1e-12)


if __name__ == "__main__":
    running.main()
