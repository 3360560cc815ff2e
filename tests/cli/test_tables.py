# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables, against the same numbers computed here from the dump, and against answers in closed form."""

import math
import shutil

import numpy as np

import dumps
import running
from dumps import along, centres, five_point, mean
from running import SAMPLE, Case


class Recomputed(Case):
    """Every column on the sample dump, by numpy and exact sums instead of mdana's reader and merges."""

    @classmethod
    def setUpClass(cls):
        cls.frames = dumps.read(SAMPLE)
        cls.times = np.array([frame.time for frame in cls.frames])
        centre = np.array([centres(frame) for frame in cls.frames])
        velocity = np.array([centres(frame, "vx vy vz") for frame in cls.frames])
        cls.line = centre[:, 1] - centre[:, 0]
        cls.velocity = velocity[:, 1] - velocity[:, 0]
        cls.distance = np.linalg.norm(cls.line, axis=1)
        cls.centre = centre
        cls.reduced_mass = 603 / 2  # two bodies of 603 atoms of mass 1

    def forces(self, order, samples):
        return self.reduced_mass * along(five_point(self.times, samples, order), self.line)

    def test_motion(self):
        """To 1e-12 of the greatest value: some 600 numbers of up to 16 digits each are summed, with errors of 1e-16
        each that grow like the root of their number."""
        table = self.table("force", SAMPLE)
        self.assertEqual(list(table)[:6], ["step", "time", "X", "delta", "v", "F"])
        self.assertEqual(table["step"], [frame.step for frame in self.frames])
        self.assertEqual(table["time"], list(self.times))
        self.assert_close(table["X"], self.distance, 1e-12, max(self.distance), "X")
        self.assert_close(table["delta"], 10 - self.distance, 1e-12, max(self.distance), "delta")
        speed = -along(self.velocity, self.line)
        self.assert_close(table["v"], speed, 1e-12, max(abs(speed)), "v")

    def test_force_from_velocities(self):
        """To 1e-9 of F_max: rounding is 1e-16 v m*/dt, that is 1e-14 of F_max; the rest is room for a solver of badly
        scaled equations."""
        wanted = self.forces(1, self.velocity)
        table = self.table("force", SAMPLE)
        self.assert_close(table["F"], wanted, 1e-9, max(wanted), "F")
        document = self.document("force", SAMPLE)
        self.assertAlmostEqual(document["F_max"]["value"], max(wanted), delta=1e-9 * max(wanted))
        self.assertAlmostEqual(document["delta_max"]["value"], 10 - min(self.distance), delta=1e-11)
        turn = int(np.argmin(self.distance))
        self.assertAlmostEqual(document["F_min_loading"]["value"], min(wanted[:turn + 1]), delta=1e-9 * max(wanted))

    def test_force_from_positions(self):
        wanted = self.forces(2, self.line)
        table = self.table("force", SAMPLE, "--source", "positions")
        self.assert_close(table["F"], wanted, 1e-9, max(abs(wanted)), "F")
        both = self.table("force", SAMPLE, "--compare")
        self.assertEqual(both["F_positions"], table["F"])

    def test_stride(self):
        """A stride is the same as a dump that holds only those frames, to the last bit."""
        thin = dumps.write(self.dir / "thin.dump", self.frames[::3])
        shutil.copy(SAMPLE.with_name("scene.toml"), self.dir / "scene.toml")
        for command in ("force", "contact-radius"):
            few = self.table(command, thin, "--scene", self.dir / "scene.toml")
            self.assertEqual(self.table(command, SAMPLE, "--stride", "3"), few)

    def test_radius_without_scene(self):
        """sqrt(5/3) r_g of each body in the first frame, when nothing states a radius; the dump states its units, and
        masses of 1 are assumed and said."""
        alone = shutil.copy(SAMPLE, self.dir / "alone.gz")
        radii = 0.0
        for number in (1, 2):
            atoms = self.frames[0].body(number)["x y z"]
            radii += math.sqrt(5 / 3 * math.fsum(np.sum((atoms - mean(atoms))**2, axis=1)) / len(atoms))
        table = self.table("force", alone)
        self.assert_close(table["delta"], radii - self.distance, 1e-12, max(self.distance), "delta")
        document = self.document("force", alone)
        self.assertIn("r_g", document["radius_source"])
        self.assertTrue(any("mass" in warning for warning in document["warnings"]))

    def contact_radius(self, frame, centre, radii, half_layer):
        """sqrt(2) r_g within the plane of the atoms in the layer, the atoms of each body there, and how near to the
        layer's faces an atom comes."""
        line = centre[1] - centre[0]
        distance = np.linalg.norm(line)
        normal = line / distance
        plane = centre[0] + normal * (distance**2 + radii[0]**2 - radii[1]**2) / (2 * distance)
        height = (frame["x y z"] - plane) @ normal
        inside = np.abs(height) <= half_layer
        numbers = [int(np.sum(frame["type"][inside, 0] == body)) for body in (1, 2)]
        atoms = frame["x y z"][inside]
        flat = atoms - np.outer((atoms - plane) @ normal, normal)
        radius = math.sqrt(2 * np.mean(np.sum((flat - np.mean(flat, axis=0))**2, axis=1))) if all(numbers) else 0.0
        return radius, *numbers, np.min(np.abs(np.abs(height) - half_layer))

    def test_contact_radius(self):
        """To 1e-10 of the greatest: rounding of coordinates of 10 is 1e-15; the rest is room for other ways to sum. The
        atoms in the layer must be the same: none is within 1e-9 of its faces."""
        for arguments, radii, half_layer in [([], (5, 5), 0.5),
                                             (["--radius", "5,4.5", "--layer", "1.3"], (5, 4.5), 0.65)]:
            with self.subTest(arguments):
                wanted = [self.contact_radius(frame, centre, radii, half_layer)
                          for frame, centre in zip(self.frames, self.centre)]
                radius, first, second, margin = (list(column) for column in zip(*wanted))
                self.assertGreater(min(margin), 1e-9, "the test cannot decide which atoms are in the layer")
                table = self.table("contact-radius", SAMPLE, *arguments)
                self.assert_close(table["contact_radius"], radius, 1e-10, max(radius), "contact_radius")
                self.assertEqual((table["layer_atoms1"], table["layer_atoms2"]), (first, second))
                numbers = self.document("contact-radius", SAMPLE, *arguments)["contact_radius"]["gyration"]
                turn = int(np.argmin(self.distance))
                for name, value in (("max", max(radius)), ("at_delta_max", radius[turn]), ("end", radius[-1])):
                    self.assertAlmostEqual(numbers[name]["value"], value, delta=1e-10 * max(radius))


