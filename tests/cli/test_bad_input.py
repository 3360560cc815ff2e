# SPDX-License-Identifier: GPL-3.0-or-later
"""Input that cannot be used: every command says what is wrong, where, and what to do, and leaves nothing behind."""

import gzip
import os
import shutil

import numpy as np

import dumps
import running
from running import SAMPLE, Case

COMMANDS = ("info", "force", "contact-radius", "fit-hertz")
MEASURING = COMMANDS[1:]


def bounce():
    """A good dump: two bodies in contact, with times, velocities and forces."""
    return dumps.spring_bounce()[0]


class NoDump(Case):
    def refused_by_all(self, path, *says):
        for command in COMMANDS:
            with self.subTest(command):
                self.refused(command, path, says=(path, *says))

    def test_missing(self):
        self.refused_by_all(self.dir / "missing.dump", "No such file")

    def test_directory(self):
        self.refused_by_all(self.dir, "not a file")

    def test_pipe(self):
        """At once: reading would wait for a writer for ever."""
        pipe = self.dir / "pipe.dump"
        os.mkfifo(pipe)
        for command in COMMANDS:
            with self.subTest(command):
                try:
                    done = running.run(command, pipe, timeout=3)
                except running.subprocess.TimeoutExpired:
                    self.fail("mdana waits for a writer of the pipe")
                self.assertEqual(done.returncode, 1)
                self.assertIn("not a file", done.stderr)

    def test_device(self):
        self.refused_by_all("/dev/null", "not a file")

    def test_empty(self):
        for name, data in (("empty.dump", b""), ("empty.gz", gzip.compress(b"")), ("newlines.dump", b"\n\n \n")):
            path = self.dir / name
            path.write_bytes(data)
            self.refused_by_all(path)

    def test_not_a_dump(self):
        for name, data in (
            ("text", b"step X F\n1 2 3\n"), ("xyz", b"2\ncomment\nC 0 0 0\nC 1 0 0\n"),
            ("binary", bytes(range(256)) * 40),
            ("gzip magic only", b"\x1f\x8b"), ("gzip garbage", b"\x1f\x8b" + bytes(100)),
            ("gzip of text", gzip.compress(b"step X F\n1 2 3\n")), ("other ITEM", b"ITEM: SOMETHING\n3\n"),
        ):
            path = self.dir / name.replace(" ", "-")
            path.write_bytes(data)
            with self.subTest(name):
                self.refused_by_all(path)

    def test_header_only(self):
        path = self.dir / "header.dump"
        path.write_text(bounce()[0].head(), encoding="utf-8")
        self.refused_by_all(path)

    def test_broken_headers(self):
        good = bounce()[0].text()
        for name, old, new, line in [
            ("step", "TIMESTEP\n980\n", "TIMESTEP\nten\n", 6),
            ("atoms", "ATOMS\n16\n", "ATOMS\n-16\n", 8),
            ("too many atoms", "ATOMS\n16\n", "ATOMS\n99999999999999999999999\n", 8),
            ("box", "-50 50\n", "-50 fifty\n", 10),
            ("no box", dumps.BOX, "", 9),
            ("no step", "ITEM: TIMESTEP\n980\n", "", 11),
            ("units", "UNITS\nlj", "UNITS\nfurlong", 2),
            ("no columns", "ITEM: ATOMS " + " ".join(dumps.COLUMNS), "ITEM: ATOMS", 13),
            ("twice", "vx vy vz", "vx vx vz", 13),
        ]:
            self.assertIn(old, good)
            path = self.dir / "broken.dump"
            path.write_text(good.replace(old, new, 1), encoding="utf-8")
            with self.subTest(name):
                self.refused_by_all(path, f"{path}:{line}")


