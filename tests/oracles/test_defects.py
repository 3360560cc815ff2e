# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures and centro-symmetry of the sample's atoms against LAMMPS' compute cna/atom and centro/atom, and against
an adaptive common neighbour analysis written here after Stukowski (2012). LAMMPS' cutoff is fixed: every atom that it
labels otherwise must be one whose bonds the local cutoff changes, or one that the repair has changed."""

import subprocess

from lammps import need_lammps, np, running
from running import SAMPLE, Case

try:
    from scipy.spatial import cKDTree
except ImportError:
    running.skip("no scipy (Debian: apt install python3-scipy)")

FRAMES = (0, 20, 46)
LATTICE = 1.5429  # edge of the cube of Lennard-Jones fcc [sigma]
CUTOFF = 0.8536 * LATTICE  # as LAMMPS' manual has it for fcc: between the first shell and the second
OTHER, FCC, HCP = 0, 1, 2

INPUT = """units lj
atom_style atomic
boundary s s s
read_data {data}
pair_style zero 2.5 nocoeff
pair_coeff * *
mass * 1
comm_modify cutoff 3
compute cna all cna/atom {cutoff}
compute csp all centro/atom fcc
dump out all custom 1 {out} id c_cna c_csp
dump_modify out sort id format float %.10g
run 0 post no
"""


def read(path):
    """Frames of a text dump: names of the columns, rows sorted by id."""
    frames, lines = [], path.read_text().splitlines()
    for k, line in enumerate(lines):
        if line.startswith("ITEM: NUMBER OF ATOMS"):
            count = int(lines[k + 1])
        if line.startswith("ITEM: ATOMS"):
            rows = np.array([[float(w) for w in row.split()] for row in lines[k + 1:k + 1 + count]])
            frames.append(dict(zip(line.split()[2:], rows[np.argsort(rows[:, 0])].T)))
    return frames


def lammps(positions, directory):
    """c_cna and c_csp of LAMMPS."""
    low, high = positions.min(axis=0) - 1, positions.max(axis=0) + 1
    data = directory / "atoms.data"
    lines = ["atoms", "", f"{len(positions)} atoms", "1 atom types", ""]
    lines += [f"{a} {b} {n}lo {n}hi" for a, b, n in zip(low, high, "xyz")] + ["", "Atoms", ""]
    lines += [f"{k + 1} 1 {x:.10g} {y:.10g} {z:.10g}" for k, (x, y, z) in enumerate(positions)]
    data.write_text("\n".join(lines) + "\n")
    script = directory / "in.lmp"
    script.write_text(INPUT.format(data=data, out=directory / "out.dump", cutoff=CUTOFF))
    subprocess.run(["lmp", "-in", script, "-log", "none"], cwd=directory, check=True, capture_output=True, timeout=120)
    return read(directory / "out.dump")[0]


def longest(bonds):
    """Atoms of the bonds' longest chain, counted in bonds."""
    best = 0

    def walk(at, left):
        nonlocal best
        best = max(best, len(bonds) - len(left))
        for bond in left:
            if at in bond:
                walk(bond[0] if bond[1] == at else bond[1], [b for b in left if b != bond])

    for bond in bonds:
        for end in bond:
            walk(end, list(bonds))
    return best


def structure(vectors, cutoff):
    """Signatures of Honeycutt & Andersen (1987) of the 12 nearest, with a cutoff."""
    bonded = np.linalg.norm(vectors[:, None] - vectors[None], axis=2) < cutoff
    np.fill_diagonal(bonded, False)
    found = []
    for k in range(12):
        common = np.flatnonzero(bonded[k])
        bonds = [(a, b) for a in common for b in common if a < b and bonded[a, b]]
        found.append((len(common), len(bonds), longest(bonds) if len(bonds) <= 4 else 9))
    if found.count((4, 2, 1)) == 12:
        return FCC
    return HCP if found.count((4, 2, 1)) == 6 and found.count((4, 2, 2)) == 6 else OTHER


class Defects(Case):
    def setUp(self):
        super().setUp()
        need_lammps()
        self.out = self.dir / "labels.lammpstrj"
        frames = [self.document("defects", SAMPLE, "--frames", f"{k}:{k + 1}", "--dump", self.out.with_suffix(f".{k}.dump"),
                                "--csp")["frames"][0] for k in FRAMES]
        self.frames = list(zip(frames, [read(self.out.with_suffix(f".{k}.dump"))[0] for k in FRAMES]))

    def test_structures_and_centro_symmetry(self):
        compared = differing = 0
        for frame, ours in self.frames:
            positions = np.column_stack([ours[c] for c in "xyz"])
            theirs = lammps(positions, self.dir)
            distances, nearest = cKDTree(positions).query(positions, 14)
            repaired = 0
            for i, own in enumerate(ours["c_mdana_structure"]):
                vectors = positions[nearest[i, 1:13]] - positions[i]
                adaptive = structure(vectors, (1 + np.sqrt(2)) / 2 * distances[i, 1:13].mean())
                if own != adaptive:
                    self.assertEqual(adaptive, OTHER, "only what has no structure is repaired")
                    repaired += 1
                label = {1: FCC, 2: HCP}.get(int(theirs["c_cna"][i]), OTHER)
                compared += 1
                if label in (own, adaptive):
                    continue
                differing += 1  # then LAMMPS' own cutoff, on its own neighbours, must say so
                within = np.count_nonzero(distances[i, 1:] < CUTOFF) == 12
                with_theirs = structure(vectors, CUTOFF) if within else OTHER
                self.assertEqual(label, with_theirs)
            self.assertEqual(repaired, frame["repaired"])
            self.assert_centro_symmetry(ours, theirs, distances)
        print(f"{compared} atoms, {differing} differ by LAMMPS' fixed cutoff")
        self.assertLess(differing, 0.05 * compared)

    def assert_centro_symmetry(self, ours, theirs, distances):
        known = distances[:, 12] < 1.4 * LATTICE / np.sqrt(2)
        self.assertGreater(np.count_nonzero(known), 0.5 * len(known))
        difference = np.abs(ours["c_mdana_csp"] - theirs["c_csp"])[known]
        self.assertLess(difference.max(), 2e-5)


if __name__ == "__main__":
    running.main()
