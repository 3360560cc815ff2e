# SPDX-License-Identifier: GPL-3.0-or-later
"""H5MD files that h5py wrote, read by mdana: against the same atoms in a text dump with 17 digits the tables must be the
same bytes."""

import gzip
import subprocess
import sys
import warnings
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
import dumps  # noqa: E402
import running  # noqa: E402
from running import SAMPLE  # noqa: E402

STATED = ("--masses", "1=1,2=1", "--radius", "5", "--bodies", "type", "--units", "lj")
FORCE = ("force", *STATED, "--source", "velocities")


def h5md(path, name="all"):
    """A new file with an empty group of particles in a box that is not periodic."""
    file = h5py.File(path, "w")
    file.create_group("h5md").attrs["version"] = np.array([1, 1], dtype=np.int32)
    box = file.create_group(f"particles/{name}/box")
    box.attrs["dimension"] = 3
    box.attrs["boundary"] = np.array([b"none"] * 3)
    box["edges"] = [100.0, 100.0, 100.0]
    box["origin"] = [-50.0, -50.0, -50.0]
    return file, file[f"particles/{name}"]


def element(particles, name, values, steps, times, **settings):
    group = particles.create_group(name)
    group["step"], group["time"] = steps, times
    group.create_dataset("value", data=values, **settings)
    return group


