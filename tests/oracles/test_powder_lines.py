# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of `mdana emit --for lammps`, run by LAMMPS, against the law that they stand for."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
import running  # noqa: E402
from running import Case  # noqa: E402

SCENE = """units lj
atom_style sphere
atom_modify map array
comm_modify vel yes
newton off
region box block -500 500 -500 500 -500 500
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
thermo_modify format float %.12g
run 20000
"""


class Lammps(Case):
    def test_restitution_of_viscous_spheres(self):
        """eta_n0 a m* v is 2 T E*/nu^2 a v: LAMMPS finds the e of viscous-hertz. To 1e-5: the time step is 1e-4 of
        the contact's."""
        mass, radius = 14434147, 147
        fit = self.dir / "fit.json"
        fit.write_text(json.dumps({"command": "fit-contact", "law": "viscous-hertz", "usable": True, "reason": "",
                                   "parameters": {"T_vis": {"value": 0.0746, "error": 0.001, "interval": None}},
                                   "constants": {"E": 65.5, "nu": 0.25, "m": mass, "R": radius},
                                   "range": {"v": [0.05, 0.2]}}))
        lines = self.dir / "contact.in"
        self.mdana("emit", "--for", "lammps", fit, "-o", lines)
        scene = self.dir / "scene.in"
        density = mass / (4 / 3 * 3.141592653589793 * radius**3)
        scene.write_text(SCENE.format(density=density, lines=lines))
        done = subprocess.run(["lmp", "-in", scene, "-log", "none"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        after = next(float(line.split()[1]) for line in done.stdout.splitlines() if line.split()[:1] == ["20000"])
        parameters = {"R": radius, "m": mass, "E": 65.5, "nu": 0.25, "T_vis": 0.0746, "v": 0.1}
        wanted = self.document("predict", "--law", "viscous-hertz",
                               *[word for name, x in parameters.items() for word in ("-p", f"{name}={x}")])["e"]
        self.assertLess(wanted, 0.98)
        self.assertAlmostEqual(after / 0.1, wanted, delta=1e-5)


if __name__ == "__main__":
    if not shutil.which("lmp"):
        running.skip("there is no LAMMPS (lmp)")
    running.main()
