# SPDX-License-Identifier: GPL-3.0-or-later
"""One run in every encoding, written by a few lines of Python each: mdana must make the same tables of all of them, byte
by byte where the numbers and their order are the same.

The run is the middle of the one in sample-data. Its positions are rounded to multiples of 2^-40 and its velocities have
digits up to the 17th, so that whoever loses bits is caught; and boxes have edges that are sums of powers of two, so that
positions can be wrapped, scaled and moved into any of them, and back, without rounding."""

import gzip
import shutil
import struct
import subprocess

import lammps  # noqa: F401, leads to tests/cli
import dumps
import running

try:
    import h5py
    import numpy as np
    from scipy.io import netcdf_file
except ImportError as error:
    running.skip(f"{error} (Debian: apt install python3-h5py python3-numpy python3-scipy)")

STATED = ("--masses", "1=1,2=1", "--bodies", "type", "--units", "lj", "--radius", "5")
DT = 0.0078125
ORIGIN = np.array([-4.0, 1.0, 0.5])


def run():
    """Eight frames, x y z in multiples of 2^-40: 17 digits tell them as they are."""
    frames = dumps.read(running.SAMPLE)[16:24]
    frames[0].units = "lj"
    dice = np.random.default_rng(1)
    for frame in frames:
        noise = dice.uniform(-1e-9, 1e-9, frame.atoms.shape)  # below the printed digits
        frame.atoms[:, 2:] += noise[:, 2:]
        frame.atoms[:, 2:5] = np.rint(frame.atoms[:, 2:5] * 2.0**40) / 2.0**40
    return frames


FRAMES = run()


def number(value, name):
    return str(int(value)) if name in ("id", "type", "ix", "iy", "iz") else f"{value:.17g}"


def rows(frame):
    return [" ".join(map(number, atom, frame.columns)) for atom in frame.atoms]


def text(frames, between=""):
    return "".join(between + frame.head() + "\n".join(rows(frame)) + "\n" for frame in frames)


# ---- other columns, boxes and orders ---------------------------------------------------------------------------------

# Edge vectors as rows, and how a text dump states the box: bounds of a tilted one are those of all its corners.
BOXES = {
    "straight": ([[16, 0, 0], [0, 8, 0], [0, 0, 8]], "pp pp pp\n-4 12\n1 9\n0.5 8.5\n"),
    "tilted": ([[16, 0, 0], [2, 8, 0], [-1, 1, 8]], "xy xz yz pp pp pp\n-5 14 2\n1 10 -1\n0.5 8.5 1\n"),
    "general": ([[0, 16, 0], [8, 2, 0], [1, -1, -8]], "abc origin pp pp pp\n0 16 0 -4\n8 2 0 1\n1 -1 -8 0.5\n"),
}


def fractions(place, edges):
    """Solves s edges = place - ORIGIN, exactly: every divisor is a power of two."""
    a, b, c = np.array(edges, float)
    x, y, z = (place - ORIGIN).T
    sc = z / c[2]
    if a[0]:
        sb = (y - sc * c[1]) / b[1]
        sa = (x - sb * b[0] - sc * c[0]) / a[0]
    else:
        sb = (x - sc * c[0]) / b[0]
        sa = (y - sb * b[1] - sc * c[1]) / a[1]
    found = np.column_stack([sa, sb, sc])
    assert np.array_equal(found @ np.array(edges, float) + ORIGIN, place), "not exact"
    return found


def spelled(columns, box):
    """The run with its positions in other columns, in a periodic box."""
    edges, bounds = BOXES[box]
    result = []
    for frame in FRAMES:
        place = frame["x y z"]
        inside = fractions(place, edges)
        image = np.floor(inside)
        wrapped = inside - image
        values = {"xu": place, "xsu": inside, "xs": wrapped, "x": wrapped @ np.array(edges, float) + ORIGIN}[columns[0]]
        if columns[1:]:
            values = np.column_stack([values, image])
        names = [columns[0].replace("x", axis) for axis in "xyz"] + list(columns[1:])
        atoms = np.column_stack([frame["id type"], values, frame["vx vy vz"]])
        result.append(dumps.Frame(frame.step, frame.time, ["id", "type", *names, "vx", "vy", "vz"], atoms, frame.units,
                                  "ITEM: BOX BOUNDS " + bounds))
    return result