class H5md(running.Case):
    @classmethod
    def setUpClass(cls):
        cls.frames = dumps.read(SAMPLE)
        cls.frames = [frame.without() for frame in cls.frames]
        for frame in cls.frames:  # the same order in all frames
            frame.atoms = frame.atoms[np.argsort(frame["id"][:, 0])]
        cls.steps = np.array([frame.step for frame in cls.frames])
        cls.times = np.array([frame.time for frame in cls.frames])

    def values(self, names, dtype=float):
        return np.array([frame[names] for frame in self.frames]).astype(dtype)

    def text_table(self):
        return self.bytes_of(dumps.write(self.dir / "text.dump", self.frames))

    def bytes_of(self, dump, *options, code=0):
        out = self.dir / "table.csv"
        out.unlink(missing_ok=True)
        self.mdana(*FORCE, dump, *options, "-o", out, code=code)
        return out.read_bytes()

    def write(self, path, real="<f8", whole="<i8", steps=None, times=None, **settings):
        steps = self.steps if steps is None else steps
        times = self.times if times is None else times
        file, particles = h5md(path)
        with file:
            element(particles, "position", self.values("x y z").astype(real), steps, times, **settings)
            element(particles, "velocity", self.values("vx vy vz").astype(real), steps, times, **settings)
            particles["species"] = self.values("type")[0, :, 0].astype(whole)
            particles["id"] = self.values("id")[0, :, 0].astype(whole)
        return path

    def test_kinds_of_numbers(self):
        wanted = self.text_table()
        self.assertGreater(wanted.count(b"\n"), 40)
        for real, whole in (("<f8", "<i8"), (">f8", ">i4"), ("<f8", "<u2"), (">f8", ">u8")):
            self.assertEqual(self.bytes_of(self.write(self.dir / "a.h5", real, whole)), wanted, f"{real} {whole}")

    def test_float32(self):
        self.frames = [dumps.replace(frame, atoms=frame.atoms.astype(np.float32).astype(float)) for frame in self.frames]
        self.assertEqual(self.bytes_of(self.write(self.dir / "a.h5", ">f4", "<i4")), self.text_table())

    def test_chunks_and_compression(self):
        wanted = self.text_table()
        for settings in ({"chunks": (1, 100, 3)}, {"chunks": (20, 700, 2), "compression": "gzip", "shuffle": True},
                         {"chunks": (7, 1206, 3), "fletcher32": True}, {"maxshape": (None, None, 3)}):
            self.assertEqual(self.bytes_of(self.write(self.dir / "a.h5", **settings)), wanted, settings)

    def test_increments(self):
        """Steps 7, 37, 67 ... and times 0.5, 0.625, 0.75 ..., exact in binary, written once each and as numbers."""
        count = np.arange(len(self.frames))
        listed = self.bytes_of(self.write(self.dir / "a.h5", steps=7 + 30 * count, times=0.5 + 0.125 * count))
        path = self.write(self.dir / "b.h5", steps=30, times=0.125)
        with h5py.File(path, "a") as file:
            for name in ("position", "velocity"):
                file[f"particles/all/{name}/step"].attrs["offset"] = 7
                file[f"particles/all/{name}/time"].attrs["offset"] = 0.5
        self.assertEqual(self.bytes_of(path), listed)
        self.assertEqual(self.document("info", path, *STATED)["steps"], [7, 7 + 30 * (len(count) - 1)])

    def test_enumerated_species(self):
        wanted = self.text_table()
        path = self.write(self.dir / "a.h5")
        with h5py.File(path, "a") as file:
            types = file["particles/all/species"][:]
            del file["particles/all/species"]
            kinds = h5py.enum_dtype({"low": 1, "high": 2}, basetype="i")
            file["particles/all"].create_dataset("species", data=types, dtype=kinds)
        self.assertEqual(self.bytes_of(path), wanted)

    def test_species_of_every_frame_and_columns_of_other_names(self):
        wanted = self.text_table()
        path = self.write(self.dir / "a.h5")
        with h5py.File(path, "a") as file:
            particles = file["particles/all"]
            del particles["species"]
            element(particles, "species", self.values("type", int)[:, :, 0], self.steps, self.times)
            particles["charge"] = np.zeros(1206)
            particles["c_pe"] = np.zeros(1206)
            particles["spin"] = np.zeros((1206, 3))
            particles["unrelated"] = np.zeros(5)
        self.assertEqual(self.bytes_of(path), wanted)
        self.assertEqual(self.document("info", path, *STATED)["columns"],
                         "id type q x y z vx vy vz c_pe spin_x spin_y spin_z".split())

    def test_absent_atoms(self):
        """Two places for each atom, of which one is empty: with the fill value -1 of id there are half as many."""
        wanted = self.text_table()
        file, particles = h5md(self.dir / "a.h5")
        with file:
            for name, columns, fill in (("position", "x y z", np.nan), ("velocity", "vx vy vz", np.nan),
                                        ("species", "type", 9), ("id", "id", -1)):
                kind = float if name in ("position", "velocity") else int
                values = self.values(columns, kind)
                places = np.full((len(values), 2 * 1206, values.shape[2]), fill, dtype=kind)
                for k in range(len(values)):
                    places[k, k % 2::2] = values[k]
                if kind is int:
                    places = places[:, :, 0]
                element(particles, name, places, self.steps, self.times, **({"fillvalue": -1} if name == "id" else {}))
        self.assertEqual(self.bytes_of(self.dir / "a.h5"), wanted)

    def test_box(self):
        path = self.write(self.dir / "a.h5")
        with h5py.File(path, "a") as file:
            box = file["particles/all/box"]
            del box["edges"], box["origin"], box.attrs["boundary"]
            box.attrs["boundary"] = ["periodic", "none", "periodic"]
            edges = np.array([[8.0, 0, 0], [2, 4, 0], [-1, 1, 16]]) + np.arange(len(self.frames))[:, None, None]
            element(box, "edges", edges, self.steps, self.times)
        self.assertEqual(self.document("info", path, *STATED)["box"],
                         {"origin": [0, 0, 0], "edges": edges[0].tolist(), "periodic": [True, False, True]})

    def test_particle_groups(self):
        path = self.write(self.dir / "a.h5")
        wanted = self.bytes_of(path)
        with h5py.File(path, "a") as file:
            file.copy("particles/all", "particles/some")
        self.assertEqual(self.bytes_of(path), wanted)
        with h5py.File(path, "a") as file:
            file.move("particles/all", "particles/others")
        self.refused(*FORCE, path, says=["some", "others"])

    def test_truncated_arrays(self):
        """Positions or velocities of fewer frames than there are steps: what is whole is used, exit code 3."""
        for name in ("position/value", "velocity/value", "velocity/step"):
            path = self.write(self.dir / "a.h5")
            with h5py.File(path, "a") as file:
                data = file[f"particles/all/{name}"][:-3]
                del file[f"particles/all/{name}"]
                file[f"particles/all/{name}"] = data
            self.assertEqual(self.bytes_of(path, code=3).count(b"\n"), 1 + len(self.frames) - 3, name)

    def test_frames_that_were_never_written(self):
        path = self.write(self.dir / "a.h5", chunks=(1, 1206, 3), maxshape=(None, 1206, 3))
        with h5py.File(path, "a") as file:
            for name in ("position", "velocity"):
                group = file[f"particles/all/{name}"]
                group["value"].resize(len(self.frames) + 2, axis=0)
                for clock in ("step", "time"):
                    data = group[clock][:]
                    del group[clock]
                    group[clock] = np.append(data, [data[-1] + 10, data[-1] + 20])
        self.assertEqual(self.bytes_of(path, code=3).count(b"\n"), 1 + len(self.frames))

    def test_damage_is_told(self):
        def changed(change):
            path = self.write(self.dir / "a.h5")
            with h5py.File(path, "a") as file:
                change(file["particles/all"])
            return path

        def replace(name, data):
            def change(particles):
                del particles[name]
                particles[name] = data
            return change

        def attribute(name, value):
            return lambda particles: particles["box"].attrs.__setitem__(name, value)

        for change, says in (
            (replace("velocity/step", self.steps + 1), "velocity"),
            (replace("species", np.full(1206, 1.5)), "species"),
            (replace("species", np.full(1205, 1)), "species"),
            (replace("id", np.full(1206, 2**64 - 1, dtype=np.uint64)), "2^63"),
            (replace("box/edges", [1.0, 2.0, np.nan]), "edges"),
            (replace("box/edges", [1.0, 2.0, 0.0]), "edges"),
            (replace("position/step", self.steps + 0.5), "step"),
            (attribute("dimension", 2), "dimension"),
            (attribute("boundary", ["none", "none", "mirror"]), "mirror"),
        ):
            with self.subTest(says):
                options = ["--masses", "1=1,2=1", "--radius", "5", "--units", "lj", "--source", "velocities"]
                bodies = "id:1-603" if says == "2^63" else "type"
                self.refused("force", *options, "--bodies", bodies, changed(change), says=[says])

    def test_compressed_files(self):
        path = self.dir / "a.h5.gz"
        path.write_bytes(gzip.compress(self.write(self.dir / "a.h5").read_bytes()))
        self.refused(*FORCE, path, says=["a.h5.gz", "decompress"])

    def test_more_atoms_than_the_file_can_hold(self):
        file, particles = h5md(self.dir / "a.h5")
        with file:
            group = particles.create_group("position")
            group["step"] = [0]
            group.create_dataset("value", shape=(1, 10**15, 3), chunks=(1, 1000, 3), dtype="f8")
        for command in (["info"], ["force", *STATED]):
            self.refused(*command, self.dir / "a.h5", says=["1000000000000000"])

