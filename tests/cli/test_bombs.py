# SPDX-License-Identifier: GPL-3.0-or-later
"""Small files that claim to be large: refused at once, in bounded memory, with the file's name and what is wrong."""

import gzip
import resource
import struct
import subprocess

import running
from running import SAMPLE, Case

try:
    import h5py
    import numpy as np
    from scipy.io import netcdf_file
except ImportError:
    running.skip("no h5py, numpy or scipy (Debian: apt install python3-h5py python3-numpy python3-scipy)")

MEMORY = 700 << 20  # bytes of a process's own data; the program needs some 100 MB for small dumps
SECONDS = 60  # a few where nothing else runs
HEAD = "ITEM: UNITS\nlj\nITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\nITEM: ATOMS {}\n"
ATOM = "1 1 1 2 3 0 0 0\n"
COLUMNS = "id type x y z vx vy vz"
MUCH = 10**15


def limited():
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))


class Bombs(Case):
    def file(self, name, data):
        path = self.dir / name
        path.write_bytes(data.encode() if isinstance(data, str) else data)
        return path

    def refused_within(self, path, *says, commands=("info", "check", "force"), codes=(1,)):
        for command in commands:
            with self.subTest(f"{command} {path.name}"):
                done = running.run(command, path, preexec_fn=limited, timeout=SECONDS)
                told = done.stderr + done.stdout
                self.assertIn(done.returncode, codes, told[:500])
                self.assertLess(len(told), 10000)
                for text in (path.name, *says):
                    self.assertIn(text, told)
                self.assertNotIn("bad_alloc", told)

    def refused_log(self, log, says):
        done = running.run("energy", SAMPLE, "--log", log, preexec_fn=limited, timeout=SECONDS)
        self.assertEqual(done.returncode, 1, done.stderr[:500])
        self.assertIn(log.name, done.stderr[:500])
        self.assertIn(says, done.stderr[:500])

    def packed_zeros(self, name, head, megabytes):
        """A gzip file of a head and zeros, in members of a megabyte."""
        return self.file(name, gzip.compress(head.encode()) + megabytes * gzip.compress(bytes(1 << 20)))


class Texts(Bombs):
    def test_atoms_that_are_not_there(self):
        for atoms in (MUCH, 2**64 - 1):
            path = self.file("atoms.dump", HEAD.format(atoms, COLUMNS) + ATOM)
            self.refused_within(path, "ends within the atoms of frame 0", codes=(1, 3))

    def test_names_of_a_megabyte(self):
        for columns, says in (("id x y z " + "c" * (1 << 20), "bytes"), ("id x y z " + " ".join(f"c{k}" for k in range(200000)), "columns"),
                              ("id x y z" + " v" * 500000, "columns")):
            self.refused_within(self.file("names.dump", HEAD.format(1, columns) + ATOM), says, codes=(1, 3))

    def test_line_of_a_gigabyte(self):
        """Sparse, that is of zeros; and packed."""
        for name, head in (("header.dump", "ITEM: TIMESTEP\n"), ("atoms.dump", HEAD.format(2, COLUMNS))):
            path = self.file(name, head)
            with open(path, "ab") as file:
                file.truncate(1 << 30)
            self.refused_within(path, codes=(1, 3))
            self.refused_within(self.packed_zeros(name + ".gz", head, 1 << 10), codes=(1, 3))

    def test_zeros_packed(self):
        self.refused_within(self.packed_zeros("zeros.gz", "", 1 << 10), "not a dump")
        self.refused_log(self.packed_zeros("log.gz", "LAMMPS (29 Sep 2021)\n", 100), "line")

    def test_zeros_packed_by_zstd(self):
        try:
            head, zeros = (subprocess.run(["zstd", "-q"], input=data, capture_output=True, check=True).stdout
                           for data in (HEAD.format(2, COLUMNS).encode(), bytes(1 << 20)))
        except FileNotFoundError:
            self.skipTest("no program zstd")
        self.refused_within(self.file("zeros.zst", head + 1024 * zeros), "more than", codes=(1, 3))

    def test_yaml_nested_deep(self):
        head = "---\ncreator: LAMMPS\ntimestep: 0\nnatoms: 1\nboundary: "
        for text in ("[" * (1 << 20), "[ p, p, p, p, p, p, ]\nbox:\n" + "  - " * (1 << 20)):
            self.refused_within(self.file("deep.yaml", head + text + "\n"), codes=(1, 3))

    def test_columns_of_a_log(self):
        for head in ("Step " + " ".join(f"c{k}" for k in range(10**6)), "---\nkeywords: [" + "a, " * 10**6 + "]"):
            log = self.file("log.lammps", "LAMMPS (1 Jan 2024)\nPer MPI rank memory\n" + head + "\n")
            self.refused_log(log, "columns")