IMAGES = ("ix", "iy", "iz")
SPELLINGS = [(columns, box) for box in BOXES for columns in (("xu",), ("xsu",), ("x", *IMAGES), ("xs", *IMAGES))]


def changed(change):
    """A copy of the run whose frames are changed."""
    frames = [dumps.replace(frame, atoms=frame.atoms.copy(), columns=list(frame.columns)) for frame in FRAMES]
    for frame in frames:
        change(frame)
    return frames


def shuffled(seed):
    dice = np.random.default_rng(seed)

    def change(frame):
        frame.atoms = dice.permutation(frame.atoms)

    return changed(change)


def large_ids(frame):
    frame.atoms[:, 0] += 2.0**40


def with_words():
    """Columns that nobody asked for, among them words, before, between and behind the others."""
    lines = []
    for frame in FRAMES:
        head = frame.head().replace("ITEM: ATOMS id type x", "ITEM: ATOMS element id c_s[1] type x")
        lines.append(head.rstrip("\n") + " f_odd typelabel\n")
        for row in rows(frame):
            atom, kind, rest = row.split(" ", 2)
            lines.append(f"{'CuAr'[2 * int(kind) - 2:2 * int(kind)]} {atom} -1e-3 {kind} {rest} 4e300 A#{kind}\n")
    return "".join(lines)


# ---- other formats ---------------------------------------------------------------------------------------------------


def flow(words):
    return "[ " + "".join(f"{word}, " for word in words) + "]"


def yaml():
    """As LAMMPS' dump style yaml."""
    parts = []
    for frame in FRAMES:
        parts.append(f"---\ncreator: LAMMPS\ntimestep: {frame.step}\nunits: lj\ntime: {frame.time!r}\n"
                     f"natoms: {len(frame.atoms)}\nboundary: {flow('ffffff')}\nbox:\n  - [ -38.4, 38.4 ]\n"
                     f"  - [ -25, 25 ]\n  - [ -25, 25 ]\nkeywords: {flow(frame.columns)}\ndata:\n")
        parts += [f"  - {flow(row.split())}\n" for row in rows(frame)] + ["...\n"]
    return "".join(parts)


def binary(order, ranks=3, old=False):
    """As LAMMPS' dump custom to a file *.bin, revision 2 (old: before October 2020), by so many ranks."""
    data = b""
    for k, frame in enumerate(FRAMES):
        def put(kind, *values):
            return struct.pack(order + kind, *values)

        units, names = (b"lj" if k == 0 else b""), " ".join(frame.columns).encode()
        data += b"" if old else put("q", -10) + b"DUMPCUSTOM" + put("ii", 1, 2)
        data += put("qqi6i", frame.step, len(frame.atoms), 0, *[1] * 6) + put("6d", -38.4, 38.4, -25, 25, -25, 25)
        data += put("i", len(frame.columns))
        if not old:
            data += put("i", len(units)) + units + put("b", 1) + put("d", frame.time) + put("i", len(names)) + names
        data += put("i", ranks)
        for part in np.array_split(frame.atoms, ranks):
            data += put("i", part.size) + part.astype(order + "f8").tobytes()
    return data


def h5md(path):
    """H5MD 1.1, float64."""
    with h5py.File(path, "w") as file:
        file.create_group("h5md").attrs["version"] = [1, 1]
        atoms = file.create_group("particles/all")
        box = atoms.create_group("box")
        box.attrs["dimension"], box.attrs["boundary"] = 3, np.array([b"none"] * 3)
        box["edges"] = [76.8, 50.0, 50.0]
        for name, columns in {"position": "x y z", "velocity": "vx vy vz", "species": "type", "id": "id"}.items():
            values = np.array([frame[columns] for frame in FRAMES])
            group = atoms.create_group(name)
            group["step"] = [frame.step for frame in FRAMES]
            group["time"] = [frame.time for frame in FRAMES]
            group["value"] = values if values.shape[2] == 3 else values[:, :, 0].astype(int)