class Written(running.Case):
    """What mdana writes, read by h5py and MDAnalysis."""

    def setUp(self):
        super().setUp()
        self.frames = dumps.read(SAMPLE)[:5]
        for frame in self.frames:
            frame.units = "real"
            frame.box = "ITEM: BOX BOUNDS xy xz yz pp pp ff\n-51 54 3\n-50 50 -1\n-50 52 0\n"
        self.path = self.dir / "new.h5"
        rewrite = Path(running.program).parent / "tests" / "rewrite"
        subprocess.run([rewrite, dumps.write(self.dir / "old.dump", self.frames), self.path], check=True)
        self.edges = [[101, 0, 0], [3, 100, 0], [-1, 0, 102]]  # bounds are those of the box around it

    def test_by_h5py(self):
        with h5py.File(self.path) as file:
            self.assertEqual(list(file["h5md"].attrs["version"]), [1, 1])
            self.assertEqual(file["h5md/creator"].attrs["name"], "mdana")
            particles = file["particles/all"]
            self.assertEqual(list(particles["box"].attrs["boundary"]), ["periodic", "periodic", "none"])
            self.assertEqual(particles.attrs["mdana_units"], "real")
            self.assertEqual(particles["position/value"].attrs["unit"], "Angstrom")
            self.assertEqual(particles["box/origin/value"][0].tolist(), [-50, -50, -50])
            self.assertEqual(particles["id/value"].fillvalue, -1)
            for k, frame in enumerate(self.frames):
                self.assertEqual(particles["box/edges/value"][k].tolist(), self.edges)
                for name, columns in (("position", "x y z"), ("velocity", "vx vy vz"), ("species", "type"), ("id", "id")):
                    element = particles[name]
                    self.assertEqual((element["step"][k], element["time"][k]), (frame.step, frame.time))
                    np.testing.assert_array_equal(element["value"][k].reshape(1206, -1), frame[columns])

    def test_by_mdanalysis(self):
        """MDAnalysis keeps coordinates as float32, and knows Angstrom and fs."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            import MDAnalysis
            from MDAnalysis.lib.mdamath import triclinic_box
        for settings, time in (({}, 1e-3), ({"convert_units": False}, 1)):  # it converts to ps
            universe = MDAnalysis.Universe.empty(1206, trajectory=False)
            universe.load_new(str(self.path), format="H5MD", **settings)
            self.assertEqual(len(universe.trajectory), len(self.frames))
            for frame, step in zip(self.frames, universe.trajectory):
                np.testing.assert_array_equal(step.positions, frame["x y z"].astype(np.float32))
                self.assertAlmostEqual(step.time, frame.time * time, delta=1e-12 * abs(frame.time))
                self.assertEqual(step.data["step"], frame.step)
                np.testing.assert_array_equal(step.dimensions, triclinic_box(*np.array(self.edges, float)))

    def test_by_mdana(self):
        columns = ("frames", "steps", "atoms", "box", "units")
        old, new = (self.document("info", path) for path in (self.dir / "old.dump", self.path))
        self.assertEqual([old[name] for name in columns], [new[name] for name in columns])
        self.assertEqual(sorted(old["columns"]), sorted(new["columns"]))
        self.assertEqual(new["format"], "h5md")


if __name__ == "__main__":
    running.main()
