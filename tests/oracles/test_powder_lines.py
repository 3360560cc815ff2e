# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of `mdana emit`, run by LAMMPS, LIGGGHTS and Yade (the latter two if they are there), against the law
that they stand for."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
import running  # noqa: E402
from running import Case  # noqa: E402

# Two spheres that meet, for LAMMPS and LIGGGHTS; `head` and `tail` are what differs.
SCENE = """{head}
atom_modify map array
newton off
region box block -500 500 -500 500 -500 500 units box
create_box 1 box
create_atoms 1 single -147.5 0 0
create_atoms 1 single 147.5 0 0
set group all diameter 294
set group all density {density!r}
include {lines}
group right id 2
velocity all set 0.05 0 0
velocity right set -0.05 0 0
timestep 0.02
fix move all nve/sphere
thermo 20000
variable relative equal vx[2]-vx[1]
thermo_style custom step v_relative
thermo_modify format float %.12g {tail}
run 20000
"""
LAMMPS = {"head": "units lj\natom_style sphere\ncomm_modify vel yes", "tail": ""}
LIGGGHTS = {"head": "atom_style granular\nboundary f f f\ncommunicate single vel yes\nunits lj\nhard_particles yes\n"
                    "neighbor 20 bin\nneigh_modify delay 0", "tail": "norm no"}

YADE = """import os
from yade import *
{lines}
loop = {loop}
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]), loop, NewtonIntegrator(damping=0)]
for x, v in ((-147.5, 0.05), (147.5, -0.05)):
    body = sphere((x, 0, 0), 147)
    O.bodies.append(body)
    body.state.vel = (v, 0, 0)
O.dt = 0.02
O.run(20000, True)
print('RELATIVE', O.bodies[1].state.vel[0] - O.bodies[0].state.vel[0])
sys.stdout.flush()
os._exit(0)
"""

MASS, RADIUS = 14434147, 147
DENSITY = MASS / (4 / 3 * 3.141592653589793 * RADIUS**3)


class Viscous(Case):
    """The restitution of viscous-hertz in each code, by its lines."""

    def lines(self, code, relaxation=0.0746):
        fit = self.dir / "fit.json"
        fit.write_text(json.dumps({"command": "fit-contact", "law": "viscous-hertz", "usable": True, "reason": "",
                                   "parameters": {"T_vis": {"value": relaxation, "error": 0.001, "interval": None}},
                                   "constants": {"E": 65.5, "nu": 0.25, "m": MASS, "R": RADIUS},
                                   "range": {"v": [0.05, 0.2]}}))
        lines = self.dir / "contact.in"
        self.mdana("emit", "--for", code, fit, "-p", "v=0.1", "-o", lines)
        return lines

    def wanted(self, relaxation=0.0746):
        parameters = {"R": RADIUS, "m": MASS, "E": 65.5, "nu": 0.25, "T_vis": relaxation, "v": 0.1}
        return self.document("predict", "--law", "viscous-hertz",
                             *[word for name, x in parameters.items() for word in ("-p", f"{name}={x}")])["e"]

    def run_lines(self, program, scene):
        """The relative velocity at step 20000."""
        path = self.dir / "scene.in"
        path.write_text(scene)
        done = subprocess.run([program, "-in", path, "-log", "none"], capture_output=True, text=True, check=False,
                              cwd=self.dir)
        self.assertEqual(done.returncode, 0, done.stdout)
        return next(float(line.split()[1]) for line in done.stdout.splitlines() if line.split()[:1] == ["20000"])

    def test_lammps(self):
        """eta_n0 a m* v is 2 T E*/nu^2 a v. To 1e-5: the time step is 1e-4 of the contact's."""
        after = self.run_lines("lmp", SCENE.format(density=DENSITY, lines=self.lines("lammps"), **LAMMPS))
        self.assertLess(self.wanted(), 0.98)
        self.assertAlmostEqual(after / 0.1, self.wanted(), delta=1e-5)

    def test_liggghts(self):
        if not shutil.which("liggghts"):
            self.skipTest("there is no LIGGGHTS (liggghts)")
        lines = self.lines("liggghts")
        after = self.run_lines("liggghts", SCENE.format(density=DENSITY, lines=lines, **LIGGGHTS))
        self.assertAlmostEqual(after / 0.1, self.wanted(), delta=1e-5)
        self.assertIn("hard_particles yes", lines.read_text())

    def yade(self, relaxation):
        """Relative velocity, over that before, and the lines."""
        lines = self.lines("yade", relaxation).read_text()
        head, loop = lines.split("InteractionLoop")
        path = self.dir / "scene.py"
        path.write_text(YADE.format(lines=head, loop="InteractionLoop" + loop))
        done = subprocess.run(["yade", "-n", "-x", "-j1", path], capture_output=True, text=True, check=False,
                              cwd=self.dir, timeout=200)
        return next(float(line.split()[1]) for line in done.stdout.splitlines() if line.startswith("RELATIVE")) / 0.1, lines

    def test_yade(self):
        """Its formula for the damping is its own: 1e-4 of en at 0.8; near 1 it is off, which the lines say."""
        if not shutil.which("yade"):
            self.skipTest("there is no Yade (yade)")
        after, lines = self.yade(0.5)
        self.assertAlmostEqual(after, self.wanted(0.5), delta=2e-4)
        self.assertNotIn("near 1", lines)
        after, lines = self.yade(0.0746)
        self.assertAlmostEqual(after, self.wanted(), delta=0.01)
        self.assertIn("near 1", lines)


if __name__ == "__main__":
    if not shutil.which("lmp"):
        running.skip("there is no LAMMPS (lmp)")
    running.main()
