# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that LAMMPS writes by the lines of mdana emit --for lammps-inline, here by an independent writer: a Hertzian collision whose
E* and R are known, energies by hand, hostile files; and the lines themselves for other ways to tell bodies apart."""

import gzip
import math
import random
import re

import dumps
import running
from running import SAMPLE, Case, main, run

BODY = "n m x y z vx vy vz fx fy fz Kt Lx Ly Lz Ixx Iyy Izz Ixy Iyz Ixz".split()
R, E_STAR, MASS, SPEED = 10.0, 60.0, 500.0, 0.2


def title(words="units=lj interaction=hertz radii=10,10 radius_definition=cut"):
    columns = " ".join(["time", "dt", *(name + body for body in "12" for name in BODY)])
    return f"# mdana-inline 1 {words} bodies=type 1, 2\n# TimeStep {columns}\n"


def hertz(x):
    """4/3 E* sqrt(R*) delta^1.5, R* = R/2."""
    delta = 2 * R - x
    return 4 / 3 * E_STAR * math.sqrt(R / 2) * delta**1.5 if delta > 0 else 0.0


def collision(steps=1200, every=10, dt=0.01):
    """Rows of two spheres that approach each other along x by velocity Verlet; each turns about z with L = 3, I = 20."""
    x, v, rows = 2 * R + 0.5, -SPEED, []
    for step in range(steps + 1):
        if step % every == 0:
            numbers = [step * dt, dt]
            for side in (-1, 1):
                numbers += [500, MASS, side * x / 2, 0, 0, side * v / 2, 0, 0, side * hertz(x), 0, 0,
                            0.7, 0, 0, 3, 20, 20, 20, 0, 0, 0]
            rows.append(f"{step} " + " ".join(f"{number:.17g}" for number in numbers) + "\n")
        v += dt / 2 * hertz(x) / (MASS / 2)
        x += dt * v
        v += dt / 2 * hertz(x) / (MASS / 2)
    return rows


class InlineFile(Case):
    def write(self, text, name="inline.txt"):
        path = self.dir / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def setUp(self):
        super().setUp()
        self.rows = collision()
        self.whole = title() + "".join(self.rows)

    def test_hertz_is_found(self):
        document = self.document("fit-hertz", self.write(self.whole))
        self.assertAlmostEqual(document["E_star"]["value"], E_STAR, delta=1e-6 * E_STAR)
        self.assertAlmostEqual(document["R"]["value"], R, delta=1e-6 * R)

    def test_force_curve(self):
        path = self.write(self.whole)
        table, document = self.table("force", path), self.document("force", path)
        for x, force in zip(table["X"], table["F"]):
            self.assertAlmostEqual(force, hertz(x), delta=1e-13 * max(table["F"]))
        self.assertEqual(document["outcome"], "bounce")
        self.assertAlmostEqual(document["e"]["value"], 1, delta=1e-5)  # of velocity Verlet
        # m* v^2/2 = 8/15 E* sqrt(R*) delta^2.5 at the turn, between samples
        greatest = (15 / 16 * (MASS / 2) * SPEED**2 / (E_STAR * math.sqrt(R / 2)))**0.4
        self.assertAlmostEqual(document["delta_max"]["value"], greatest, delta=2 * document["delta_max"]["error"])
        self.assertEqual(document["force_source"], "forces")
        self.assertEqual(document["inputs"][0]["path"], str(path))

    def test_energies(self):
        table = self.table("energy", self.write(self.whole))
        self.assertEqual(set(table["K_t1"]), {0.7})
        for rotation in table["rotation2"]:
            self.assertAlmostEqual(rotation, 3**2 / (2 * 20), delta=1e-13)
        self.assertAlmostEqual(table["K_p1"][0], MASS * (SPEED / 2)**2 / 2, delta=1e-13)
        self.assertNotIn("W1", table)
        document = self.document("energy", self.write(self.whole))
        self.assertIn("W", [entry["what"] for entry in document["left_out"]])

    def test_units_count(self):
        """LAMMPS writes heat in energy units; of translation and rotation mdana knows mass velocity^2, in units metal 1.0364e-4 eV."""
        metal = self.write(self.whole.replace("units=lj", "units=metal"), "metal.txt")
        table = self.table("energy", metal)
        factor = 1.0364e-4  # (g/mol) (A/ps)^2 in eV
        self.assertAlmostEqual(table["K_t1"][0], 0.7, delta=1e-14)
        self.assertAlmostEqual(table["rotation2"][0], factor * 3**2 / (2 * 20), delta=1e-4 * factor)
        self.assertAlmostEqual(table["K_p1"][0], factor * MASS * (SPEED / 2)**2 / 2, delta=1e-4 * factor * MASS)
        self.assertEqual(self.document("force", metal)["units"], "metal")
        self.refused("force", metal, "--units", "lj", says=["metal", "lj"])

    def test_compressed_and_cut(self):
        packed = self.write(gzip.compress(self.whole.encode()), "inline.txt.gz")
        whole = self.document("force", packed)
        self.assertEqual(whole["F_max"], self.document("force", self.write(self.whole))["F_max"])
        cut = self.write(self.whole[:-30])
        document = self.document("force", cut, code=3)
        self.assertIn("which is left out", " ".join(document["warnings"]))
        self.refused("force", cut, "--strict", says=["which is left out"])

    def test_what_was_settled_is_refused(self):
        path = self.write(self.whole)
        for arguments in (["--bodies", "mol"], ["--masses", "1=2"], ["--timestep", "1"], ["--select", "type:1"]):
            self.refused("force", path, *arguments, says=[arguments[0]])

    def test_faults_name_their_lines(self):
        row = self.rows[5].split()
        for change, says in [(row[:-1], "45"), (row + ["1"], "45"), (["x"] + row[1:], "time step"), (row[:4] + ["nan"] + row[5:], "nan"),
                             (row[:3] + ["0"] + row[4:], "no atoms"), (["1"] + row[1:], "does not come after"),
                             (["#", "mdana-inline"], "second head")]:
            lines = self.whole.splitlines()
            lines[7] = " ".join(change)
            self.refused("force", self.write("\n".join(lines) + "\n"), says=["inline.txt:8: ", says])

    def test_no_bytes_crash_it(self):
        """Cut anywhere, bytes changed anywhere: a result or a word, never a signal."""
        chance = random.Random(7)
        head = len(title())
        for k in range(60):
            data = bytearray((title() + "".join(self.rows[:40])).encode())
            for _ in range(chance.choice((1, 3, 50))):
                data[chance.randrange(head if k % 2 else len(data))] = chance.randrange(256)
            if k % 5 == 0:
                del data[chance.randrange(len(data)):]
            done = run("energy", self.write(bytes(data)), errors="replace")
            self.assertIn(done.returncode, (0, 1, 3), done.stderr)
            if done.returncode == 1:
                self.assertRegex(done.stderr, r"\Amdana: \S")


class Lines(Case):
    def lines(self, *arguments):
        return self.mdana("emit", "--for", "lammps-inline", *arguments).stdout

    def groups(self, text):
        return re.findall(r"(?m)^group +(mdana[12]) (.*)$", text)

    def test_bodies(self):
        self.assertEqual(self.groups(self.lines(SAMPLE)), [("mdana1", "type 1"), ("mdana2", "type 2")])
        self.assertEqual(self.groups(self.lines(SAMPLE, "--bodies", "id:1-603")), [("mdana1", "id 1:603"), ("mdana2", "id 604:1206")])
        pair = dumps.two_cubes(0, 0.0, 12.0)
        path = self.dir / "pair.lammpstrj"
        path.write_text(pair.text())
        groups = self.groups(self.lines(path, "--bodies", "clusters"))
        self.assertEqual([(name, words.split()[0]) for name, words in groups], [("mdana1", "id"), ("mdana2", "id")])

    def test_what_the_head_states(self):
        text = self.lines(SAMPLE, "--every", 7, "--file", "out/near.txt")
        self.assertIn('title1 "# mdana-inline 1 units=lj interaction=adhesive radii=5,5 radius_definition=cut bodies=type 1, 2"', text)
        self.assertIn("variable        mdana_every index 7\n", text)
        self.assertIn("file out/near.txt format", text)
        self.assertIn("radii=5.5,6 ", self.lines(SAMPLE, "--radius", "5.5,6"))

    def test_potential(self):
        self.assertIn("pe/atom", self.lines(SAMPLE))
        self.assertNotIn("pe/atom", self.lines(SAMPLE, "--no-potential"))
        self.assertNotIn("W1", self.lines(SAMPLE, "--no-potential"))
        aggregate = running.ROOT / "sample-data" / "aggregate-tiny" / "dump.lammpstrj.gz"
        self.assertNotIn("pe/atom", self.lines(aggregate))  # pair granular has no energies of atoms


if __name__ == "__main__":
    main()