class Unusable(Case):
    """Dumps that can be read, but not analysed. `info` succeeds: it says why not, in the words of the others."""

    def dump(self, frames, name="run.dump"):
        return dumps.write(self.dir / name, frames)

    def refused_by_all(self, dump, *says):
        self.told_by_info(dump, *says)
        for command in MEASURING:
            with self.subTest(command):
                self.refused(command, dump, says=(dump, *says))

    def test_no_positions(self):
        self.refused_by_all(self.dump([frame.without("x", "y", "z") for frame in bounce()]), "position", "x y z")

    def test_no_time(self):
        """Without forces the force is a derivative by time; the message tells of --timestep, which then works."""
        frames = [frame.without("fx", "fy", "fz") for frame in bounce()]
        for frame in frames:
            frame.time = None
        for name, shown in (("velocities", frames), ("positions", [f.without("vx", "vy", "vz") for f in frames])):
            dump = self.dump(shown)
            for command in ("force", "fit-hertz"):
                with self.subTest(f"{command} {name}"):
                    self.refused(command, dump, "--radius", "5", says=(dump, "time", "--timestep"))
                    self.mdana(command, dump, "--radius", "5", "--timestep", "0.02777")

    def test_source_that_the_dump_lacks(self):
        frames = [frame.without("fx", "fy", "fz", "vx", "vy", "vz") for frame in bounce()]
        dump = self.dump(frames)
        for source, column in (("forces", "fx"), ("velocities", "vx")):
            self.refused("force", dump, "--source", source, says=(dump, column))

    def test_one_body(self):
        """All atoms in one heap; and `--bodies` rules that find one."""
        frames = bounce()
        for frame in frames:
            frame.atoms = frame.body(1).atoms
        one = self.dump(frames, "one.dump")
        two = self.dump(bounce(), "two.dump")
        for command in MEASURING:
            for dump, rule in ((one, []), (one, ["--bodies", "type"]), (one, ["--bodies", "clusters"]),
                               (two, ["--bodies", "id:1-99"]), (two, ["--bodies", "id:100-200"])):
                with self.subTest(f"{command} {dump.name} {rule}"):
                    self.refused(command, dump, *rule, says=[dump])
        self.assertEqual(self.document("info", one)["body_count"], 1)

    def test_three_types(self):
        frames = bounce()
        for frame in frames:
            frame.atoms[::5, 1] = 3
        dump = self.dump(frames)
        for command in MEASURING:
            self.refused(command, dump, "--bodies", "type", says=(dump, "3", "two", "--bodies"))
            self.refused(command, dump, "--bodies", "mol", says=(dump, "mol"))
        # Without a rule three types are no bodies, but the two heaps are.
        self.assertIn("clusters", self.document("force", dump)["bodies"])

    def test_no_units(self):
        frames = bounce()
        for frame in frames:
            frame.units = None
        dump = self.dump(frames)
        self.refused_by_all(dump, "units", "--units")
        self.mdana("force", dump, "--units", "lj")

    def test_no_masses(self):
        frames = bounce()
        for frame in frames:
            frame.units = "metal"
        dump = self.dump(frames)
        self.refused_by_all(dump, "mass", "--masses")
        self.mdana("force", dump, "--masses", "1=63.5,2=63.5")
        self.refused("force", dump, "--masses", "1=63.5", says=(dump, "mass", "type 2"))
        self.refused("contact-radius", dump, "--masses", "1=1,2=1", says=(dump, "--layer"))

    def test_masses_in_the_dump_must_be_positive(self):
        for mass in (0.0, -1.0, float("nan"), float("inf")):
            frames = bounce()
            for frame in frames:
                frame.columns = frame.columns + ["mass"]
                frame.atoms = np.hstack([frame.atoms, np.full((16, 1), 1.0)])
                frame.atoms[11, -1] = mass
            with self.subTest(mass):
                dump = self.dump(frames)
                self.refused("force", dump, says=(dump, "mass"))

    def test_no_atoms(self):
        frames = bounce()
        for frame in frames:
            frame.atoms = frame.atoms[:0]
        self.refused_by_all(self.dump(frames), "no atoms")

    def test_values_that_are_no_numbers(self):
        """In the first frame: nothing to save; the message has the line."""
        good = "".join(frame.text() for frame in bounce())
        line = 13 + 4  # the fourth atom
        for column, word in ((2, "abc"), (2, "nan"), (4, "inf"), (0, "1.5"), (1, "x"), (2, "1,5"), (2, "")):
            lines = good.splitlines()
            words = lines[line - 1].split()
            words[column] = word
            lines[line - 1] = " ".join(words)
            dump = self.dir / "words.dump"
            dump.write_text("\n".join(lines) + "\n", encoding="utf-8")
            with self.subTest(f"{word!r} in column {column}"):
                rule = ["--bodies", "id:1-8"] if column == 0 else []
                says = [dump]  # a value that is no number at all is also told by its line
                if word not in ("nan", "inf"):
                    says.append(f"{dump}:{line}")
                self.refused("force", dump, *rule, says=says)

    def test_too_few_frames(self):
        frames = bounce()[18:]
        bare = [frame.without("fx", "fy", "fz") for frame in frames]
        for count, shown in ((1, frames), (1, bare), (2, bare), (4, bare)):
            with self.subTest(f"{count} frames"):
                dump = self.dump(shown[:count])
                for command in ("force", "fit-hertz"):
                    self.refused(command, dump, "--radius", "5", says=(dump, str(count), "frame"))

    def test_too_few_points_for_the_fit(self):
        dump = self.dump(dumps.hertz_bounce())
        for arguments in (["--min-force-fraction", "0.9999"], ["--stride", "10"],
                          ["--max-force-fraction", "0.001", "--min-force-fraction", "0"]):
            with self.subTest(arguments):
                self.refused("fit-hertz", dump, *arguments, says=(dump, "frames", "at least"))

    def test_atoms_that_change_body(self):
        frames = bounce()
        for frame in frames[30:]:
            frame.atoms[0, 1] = 2
        dump = self.dump(frames)
        says = self.refused("force", dump, says=[dump])
        self.assertIn(str(frames[30].step), says)

    def test_bodies_at_the_same_place(self):
        frames = bounce()
        for frame in frames:
            frame.atoms[8:, 2:5] = frame.atoms[:8, 2:5]
        dump = self.dump(frames)
        for command in ("force", "contact-radius"):
            with self.subTest(command):
                self.refused(command, dump, "--radius", "5", says=[dump])


