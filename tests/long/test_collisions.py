#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Real collisions of spheres of radius 10, made by LAMMPS: the energy is all accounted for, the loop area is the
kinetic energy lost, and e is that of LAMMPS' own velocities, each within the error that mdana states.

With MDANA_LONG_RUNS=DIR the runs are kept in DIR, and taken from there if they are there."""

import concurrent.futures
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "oracles"))

import numpy as np

import lammps
import running

COLUMNS = "id type x y z vx vy vz fx fy fz c_pe"
ADHESIVE = ["adhesive", "--preset", "small"]
RUNS = {
    "a01": [*ADHESIVE, "--velocity", "0.1"],
    "a02": [*ADHESIVE, "--velocity", "0.2"],
    "a05": [*ADHESIVE, "--velocity", "0.5"],
    "bounce": ["adhesive", "--attraction", "0.4", "--radius", "10", "--velocity", "0.5"],
    "hertz_small": ["hertz", "--preset", "small", "--velocity", "0.3"],
}
STICKING, BOUNCING = ("a01", "a02", "a05"), ("bounce", "hertz_small")

# LAMMPS reads the dump again and computes the bodies' centres and velocities itself.
RERUN = """
units lj
boundary f f f
region box block -200 200 -200 200 -200 200
create_box 2 box
mass * 1.0
pair_style zero 5.0 nocoeff
pair_coeff * *
read_dump {dump} 0 x y z vx vy vz add yes box no replace no
compute bodies all chunk/atom type
compute com all com/chunk bodies
compute vcm all vcm/chunk bodies
fix out all ave/time 1 1 1 c_com[*] c_vcm[*] mode vector file motion.txt format " %.15g"
thermo 1000000
rerun {dump} dump x y z vx vy vz box no
"""


def make(folder, name):
    """The run, unless it is there already; at most two at a time."""
    if not (folder / name / "scene.toml").is_file():
        lammps.generate(*RUNS[name], "--columns", COLUMNS, "-o", folder / name, timeout=3600)
    return folder / name


def rerun(dump, folder):
    """Relative position and velocity of the bodies in each frame, by LAMMPS."""
    (folder / "rerun.lmp").write_text(RERUN.format(dump=dump))
    done = subprocess.run(["lmp", "-in", "rerun.lmp", "-log", "rerun.log"], cwd=folder, capture_output=True, text=True,
                          timeout=600, check=False)
    if done.returncode:
        raise AssertionError(done.stdout[-2000:])
    motion = lammps.vectors(folder / "motion.txt")
    table = np.array([motion[step][1] - motion[step][0] for step in sorted(motion)])
    return table[:, :3], table[:, 3:]


def logged(path, name):
    """A column of the last runs of the log, by the step."""
    head, rows = None, {}
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["Step"]:
            head, steps = words, None
        elif head and len(words) == len(head) and words[0].isdigit():
            step = int(words[0])
            if steps is None and step == 0:
                rows = {}
            steps = step
            rows[step] = float(words[head.index(name)])
    return rows


class Collisions(running.Case):
    @classmethod
    def setUpClass(cls):
        cls.folder = lammps.kept_runs(cls)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            list(pool.map(lambda name: make(cls.folder, name), RUNS))
        cls.documents = {}
        for name in RUNS:
            done = running.run("collision", cls.dump(name), "--json", timeout=300)
            if done.returncode:
                raise AssertionError(done.stderr)
            cls.documents[name] = running.parse_json(done.stdout)

    @classmethod
    def dump(cls, name):
        return cls.folder / name / "dump.lammpstrj.gz"

    def each(self, names=tuple(RUNS)):
        return [(name, self.documents[name]) for name in names]

    def within(self, found, wanted, error, what):
        print(f"{what}: {found:.6g}, wanted {wanted:.6g}, error {error:.2g}")
        self.assertLessEqual(abs(found - wanted), error, what)

    def test_outcomes(self):
        for name, document in self.each():
            self.assertEqual(document["outcome"], "stick" if name in STICKING else "bounce")

    def test_energy_closes_to_the_drift_of_the_run(self):
        """What is missing of K_p + K_t + W between the windows is what LAMMPS' own total energy changes between them.
        The log has 12 digits of 1e5."""
        for name, document in self.each():
            energy, total = document["energy"], logged(self.folder / name / "log.lammps", "TotEng")
            series = np.array([total[step] for step in self.steps(name)])
            (a, b), (c, d) = energy["frames_before"], energy["frames_after"]
            drift = series[c:d + 1].mean() - series[a:b + 1].mean()
            lost = sum(document[f"delta_{part}"]["value"] for part in ("K_p", "K_t", "W"))
            self.within(lost, drift, 1e-5 * energy["K_p_initial"]["value"], f"{name}: change of energy")

    def steps(self, name):
        out = self.dir / f"{name}.csv"
        self.mdana("energy", self.dump(name), "-o", out, timeout=300)
        return [int(step) for step in running.read_csv(out)["step"]]

    def test_loop_area_is_the_kinetic_energy_lost(self):
        """The first loop within twice the errors, of the others and all together within three times."""
        for name, document in self.each():
            loops = [("first", document, 2), *((k, loop, 3) for k, loop in enumerate(document["loops"])),
                     ("all", document["all_loops"], 3)]
            for what, loop, times in loops:
                area, loss = loop["hysteresis_area"], loop["kinetic_loss"]
                error = times * np.hypot(area["error"], loss["error"])
                self.within(area["value"], loss["value"], error, f"{name}, {what} loop")
            area = document["hysteresis_area"]
            self.assertLess(area["error"], 0.15 * area["value"])
            self.assertEqual([w for w in document["warnings"] if "loop area" in w], [])

    def test_all_is_converted_where_the_bodies_stick(self):
        """But for what still rings, which is part of the error."""
        for name, document in self.each(STICKING):
            energy, converted = document["energy"], document["energy"]["converted"]
            self.within(converted["value"], 1, converted["error"], f"{name}: converted")
            self.assertLess(converted["error"], 0.2)
            parts = (converted["value"] - document["energy_drift"]["value"]
                     + energy["ringing"]["value"])
            self.within(parts, 1, 1e-3, f"{name}: converted, drift, ringing")

    def test_restitution_is_that_of_lammps_own_velocities(self):
        for name, document in self.each(BOUNCING):
            position, velocity = rerun(self.dump(name), self.dir)
            line = position[np.argmin(np.linalg.norm(position, axis=1))]
            line = line / np.linalg.norm(line)
            before, after = velocity[0], velocity[-1]
            for what, wanted in (("e", -after @ line / (before @ line)),
                                 ("e_total", np.linalg.norm(after) / np.linalg.norm(before))):
                self.within(document[what]["value"], wanted, document[what]["error"], f"{name}: {what}")
                self.assertLess(document[what]["error"], 0.01)

    def test_what_is_converted_is_one_less_e_squared(self):
        """e of the whole relative motion: the Hertz spheres glance off each other."""
        for name, document in self.each(BOUNCING):
            e, converted = document["e_total"], document["energy"]["converted"]
            error = np.hypot(2 * e["value"] * e["error"], converted["error"])
            self.within(converted["value"], 1 - e["value"]**2, error, f"{name}: converted")
            self.assertGreater(converted["value"], 0.05)
            self.assertLess(error, 0.01)


if __name__ == "__main__":
    lammps.need_lammps()
    running.main()