def netcdf(path, lengths=(0, 0, 0)):
    """AMBER netCDF as LAMMPS writes it with dump_modify double yes: time in steps, the time step its scale_factor; no
    lengths of a box that is not periodic."""
    with netcdf_file(path, "w", version=2) as file:
        file.Conventions, file.ConventionVersion, file.program = "AMBER", "1.0", "LAMMPS"
        for name, size in {"frame": None, "atom": len(FRAMES[0].atoms), "spatial": 3, "cell_spatial": 3,
                           "cell_angular": 3}.items():
            file.createDimension(name, size)

        def add(name, kind, axes, values):
            variable = file.createVariable(name, kind, ("frame", *axes))
            for k, value in enumerate(values):
                variable[k] = value
            return variable

        time = add("time", "f8", (), [frame.step for frame in FRAMES])
        time.units, time.scale_factor = "lj", np.float64(DT)
        add("cell_origin", "f8", ("cell_spatial",), [[-38.4, -25, -25]] * len(FRAMES))
        add("cell_lengths", "f8", ("cell_spatial",), [lengths] * len(FRAMES)).units = "lj"
        add("cell_angles", "f8", ("cell_angular",), [[90, 90, 90]] * len(FRAMES))
        for name in ("id", "type"):
            add(name, "i4", ("atom",), [frame[name][:, 0] for frame in FRAMES])
        for name, columns in {"coordinates": "x y z", "velocities": "vx vy vz"}.items():
            add(name, "f8", ("atom", "spatial"), [frame[columns] for frame in FRAMES]).units = "lj"