class NoContact(Case):
    """Bodies that pass or stay apart. The radii are 5, their surfaces never nearer than 2."""

    def fly_by(self, offset, columns=()):
        frames = []
        for k in range(41):
            t = k / 4 - 5
            frame = dumps.two_cubes(k, k / 4, 0.0)
            for body, sign in ((slice(0, 8), -0.5), (slice(8, 16), 0.5)):
                frame.atoms[body, 2:5] += sign * (np.array([-1.3 * t, offset, 0]) - (0 if offset else [13, 0, 0]))
                frame.atoms[body, 5:8] = sign * np.array([-1.3, 0, 0])
            frames.append(frame.without(*columns))
        return dumps.write(self.dir / "fly-by.dump", frames)

    def test_fly_by(self):
        """No force at all; where it is a derivative it is nothing but rounding."""
        for name, columns in (("forces", ()), ("velocities", ("fx", "fy", "fz")),
                              ("positions", ("fx", "fy", "fz", "vx", "vy", "vz"))):
            dump = self.fly_by(12.0, columns)
            for command in MEASURING:
                with self.subTest(f"{command} {name}"):
                    self.refused(command, dump, "--radius", "5", says=(dump, "no contact"))

    def test_approach_that_ends_early(self):
        dump = self.fly_by(0.0, ("fx", "fy", "fz"))
        for command in MEASURING:
            with self.subTest(command):
                self.refused(command, dump, "--radius", "2", says=(dump, "no contact"))

    def test_the_part_of_a_run_before_contact(self):
        frames, *_ = dumps.spring_bounce()
        dump = dumps.write(self.dir / "before.dump", frames[:15])
        self.refused("force", dump, "--radius", "5", says=(dump, "no contact"))


