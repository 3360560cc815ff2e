# SPDX-License-Identifier: GPL-3.0-or-later
"""mdana defects: the document's names, the tables, the dump with labels, and input that has no defects to find."""

import math

import dumps
import running
from running import SAMPLE, Case, read_csv

COUNTS = ["fcc", "hcp", "other", "surface", "contact", "bulk_defect"]


def fcc(radius, edge=1.5429, centre=(0, 0, 0)):
    """Atoms of a ball of fcc."""
    n = int(radius / edge) + 2
    basis = [(0, 0, 0), (0.5, 0.5, 0), (0.5, 0, 0.5), (0, 0.5, 0.5)]
    places = [tuple(edge * (c + b) for c, b in zip(cell, offset)) for offset in basis
              for cell in ((i, j, k) for i in range(-n, n) for j in range(-n, n) for k in range(-n, n))]
    return [tuple(a + b for a, b in zip(p, centre)) for p in places if math.dist(p, (0, 0, 0)) < radius]


def dump_of(frames, bounds="ff ff ff\n-50 50\n-50 50\n-50 50"):
    """Text of a dump: each frame a list of bodies, each a list of places."""
    text = "ITEM: UNITS\nlj\n"
    for step, bodies in enumerate(frames):
        atoms = [(t + 1, p) for t, body in enumerate(bodies) for p in body]
        text += f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(atoms)}\nITEM: BOX BOUNDS {bounds}\n"
        text += "ITEM: ATOMS id type x y z\n"
        text += "".join(f"{k + 1} {t} {x!r} {y!r} {z!r}\n" for k, (t, (x, y, z)) in enumerate(atoms))
    return text