class Binaries(Bombs):
    def binary(self, atoms, columns, numbers, names=b"id x y z"):
        frame = struct.pack("<q10siiqqi6i6di", -10, b"DUMPCUSTOM", 1, 2, 0, atoms, 0, *[1] * 6, 0, 9, 0, 9, 0, 9, columns)
        frame += struct.pack("<i", 0) + b"\0" + struct.pack("<i", len(names)) + names + struct.pack("<ii", 1, numbers)
        return self.file("binary.dump", frame + bytes(64))

    def test_counts(self):
        self.refused_within(self.binary(MUCH, 4, 2**31 - 4), codes=(1, 3))
        self.refused_within(self.binary(1, 2**31 - 1, 4), "columns", codes=(1, 3))
        self.refused_within(self.binary(1, 400000, 4, b"v " * 400000), "columns", codes=(1, 3))

    def netcdf(self, version, frames, atoms, offset=0):
        """A header alone: a time in each frame, no atoms' numbers."""
        n = ">I" if version < 5 else ">Q"
        name = lambda text: struct.pack(n, len(text)) + text + bytes(-len(text) % 4)
        attribute = lambda key, text: name(key) + struct.pack(">I", 2) + struct.pack(n, len(text)) + text + bytes(-len(text) % 4)
        head = b"CDF" + bytes([version]) + struct.pack(n, 0)
        head += struct.pack(">I", 10) + struct.pack(n, 2) + name(b"frame") + struct.pack(n, frames) + name(b"atom") + struct.pack(n, atoms)
        head += struct.pack(">I", 12) + struct.pack(n, 1) + attribute(b"Conventions", b"AMBER")
        return self.file("amber.nc", head + bytes(64))

    def test_netcdf_of_dimensions_alone(self):
        self.refused_within(self.netcdf(1, 2**31 - 4, 5), "more than a file")
        self.refused_within(self.netcdf(5, 1, MUCH), "more than a file")
        self.refused_within(self.netcdf(5, MUCH, MUCH), "more than a file")


class Hdf5(Bombs):
    def h5md(self, name, position):
        """A file of one group of particles; `position` makes the element in it."""
        path = self.dir / name
        with h5py.File(path, "w") as file:
            file.create_group("h5md").attrs["version"] = np.array([1, 1])
            box = file.create_group("particles/all/box")
            box.attrs["dimension"] = 3
            box.attrs["boundary"] = np.array([b"none"] * 3)
            position(file["particles/all"])
        return path

    def test_data_that_are_not_there(self):
        for frames, atoms in ((1, MUCH), (MUCH, 1), (MUCH, 0)):
            def claimed(group):
                element = group.create_group("position")
                element.create_dataset("value", (frames, atoms, 3), "f8", chunks=(1, 100, 3), maxshape=(None, None, 3))
                element["step"] = 1
            self.refused_within(self.h5md("claimed.h5", claimed), "more than a file")

    def test_links_in_circles(self):
        def soft(group):
            group["position"] = h5py.SoftLink("/particles/all/velocity")
            group["velocity"] = h5py.SoftLink("/particles/all/position")
        def hard(group):
            group["position"] = group
            group["position/value"] = group
        for name, circle in (("soft.h5", soft), ("hard.h5", hard)):
            self.refused_within(self.h5md(name, circle), "position")

    def test_data_in_other_files(self):
        """Neither of itself, nor of a device; not followed, since no record would tell of that file."""
        def linked(group):
            group["position"] = h5py.ExternalLink("linked.h5", "/particles/all/position")
        def through(group):
            group["elsewhere"] = h5py.ExternalLink("through.h5", "/particles/all")
            group["position"] = h5py.SoftLink("elsewhere/position")
        def external(group):
            group.create_dataset("position", (2, 3), "f8", external=[("/dev/zero", 0, 48)])
        def virtual(group):
            layout = h5py.VirtualLayout((2, 3), "f8")
            layout[:] = h5py.VirtualSource("virtual.h5", "particles/all/position", (2, 3))
            group.create_virtual_dataset("position", layout)
        for name, position in (("linked.h5", linked), ("external.h5", external), ("virtual.h5", virtual)):
            self.refused_within(self.h5md(name, position), "another file")
        self.refused_within(self.h5md("through.h5", through), "position")


class Settings(Bombs):
    def test_deep_tables(self):
        deep = ".".join("a" * 100000)
        for text in (f"[{deep}]\n", f"{deep} = 1\n", "a = " + "[" * 100000, "a = " + "{a=" * 100000, "x" * (1 << 20)):
            study = self.file("study.toml", "schema = 1\n" + text + "\n")
            done = running.run("report", study, "-o", self.dir / "out", preexec_fn=limited, timeout=SECONDS)
            self.assertEqual(done.returncode, 1, done.stderr[:300])
            self.assertIn("study.toml:2", done.stderr[:300])
            self.assertLess(len(done.stderr), 3000)

    def test_index_of_frames_that_are_not_there(self):
        """An index that does not fit its file is not used."""
        dump = self.file("run.dump", HEAD.format(1, COLUMNS) + ATOM)
        self.file("run.dump.mdana-index", f"mdana-index 1\nsize {dump.stat().st_size}\nhash x\nframes {MUCH}\n0 0 0 1\ncheck 0\n")
        done = running.run("info", dump, "--json", preexec_fn=limited, timeout=SECONDS)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_tables(self):
        for name, text, says in (("wide.csv", ",".join(f"c{k}" for k in range(10**6)) + "\n1\n", "columns"),
                                 ("long.csv", "a\n" + "1\n" * (3 << 20), "rows")):
            done = running.run("plot", "force", self.file(name, text), "-o", self.dir / "out.svg", preexec_fn=limited, timeout=SECONDS)
            self.assertEqual(done.returncode, 1, done.stderr[:300])
            self.assertIn(name, done.stderr)
            self.assertIn(says, done.stderr)


if __name__ == "__main__":
    running.main()