class Scenes(Case):
    def setUp(self):
        super().setUp()
        self.dump = shutil.copy(SAMPLE, self.dir / "dump.lammpstrj.gz")
        self.scene = self.dir / "scene.toml"
        self.good = SAMPLE.with_name("scene.toml").read_text(encoding="utf-8")

    def refused_scene(self, text, *says, line=None):
        self.scene.write_text(text, encoding="utf-8")
        place = f"{self.scene}:{line}" if line else self.scene
        self.told_by_info(self.dump, place, *says)
        for command in MEASURING:
            self.refused(command, self.dump, says=(place, *says))

    def test_mistakes_in_the_scene(self):
        lines = self.good.splitlines()

        def at(text):
            return next(k for k, line in enumerate(lines, 1) if line.startswith(text))

        for name, old, new, says in [
            ("unknown key", "sigma = 1.0", "sigma = 1.0\ncolour = 3", "colour"),
            ("unknown key of a body", 'name = "1"', 'nickname = "1"', "nickname"),
            ("not TOML", "sigma = 1.0", "sigma = = 1.0", ""),
            ("units", 'units = "lj"', 'units = "furlong"', "units: unknown"),
            ("units of the wrong kind", 'units = "lj"', "units = 3", "units"),
            ("time step", "timestep = 0.0078125", "timestep = -1", "timestep"),
            ("time step of the wrong kind", "timestep = 0.0078125", 'timestep = "fast"', "timestep"),
            ("mass", "1 = 1.0", "1 = 0.0", "masses.1"),
            ("type", "1 = 1.0", "one = 1.0", "masses.one"),
            ("radius", "radius = 5.0", "radius = 0", "radius"),
            ("interaction", 'interaction = "adhesive"', 'interaction = "love"', "interaction"),
        ]:
            with self.subTest(name):
                line = at(old) + (1 if "colour" in new else 0)
                self.refused_scene(self.good.replace(old, new, 1), says, line=line)
        self.refused_scene(self.good.replace("schema = 1", "schema = 2"), "schema")
        self.refused_scene("", "schema")

    def test_contradictory_units(self):
        self.refused_scene(self.good.replace('units = "lj"', 'units = "metal"'), "lj", "metal", self.dump)
        self.scene.write_text(self.good, encoding="utf-8")
        self.refused("force", self.dump, "--units", "metal", says=(self.dump, "lj", "metal"))

    def test_option_that_contradicts_the_scene(self):
        """A dump without units: the scene says lj, the option metal. To choose silently would be to guess."""
        frames = dumps.read(SAMPLE)
        for frame in frames:
            frame.units = None
        plain = dumps.write(self.dir / "plain.dump", frames)
        self.scene.write_text(self.good.replace("dump.lammpstrj.gz", plain.name), encoding="utf-8")
        done = running.run("force", plain, "--units", "metal", "--json")
        if done.returncode == 0:
            self.assertTrue(any("units" in warning for warning in running.parse_json(done.stdout)["warnings"]))
        else:
            self.assertIn("units", done.stderr)

    def test_timestep_that_contradicts_the_dump(self):
        """The dump states its times. An option that disagrees may win, or be refused, or be warned of; it must not be
        passed over in silence."""
        self.scene.write_text(self.good, encoding="utf-8")
        done = running.run("force", self.dump, "--timestep", "0.1", "--json")
        if done.returncode == 0:
            document = running.parse_json(done.stdout)
            wins = self.table("force", self.dump, "--timestep", "0.1")["time"][0] == 4672 * 0.1
            self.assertTrue(wins or any("time" in warning for warning in document["warnings"]), "--timestep is ignored")
        else:
            self.assertIn("timestep", done.stderr)

    def test_scene_that_is_not_there(self):
        missing = self.dir / "none.toml"
        self.refused("force", self.dump, "--scene", missing, says=[missing])
        self.refused("force", self.dump, "--scene", self.dir, says=[self.dir])

    def test_scene_of_another_dump_is_not_used(self):
        self.scene.write_text(self.good.replace("dump.lammpstrj.gz", "other.gz"), encoding="utf-8")
        self.assertIsNone(self.document("force", self.dump)["scene"])
        self.assertIn("scene", self.document("force", self.dump, "--scene", self.scene)["radius_source"])


if __name__ == "__main__":
    running.main()