class Encodings(running.Case):
    def put(self, name, data):
        path = self.dir / name
        path.write_bytes(data if isinstance(data, bytes) else data.encode())
        return path

    def tables(self, dump):
        result = {}
        for command, *options in (("force", "--source", "velocities"), ("force", "--source", "positions"),
                                  ("contact-radius",)):
            out = self.dir / "table.csv"
            self.mdana(command, dump, *STATED, *options, "-o", out)
            result[" ".join([command, *options])] = out.read_bytes()
        return result

    def wanted(self):
        """The tables of the plain text dump."""
        if not hasattr(Encodings, "of_text"):
            Encodings.of_text = self.tables(self.put("plain.dump", text(FRAMES)))
        for table in Encodings.of_text.values():
            self.assertEqual(table.count(b"\n"), 1 + len(FRAMES))
        return Encodings.of_text

    def same(self, dump, notes=()):
        """The same bytes in all tables, and nothing that `check` finds wrong."""
        with self.subTest(dump.name):
            self.assertEqual(self.tables(dump), self.wanted())
            document = self.document("check", dump)
            self.assertEqual((document["errors"], sorted(document["counts"])), (0, sorted(notes)))
            self.assertEqual((document["frames"], document["atoms"]), (8, 8 * 1206))
            self.assertTrue(document["checked"]["to_the_end"])

    def test_numbers_are_those_of_the_run(self):
        """The tables that all others are compared with, by exactly rounded means in Python: distances below 16 with
        errors below a few 2^-53 each of centres, differences and a root; v the same with velocities below 1/4."""
        out = self.dir / "table.csv"
        self.mdana("force", self.put("plain.dump", text(FRAMES)), *STATED, "--source", "velocities", "-o", out)
        table = running.read_csv(out)
        centres = [dumps.centres(frame) for frame in FRAMES]
        self.assertEqual(table["step"], [frame.step for frame in FRAMES])
        self.assert_close(table["X"], [np.linalg.norm(b - a) for a, b in centres], 2**-53, 16 * 8, "X")
        speeds = [dumps.centres(frame, "vx vy vz") for frame in FRAMES]
        v = [-np.dot(d - c, b - a) / np.linalg.norm(b - a) for (a, b), (c, d) in zip(centres, speeds)]
        self.assert_close(table["v"], v, 2**-53, 16, "v")

    def test_lost_bits_would_be_seen(self):
        """In the tables of the run with 15 digits instead of 17."""
        short = "".join(frame.head() + "".join(" ".join(f"{v:.15g}" for v in atom) + "\n" for atom in frame.atoms)
                        for frame in FRAMES)
        found = self.tables(self.put("short.dump", short))
        for command, table in self.wanted().items():
            self.assertNotEqual(found[command], table, command)

    # ---- packed, other line ends and columns

    def test_packed(self):
        plain = text(FRAMES).encode()
        self.same(self.put("one.dump.gz", gzip.compress(plain, 6)))
        cuts = [0, 1, 1000, len(plain) // 3, len(plain) // 2, len(plain)]
        members = b"".join(gzip.compress(plain[a:b], 1) for a, b in zip(cuts, cuts[1:]))
        self.same(self.put("members.dump.gz", members + gzip.compress(b"")))

    def test_zstd(self):
        tool, plain = shutil.which("zstd"), self.put("plain.dump", text(FRAMES))
        if not tool:
            self.skipTest("no zstd in the PATH")
        packed = self.dir / "packed.dump.zst"
        subprocess.run([tool, "-q", plain, "-o", packed], check=True)
        if "without zstd" in running.run("info", packed).stderr:
            self.skipTest("mdana is built without zstd")
        self.same(packed)

    def test_lines(self):
        self.same(self.put("crlf.dump", text(FRAMES).replace("\n", "\r\n")))
        self.same(self.put("comments.dump", text(FRAMES, "# a comment\n#\n\n") + "# end\n"))
        self.same(self.put("tabs.dump", "".join(frame.head() + "".join(f" \t{row.replace(' ', '  ')} \n" for row in rows(frame))
                                                for frame in FRAMES)))
        self.same(self.put("words.dump", with_words()))

    def test_ids(self):
        self.same(self.put("large.dump", text(changed(large_ids))))
        ids = ("--bodies", f"id:{2**40 + 1}-{2**40 + 603}")
        out = self.dir / "table.csv"
        options = [option for option in STATED if option not in ("--bodies", "type")]
        self.mdana("contact-radius", self.dir / "large.dump", *options, *ids, "-o", out)
        self.assertEqual(out.read_bytes(), self.wanted()["contact-radius"])

    # ---- boxes and positions

    def test_spellings_of_positions(self):
        for columns, box in SPELLINGS:
            frames = spelled(columns, box)
            self.assertGreater(len(np.unique(np.floor(fractions(FRAMES[0]["x y z"], BOXES[box][0])), axis=0)), 4)
            self.same(self.put(f"{box}-{'-'.join(columns)}.dump", text(frames)))

    def test_scaled_in_a_box_that_is_not_periodic(self):
        """xs without image flags, of atoms in the box."""
        frames = []
        for frame in FRAMES:
            values = (frame["x y z"] + 32) / 64
            atoms = np.column_stack([frame["id type"], values, frame["vx vy vz"]])
            frames.append(dumps.Frame(frame.step, frame.time, "id type xs ys zs vx vy vz".split(), atoms, "lj",
                                      "ITEM: BOX BOUNDS ff ff ff\n" + "-32 32\n" * 3))
        self.same(self.put("xs.dump", text(frames)))

    # ---- order

    def test_order_of_atoms(self):
        """Means of 603 numbers in another order. In order of ids the partial sums of positions come up to 2^11, and those
        of velocities to 2^6: each addition rounds by at most 2^-43 and 2^-48, all the same way at worst, which is the
        error of the mean; that of the difference of two tables is twice as large. v and F have two means each; F is
        m* = 301.5 times a derivative over h = 0.25, whose weights add up to 11/h, the second one's to 27/h^2."""
        place, speed, h = 2**-42, 2**-47, 0.25
        force = {"velocities": 301.5 * 2 * speed * 11 / h, "positions": 301.5 * 2 * place * 27 / h**2}
        wanted = self.wanted()
        for seed in (1, 2, 3):
            dump = self.put(f"shuffled{seed}.dump", text(shuffled(seed)))
            for command, data in self.tables(dump).items():
                found, expected = (self.columns(table) for table in (data, wanted[command]))
                scales = {"v": 2 * speed, "F": force.get(command.split()[-1])}
                self.assertEqual(list(found), list(expected))
                for name, values in found.items():
                    if any(isinstance(value, str) or value is None for value in values):
                        self.assertEqual(values, expected[name], name)
                    else:
                        self.assert_close(values, expected[name], scales.get(name, place), 1, f"{command} {name}")

    def columns(self, data):
        return running.read_csv(self.put("columns.csv", data))

    # ---- files

    def test_sets(self):
        for frame in FRAMES:
            self.put(f"run.{frame.step}.dump", text([frame]))
        for k in range(3):
            parts = changed(lambda frame: setattr(frame, "atoms", np.array_split(frame.atoms, 3)[k]))
            self.put(f"piece.{k}.dump", text(parts))
            for frame in parts:
                self.put(f"both.{k}.{frame.step}.dump", text([frame]))
        for name in ("run.*.dump", "piece.%.dump", "both.%.*.dump"):
            self.same(self.dir / name)

    # ---- formats

    def test_yaml(self):
        self.same(self.put("dump.yaml", yaml()))

    def test_binary(self):
        for order in "<>":
            for ranks in (1, 3):
                self.same(self.put(f"{'little' if order == '<' else 'big'}{ranks}.bin", binary(order, ranks)))

    def test_old_binary(self):
        """Before October 2020 the file names no columns: nothing is guessed; a file beside it may tell."""
        for name, order in (("little.bin", "<"), ("big.bin", ">")):
            old = self.put(name, binary(order, old=True))
            self.refused("force", old, *STATED, says=[".columns"])
            self.put(name + ".columns", b"id type x y z vx vy vz\n")
            texts = []
            for dump in (old, self.put("new.bin", binary(order))):
                texts.append(self.dir / "text.lammpstrj")
                self.mdana("convert", dump, "-o", texts[-1], "--omit", "units,time")
                texts[-1] = texts[-1].read_bytes()
            self.assertEqual(*texts)
            self.put(name + ".columns", b"id type x y z vx vy\n")
            self.refused("force", old, *STATED, says=["7 columns are named, but an atom has 8"])

    def test_h5md(self):
        path = self.dir / "run.h5"
        h5md(path)
        self.same(path)

    def test_netcdf(self):
        path = self.dir / "run.nc"
        netcdf(path)
        self.same(path)

    # ---- there and back

    def converted(self, dump, *names):
        for name in names:
            out = self.dir / name
            self.mdana("convert", dump, "-o", out)
            dump = out
        return dumps.read(dump)

    def assert_same_numbers(self, found, wanted=None):
        wanted = FRAMES if wanted is None else wanted
        self.assertEqual(len(found), len(wanted))
        for a, b in zip(found, wanted):
            self.assertEqual((a.step, a.time, sorted(a.columns)), (b.step, b.time, sorted(b.columns)))
            names = " ".join(b.columns)
            self.assertEqual(a[names].tobytes(), b[names].tobytes())

    def test_round_trips(self):
        plain = self.put("plain.dump", text(FRAMES))
        little = self.put("run.bin", binary("<"))
        for dump in (plain, little):
            self.assert_same_numbers(self.converted(dump, "a.h5", "a.dump"))
            self.assert_same_numbers(self.converted(dump, "b.lammpstrj.gz", "b.dump"))
        mixed = shuffled(9)
        self.assert_same_numbers(self.converted(self.put("mixed.dump", text(mixed)), "c.h5", "c.dump"), mixed)

    def test_to_text(self):
        self.assert_same_numbers(self.converted(self.put("dump.yaml", yaml()), "yaml.dump"))
        path = self.dir / "run.nc"
        netcdf(path, (128, 64, 64))
        self.assert_same_numbers(self.converted(path, "netcdf.dump"))
        netcdf(path)  # a text dump must state a box, and none is made up
        self.refused("convert", path, "--format", "lammps_text", says=["no volume"])
        path = self.dir / "run.h5"
        h5md(path)
        self.assert_same_numbers(self.converted(path, "h5md.dump"))

    def test_unwrapped_by_hand(self):
        """Image flags go through HDF5, and --add xu makes of them the positions of the run."""
        for box in ("straight", "tilted"):
            dump = self.put("wrapped.dump", text(spelled(("x", *IMAGES), box)))
            self.assert_same_numbers(self.converted(dump, "w.h5", "w.dump"), spelled(("x", *IMAGES), box))
            out = self.dir / "xu.dump"
            self.mdana("convert", self.dir / "w.dump", "-o", out, "--add", "xu")
            for found, wanted in zip(dumps.read(out), FRAMES):
                self.assertEqual(found["xu yu zu"].tobytes(), wanted["x y z"].tobytes())


if __name__ == "__main__":
    running.main()