class ClosedForm(Case):
    def quartic(self, units, masses):
        """X(t) = 9 + (t - 3)^2/2 + (t - 3)^4/100: its derivatives over five points are exact."""
        frames = []
        for k in range(25):
            t = k / 4 - 3
            frames.append(dumps.two_cubes(k, k / 4, 9 + t**2 / 2 + t**4 / 100, t + t**3 / 25, masses=masses,
                                          units=units).without("fx", "fy", "fz"))
        return dumps.write(self.dir / f"quartic-{units}.dump", frames)

    def test_force_of_a_quartic_motion(self):
        """F = m* X'' with m* of unequal bodies, along an oblique centre line, in units with and without a factor
        (LAMMPS' mvv2e, from its update.cpp). Tolerance: positions are rounded at 1e-15 and divided by dt^2 = 1/16, with
        weights up to 10, against X'' of 1: 1e-12; velocities lose one dt less."""
        t = np.arange(25) / 4 - 3
        for units, factor in [("lj", 1.0), ("metal", 1.0364269e-4), ("real", 48.88821291**2), ("si", 1.0)]:
            masses = 2.0, 6.0
            dump = self.quartic(units, masses)
            reduced = 8 * 2.0 * 6.0 / 8.0  # eight atoms a body
            wanted = reduced * factor * (1 + 3 * t**2 / 25)
            options = ["--masses", "1=2,2=6", "--radius", "5"]
            for source in ("velocities", "positions"):
                with self.subTest(f"{units} {source}"):
                    table = self.table("force", dump, *options, "--source", source)
                    self.assert_close(table["F"], wanted, 1e-11, max(wanted), "F")
                    self.assert_close(table["v"], -(t + t**3 / 25), 1e-12, 10, "v")
                    document = self.document("force", dump, *options, "--source", source)
                    self.assertAlmostEqual(document["delta_max"]["value"], 1, delta=1e-13)
                    self.assertAlmostEqual(document["F_min_loading"]["value"], reduced * factor,
                                           delta=1e-11 * max(wanted))
                    # F depends on X only, so loading and unloading coincide.
                    self.assertAlmostEqual(document["hysteresis_area"]["value"], 0, delta=1e-11 * max(wanted))

    def test_bounce_with_loss(self):
        """Springs, loaded with k and unloaded with 4k: F_max, depth and loss are known. F is linear in delta between
        the frames, so that trapezoids are exact; what is left is rounding: 1e-15 of positions, a depth of 0.07."""
        frames, top, depth, lost = dumps.spring_bounce()
        dump = dumps.write(self.dir / "bounce.dump.gz", frames)
        document = self.document("force", dump, "--radius", "5", "--source", "forces")
        self.assertEqual(document["outcome"], "bounce")
        for name, value in (("F_max", top), ("delta_max", depth), ("hysteresis_area", lost), ("F_min_loading", 0.0)):
            self.assertAlmostEqual(document[name]["value"], value, delta=1e-11 * max(value, top), msg=name)
        phases = self.table("force", dump, "--radius", "5")["phase"]
        self.assertEqual([p for k, p in enumerate(phases) if k == 0 or phases[k - 1] != p],
                         ["approach", "loading", "unloading", "separated"])
        turn = 20 + 16  # of the free flight before, and of the loading
        self.assertEqual(phases.index("unloading"), turn + 1)

    def test_bounce_cut_at_the_turn_is_unresolved(self):
        frames, top, depth, _ = dumps.spring_bounce()
        dump = dumps.write(self.dir / "half.dump", frames[:37])
        document = self.document("force", dump, "--radius", "5")
        self.assertEqual(document["outcome"], "unresolved")
        self.assertAlmostEqual(document["F_max"]["value"], top, delta=1e-11 * top)
        self.assertAlmostEqual(document["delta_max"]["value"], depth, delta=1e-11)

    def test_order_of_atoms_and_layout_of_columns_do_not_matter(self):
        """The same numbers in another order: only the rounding of sums may differ, 1e-12 of the scale."""
        rng = np.random.default_rng(1)
        frames = dumps.read(SAMPLE)
        table = self.table("force", SAMPLE, "--radius", "5")
        columns = rng.permutation(len(frames[0].columns))
        for frame in frames:
            frame.atoms = rng.permutation(frame.atoms)[:, columns]
            frame.columns = [frame.columns[k] for k in columns]
        shuffled = dumps.write(self.dir / "shuffled.dump", frames)
        for bodies in ("type", "id:1-603"):
            other = self.table("force", shuffled, "--radius", "5", "--bodies", bodies)
            for name, scale in (("X", 12), ("v", 1), ("F", 100)):
                self.assert_close(other[name], table[name], 1e-12, scale, name)

    def test_clusters_find_the_same_bodies(self):
        """Two cubes apart, of one type each, or all of one type with ids mixed: clusters are told apart by place."""
        frames, *_ = dumps.spring_bounce()
        wanted = self.table("force", dumps.write(self.dir / "types.dump", frames), "--radius", "5")
        for frame in frames:
            frame.atoms[:, 1] = 1
        dump = dumps.write(self.dir / "one-type.dump", frames)
        self.assertEqual(self.table("force", dump, "--radius", "5"), wanted)
        self.assertEqual(self.table("force", dump, "--radius", "5", "--bodies", "clusters"), wanted)

    def test_wrapped_positions_with_images(self):
        """Periodic faces cut body 2 in two; image flags put it together again. Without them the output warns."""
        frames, *_ = dumps.spring_bounce()
        wanted = self.table("force", dumps.write(self.dir / "whole.dump", frames), "--radius", "5")
        box = "ITEM: BOX BOUNDS pp pp pp\n-4 4\n-4 4\n-4 4\n"
        for frame in frames:
            place = frame["x y z"]
            image = np.floor((place + 4) / 8)
            frame.atoms = np.hstack([frame.atoms, image])
            frame.atoms[:, 2:5] = place - 8 * image
            frame.columns, frame.box = frame.columns + ["ix", "iy", "iz"], box
        dump = dumps.write(self.dir / "wrapped.dump", frames)
        table = self.table("force", dump, "--radius", "5")
        self.assert_close(table["X"], wanted["X"], 1e-14, 10, "X")
        self.assertEqual(self.document("force", dump, "--radius", "5")["warnings"][1:], [])
        bare = dumps.write(self.dir / "bare.dump", [frame.without("ix", "iy", "iz") for frame in frames])
        self.assertTrue(any("wrapped" in w for w in self.document("info", bare)["warnings"]))


if __name__ == "__main__":
    running.main()