class Defects(Case):
    def write(self, text):
        path = self.dir / "made.dump"
        path.write_text(text, encoding="utf-8")
        return path

    def test_document(self):
        document = self.document("defects", SAMPLE)
        frames = document["frames"]
        self.assertEqual(len(frames), 47)
        for frame in frames:
            self.assertEqual(list(frame["counts"]), COUNTS)
            counts = frame["counts"]
            self.assertEqual(counts["fcc"] + counts["hcp"] + counts["other"], 1206)
            self.assertEqual(counts["surface"] + counts["contact"] + counts["bulk_defect"], counts["other"])
            for area in (frame["fault_area"], frame["twin_area"]):
                self.assertGreaterEqual(area["value"], 0)
            for kinds, area in ((["intrinsic", "extrinsic"], "fault_area"), (["twin"], "twin_area")):
                of_planes = sum(p["area"]["value"] for p in frame["planes"] if p["kind"] in kinds)
                self.assertAlmostEqual(of_planes, frame[area]["value"], 6)
            self.assert_surface(frame["surface"], counts["surface"])
        self.assertLess(frames[0]["counts"]["contact"], 10)  # about to touch
        self.assertGreater(max(f["counts"]["contact"] for f in frames), 50)
        bare = self.document("defects", SAMPLE, "--frames", ":1", "--no-surface")
        self.assertIn("surface", [entry["what"] for entry in bare["left_out"]])
        self.assertEqual(bare["frames"], [frames[0] | {"surface": None, "patch_area": None}])

    def test_pictures(self):
        """The surfaces that VTK reads enclose the volume that is told, and the discs have the planes' areas."""
        try:
            import vtk
        except ImportError:
            self.skipTest("no vtk (Debian: apt install python3-vtk9)")
        document = self.document("defects", SAMPLE, "--frames", "last", "--vtp", self.dir / "last")
        frame = document["frames"][0]

        def read(what):
            reader = vtk.vtkXMLPolyDataReader()
            reader.SetFileName(str(self.dir / f"last.{what}.{frame['step']}.vtp"))
            reader.Update()
            return reader.GetOutput()

        surfaces, faults = read("surfaces"), read("faults")
        bodies = surfaces.GetCellData().GetArray("body")
        self.assertEqual({bodies.GetValue(i) for i in range(surfaces.GetNumberOfCells())}, {1, 2})
        triangles = vtk.vtkTriangleFilter()
        triangles.SetInputData(surfaces)
        mass = vtk.vtkMassProperties()
        mass.SetInputConnection(triangles.GetOutputPort())
        self.assertAlmostEqual(mass.GetSurfaceArea() / frame["surface"]["area"]["value"], 1, 6)
        self.assertEqual(faults.GetNumberOfCells(), len(frame["planes"]))
        for i, plane in enumerate(frame["planes"]):
            self.assertAlmostEqual(faults.GetCell(i).GetNumberOfPoints(), 32)
            self.assertAlmostEqual(faults.GetCellData().GetArray("area").GetValue(i), plane["area"]["value"], 6)

    def assert_surface(self, surface, atoms):
        for part in ("area", "volume"):
            for number in ("value", "error"):
                self.assertAlmostEqual(surface[part][number], sum(b[part][number] for b in surface["bodies"]), 6)
            self.assertLess(surface[part]["error"], 0.1 * surface[part]["value"])
        self.assertGreater(surface["radius"]["error"], 0.1 * 1.09)  # half a layer, and what the volume does
        self.assertAlmostEqual(surface["radius"]["value"], 5, delta=0.2)  # as the balls were cut
        self.assertLess(0.5 * atoms, surface["area"]["value"])  # an atom covers 0.87 spacings^2 of 1.1 at least
        self.assertEqual([b["voids"] for b in surface["bodies"]], [0, 0])

    def test_threads_and_order_change_nothing(self):
        def numbers(*more):
            return self.document("defects", SAMPLE, "--frames", "::9", *more)["frames"]

        self.assertEqual(numbers("--threads", "1"), numbers("--threads", "3"))
        shuffled = self.dir / "shuffled.lammpstrj"
        self.mdana("convert", SAMPLE, "-o", shuffled, "--sort", "type", "--stride", "9")
        self.assertEqual(numbers(), self.document("defects", shuffled, "--timestep", "0.0078125", "--radius", "5")["frames"])

    def test_cgal_gives_the_same(self):
        plain, tree = (self.document("defects", SAMPLE, "--frames", "20:22", "--neighbours", how)["frames"]
                       for how in ("cells", "cgal"))
        self.assertEqual(plain, tree)

    def test_slabs_change_nothing(self):
        """Frames in pieces as small as can be, from temporary files: the same document, table and dump to the byte."""
        texts = []
        for memory in ("1G", "1K"):
            out, csv = self.dir / f"{memory}.lammpstrj", self.dir / f"{memory}.csv"
            frames = self.document("defects", SAMPLE, "--frames", "::15", "--memory", memory, "--dump", out, "--csp", "-o", csv,
                                   "--threads", "2")["frames"]
            texts.append((frames, out.read_bytes(), csv.read_bytes()))
        self.assertEqual(*texts)

    def test_a_full_disk_is_told(self):
        import resource
        import signal

        def little_space():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))

        done = running.run("defects", SAMPLE, "--memory", "1K", "--frames", ":1", preexec_fn=little_space)
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot write a temporary file", done.stderr)
        self.assertIn("TMPDIR", done.stderr)

    def test_tables(self):
        table = self.table("defects", SAMPLE, "--stride", "10")
        frames = self.document("defects", SAMPLE, "--stride", "10")["frames"]
        self.assertEqual(table["fcc"], [f["counts"]["fcc"] for f in frames])
        self.assertEqual(table["delta"], [f["delta"] for f in frames])
        self.assertEqual(table["lattice_turned1"][0], 0)
        self.mdana("defects", SAMPLE, "--stride", "10", "-o", self.dir / "out.h5")

    def test_last_frame(self):
        last = self.document("defects", SAMPLE, "--frames", "last")["frames"]
        every = self.document("defects", SAMPLE, "--frames", "all")["frames"]
        self.assertEqual(len(last), 1)
        self.assertEqual(last[0]["counts"], every[-1]["counts"])
        self.mdana("defects", SAMPLE, "--frames", "last", "--stride", "2", code=2)

    def test_dump_with_labels(self):
        out = self.dir / "labels.lammpstrj"
        frames = self.document("defects", SAMPLE, "--stride", "20", "--dump", out, "--csp", "--coordination")["frames"]
        written = dumps.read(out)
        self.assertEqual(len(written), len(frames))
        for frame, atoms in zip(frames, written):
            structure, site = atoms["c_mdana_structure c_mdana_site"].T
            margin, cluster = atoms["c_mdana_margin c_mdana_cluster"].T
            self.assertEqual([sum(structure == k) for k in (1, 2)], [frame["counts"][c] for c in ("fcc", "hcp")])
            self.assertEqual([sum(site == k) for k in (1, 2, 3)], [frame["counts"][c] for c in COUNTS[3:]])
            self.assertTrue(all((margin >= 0) & (margin <= 1)))
            self.assertTrue(all((cluster > 0) == (structure == 1)))
            self.assertEqual(list(atoms["id"][:, 0]), list(range(1, 1207)))
            coordination = atoms["c_mdana_coordination"][:, 0]
            self.assertGreater(sum(coordination[structure == 1] == 12), 0.8 * sum(structure == 1))

    def test_dump_opens_in_ase(self):
        try:
            import ase.io
        except ImportError:
            self.skipTest("no ase")
        out = self.dir / "labels.lammpstrj"
        self.mdana("defects", SAMPLE, "--frames", "last", "--dump", out)
        atoms = ase.io.read(out, format="lammps-dump-text")
        self.assertEqual(set(atoms.arrays["c_mdana_structure"].flat) <= {0, 1, 2}, True)

    def test_first_defect_and_separation(self):
        ball = fcc(5)
        hurt = [p for p in ball if math.dist(p, (0, 0, 0)) > 0.1]  # a vacancy: 12 atoms
        apart = [(x + 12, y, z) for x, y, z in ball]
        near = [(x + 10.1, y, z) for x, y, z in ball]
        path = self.write(dump_of([[ball, apart], [ball, near], [hurt, near], [hurt, apart]]))
        document = self.document("defects", path)
        self.assertEqual(document["first_defect"]["step"], 2)
        self.assertEqual(document["at_separation"]["step"], 3)
        self.assertEqual(document["at_separation"]["counts"]["bulk_defect"], 12)
        text = self.mdana("defects", path).stdout
        self.assertRegex(text, r"first defect +step 2.*12 atoms about \(")
        self.assertRegex(text, r"at separation +step 3.*12 bulk defects")
        self.assertRegex(text, r"in time +step +delta +hcp +bulk +faults +twins +surface +patch +areas in σ\^2\n +0 .* 0\n +1 ")
        self.assertIn("in contact in the last frame", self.mdana("defects", path, "--frames", ":3").stdout)

    def test_one_body(self):
        document = self.document("defects", self.write(dump_of([[fcc(6)]])), "--bodies", "type")
        self.assertNotIn("delta", document["frames"][0])
        self.assertGreater(document["frames"][0]["counts"]["fcc"], 300)

    def test_input_without_a_crystal(self):
        sheet = [(x, y, 0.0) for x, y, z in fcc(8) if abs(z) < 0.1]
        for atoms, says in ((sheet, "a sheet"), ([(k * 1.0, 0.0, 0.0) for k in range(4)], "too small")):
            with self.subTest(says):
                document = self.document("defects", self.write(dump_of([[atoms]])), "--bodies", "type")
                self.assertTrue(any(says in w for w in document["warnings"]), document["warnings"])

    def test_bcc_is_told(self):
        edge, n = 1.3, 6
        atoms = [(edge * (i + b), edge * (j + b), edge * (k + b)) for i in range(n) for j in range(n) for k in range(n)
                 for b in (0, 0.5)]
        document = self.document("defects", self.write(dump_of([[atoms]])), "--bodies", "type")
        self.assertTrue(any("bcc" in w for w in document["warnings"]), document["warnings"])

    def test_amorphous_bodies_are_told(self):
        import random

        random.seed(1)
        atoms = [tuple(c + random.gauss(0, 0.14) for c in p) for p in fcc(6)]
        document = self.document("defects", self.write(dump_of([[atoms]])), "--bodies", "type")
        self.assertTrue(any("amorphous" in w for w in document["warnings"]), document["warnings"])

    def test_impossible_input(self):
        ball = fcc(4)
        for atoms, bounds, says in (
                (ball[:1], "ff ff ff", "fewer than two"), (ball + ball[-1:], "ff ff ff", "same place"),
                (ball[:-1] + [(math.nan, 0.0, 0.0)], "ff ff ff", "not finite")):
            with self.subTest(says):
                path = self.write(dump_of([[atoms]], bounds + "\n-50 50" * 3))
                self.refused("defects", path, "--bodies", "type", says=[says])
        path = self.write(dump_of([[fcc(6)]], "ff pp ff\n-50 50\n-6 6\n-50 50"))
        self.refused("defects", path, "--bodies", "type", says=["periodic"])

    def test_usage(self):
        for arguments in (["--csp"], ["--label", "fcc"], ["--neighbours", "list"], ["--spacing", "0"],
                          ["--memory", "0"], ["--memory", "5X"], ["--memory", "-1"], ["--memory", "9999999G"],
                          ["--dump", self.dir / "x.unknown"]):
            with self.subTest(arguments):
                self.mdana("defects", SAMPLE, *arguments, code=2)


if __name__ == "__main__":
    running.main()
