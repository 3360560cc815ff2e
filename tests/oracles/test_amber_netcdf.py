# SPDX-License-Identifier: GPL-3.0-or-later
"""AMBER netCDF trajectories by independent writers (MDAnalysis, scipy, netCDF's own library), against text dumps of the
same numbers, which have 17 digits: mdana must write the same tables. Cut files give whole frames, never zeros."""

import unittest
import warnings

import lammps  # noqa: F401, leads to tests/cli
import dumps
import running

warnings.simplefilter("ignore")
try:
    import MDAnalysis
    import netCDF4
    import numpy as np
    from MDAnalysis.coordinates.TRJ import NCDFWriter
    from scipy.io import netcdf_file
except ImportError as error:
    running.skip(f"{error} (Debian: apt install python3-mdanalysis python3-netcdf4 python3-scipy)")

DT = 0.015625  # a power of two: LAMMPS' steps times it are the times of the frames to the last bit
LABELS = {"cell_spatial": list("abc"), "spatial": list("xyz")}
VECTORS = {"coordinates": "x y z", "velocities": "vx vy vz", "forces": "fx fy fz"}


def text_frames(kind):
    """Frames of a collision, numbers rounded to `kind` (f4, f8), times to multiples of DT."""
    frames = dumps.spring_bounce()[0]
    for k, frame in enumerate(frames):
        frame.step, frame.time = 8 * k, 8 * k * DT
        real = slice(2, None)
        frame.atoms[:, real] = frame.atoms[:, real].astype(kind).astype("f8")
    return frames


class Writer:
    """Names that scipy's netcdf_file and netCDF4's Dataset share."""

    def __init__(self, file, frames, units, lammps=False):
        self.file = file
        file.Conventions, file.ConventionVersion = "AMBER", "1.0"
        file.program = "LAMMPS" if lammps else "test"
        for name, size in {"frame": None, "spatial": 3, "atom": len(frames[0].atoms), "cell_spatial": 3,
                           "cell_angular": 3}.items():
            file.createDimension(name, size)
        for name, letters in LABELS.items():
            file.createVariable(name, "c", (name,))[:] = np.array(letters, "S1")
        self.units = units

    def add(self, name, kind, axes, rows, unit=None, scale=None):
        variable = self.file.createVariable(name, kind, ("frame", *axes))
        if hasattr(variable, "set_auto_maskandscale"):
            variable.set_auto_maskandscale(False)
        if unit in self.units:
            variable.units = self.units[unit]
        if scale is not None:
            variable.scale_factor = np.float32(scale)
        for k, row in enumerate(rows):
            variable[k] = row


def write(file, frames, kind, units, lammps=False, scale=None, ids="i4"):
    """All that LAMMPS' dump netcdf writes, or a plain AMBER trajectory of the same frames with types and masses."""
    writer = Writer(file, frames, units, lammps)
    count = len(frames[0].atoms)
    if lammps:
        writer.add("time", kind, (), [frame.step for frame in frames], "time", DT)
        writer.add("cell_origin", kind, ("cell_spatial",), [[-50, -50, -50]] * len(frames), "length")
        writer.add("id", ids, ("atom",), [frame["id"][:, 0] for frame in frames])
    else:
        writer.add("time", kind, (), [frame.time for frame in frames], "time")
    writer.add("cell_lengths", kind, ("cell_spatial",), [[0, 0, 0]] * len(frames), "length")
    writer.add("cell_angles", kind, ("cell_angular",), [[90, 90, 90]] * len(frames))
    writer.add("type", "i4", ("atom",), [frame["type"][:, 0] for frame in frames])
    writer.add("mass", kind, ("atom",), [np.ones(count)] * len(frames))
    for (name, columns), unit in zip(VECTORS.items(), ("length", "velocity", "force")):
        factor = scale if name == "velocities" else None
        writer.add(name, kind, ("atom", "spatial"), [frame[columns] / (factor or 1) for frame in frames], unit, factor)
    file.close()


LJ = dict.fromkeys(("time", "length", "velocity", "force"), "lj")


class AmberNetcdf(running.Case):
    def assert_same(self, netcdf, frames, *options):
        text = dumps.write(self.dir / "same.lammpstrj", frames)
        for source in ("forces", "velocities", "positions"):
            found = self.table("force", netcdf, "--source", source, *options)
            wanted = self.table("force", text, "--source", source)
            self.assertGreater(len(wanted["time"]), 40)
            self.assertEqual(found, wanted, f"{netcdf.name}, {source}")

    def files(self, kind):
        """The frames by every writer."""
        for version in (1, 2):
            path = self.dir / f"scipy{version}-{kind}.nc"
            write(netcdf_file(path, "w", version=version), text_frames(kind), kind, LJ, lammps=True)
            yield path
        for form in ("NETCDF3_CLASSIC", "NETCDF3_64BIT_OFFSET", "NETCDF3_64BIT_DATA"):
            path = self.dir / f"{form}-{kind}.nc"
            ids = "i8" if form == "NETCDF3_64BIT_DATA" else "i4"
            write(netCDF4.Dataset(path, "w", format=form), text_frames(kind), kind, LJ, lammps=True, ids=ids)
            yield path

    def test_like_lammps(self):
        for kind in ("f4", "f8"):
            for path in self.files(kind):
                with self.subTest(path.name):
                    self.assert_same(path, text_frames(kind))

    def test_plain_amber(self):
        """Without ids, steps and units."""
        path = self.dir / "plain.nc"
        frames = text_frames("f8")
        write(netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_OFFSET"), frames, "f8", {})
        for k, frame in enumerate(frames):
            frame.step = k
        self.assert_same(path, frames, "--units", "lj")
        self.refused("force", path, says=["does not state its units"])

    def test_velocities_of_amber(self):
        """In 1/20.455 angstrom/picosecond; the factor is a power of two here, so that no bit changes."""
        path = self.dir / "scaled.nc"
        write(netcdf_file(path, "w", version=2), text_frames("f8"), "f8", LJ, lammps=True, scale=16.0)
        self.assert_same(path, text_frames("f8"))

    def test_info(self):
        path = self.dir / "t.nc"
        frames = text_frames("f4")
        write(netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_DATA"), frames, "f4", LJ, lammps=True, ids="i8")
        document = self.document("info", path)
        self.assertEqual(document["format"], "amber_netcdf")
        self.assertEqual(document["units"], "lj")
        self.assertEqual(document["units_source"], "dump")
        self.assertEqual(document["frames"], len(frames))
        self.assertEqual(document["steps"], [0, 8 * (len(frames) - 1)])
        self.assertEqual(document["columns"], "id type mass x y z vx vy vz fx fy fz".split())
        self.assertEqual(document["box"]["origin"], [-50, -50, -50])
        self.assertEqual(document["box"]["periodic"], [False] * 3)
        self.assertEqual(document["inputs"][0]["size"], path.stat().st_size)

    def test_mdanalysis(self):
        """MDAnalysis writes float32, and AMBER's units: the unit system is metal, which the forces are not of."""
        path, frames = self.dir / "mda.nc", dumps.spring_bounce()[0]
        self.write_by_mdanalysis(path, frames)
        document = self.document("info", path)
        self.assertEqual(document["frames"], len(frames))
        self.assertEqual(document["columns"], "id x y z vx vy vz forces[1] forces[2] forces[3]".split())
        edges = np.array(document["box"]["edges"])
        self.assertLess(np.abs(edges - [[40, 0, 0], [15, 30 * np.sqrt(0.75), 0], [0, 0, 20]]).max(), 1e-13)
        self.assertEqual(document["box"]["periodic"], [True] * 3)
        self.refused("force", path, "--units", "real", "--bodies", "id:1-8", says=["units real by the option, but metal"])

    def test_numbers_of_mdanalysis(self):
        """The same in units that need no masses. Means of 8 numbers, each rounded to 2^-24 of at most 8 (speeds: of 1,
        twice, for the scale_factor; forces: of 2, summed over 8 atoms of both bodies)."""
        path, frames = self.dir / "mda.nc", dumps.spring_bounce()[0]
        self.write_by_mdanalysis(path, frames)
        with netCDF4.Dataset(path, "a") as file:
            for name in ("time", "cell_lengths", "coordinates", "velocities", "forces"):
                file[name].units = "lj"
        text = dumps.write(self.dir / "mda.lammpstrj", frames)
        options = ("--source", "forces", "--radius", "5", "--bodies", "id:1-8")
        found, wanted = self.table("force", path, *options), self.table("force", text, *options)
        for name, size in {"x1": 8, "y2": 8, "vx1": 2, "vz2": 2, "X": 32, "F": 32, "time": 32}.items():
            self.assert_close(found[name], wanted[name], 2**-24, size, name)

    def write_by_mdanalysis(self, path, frames):
        universe = MDAnalysis.Universe.empty(16, trajectory=True, velocities=True, forces=True)
        with NCDFWriter(str(path), 16, convert_units=False, velocities=True, forces=True,
                        scale_velocities=20.455) as writer:
            for frame in frames:
                universe.atoms.positions, universe.atoms.velocities = frame["x y z"], frame["vx vy vz"]
                universe.atoms.forces = frame["fx fy fz"]
                universe.dimensions = [40, 30, 20, 90, 90, 60]
                universe.trajectory.ts.time = frame.time
                writer.write(universe.atoms)

    def test_cut_at_many_bytes(self):
        frames = text_frames("f8")[:12]
        for form, cast in (("NETCDF3_CLASSIC", "i4"), ("NETCDF3_64BIT_DATA", "i8")):
            path = self.dir / f"{form}.nc"
            write(netCDF4.Dataset(path, "w", format=form), frames, "f8", LJ, lammps=True, ids=cast)
            data = path.read_bytes()
            self.assertEqual(self.document("info", path)["frames"], 12)
            cut = self.dir / "cut.nc"
            seen = set()
            for size in [*range(4, len(data), len(data) // 40), len(data) - 4, len(data) - 1]:
                cut.write_bytes(data[:size])
                done = running.run("info", cut, "--json")
                if done.returncode == 1:
                    self.assertIn("the file ends within", done.stderr)
                    continue
                self.assertEqual(done.returncode, 3, done.stderr)
                document = running.parse_json(done.stdout)
                self.assertIn("the file ends within frame", "\n".join(document["warnings"]))
                seen.add(document["frames"])
            self.assertGreater(len(seen), 8)
            self.assertLess(max(seen), 12)

    def test_cut_tables_are_the_beginning(self):
        frames = text_frames("f8")
        path, cut = self.dir / "whole.nc", self.dir / "cut.nc"
        write(netcdf_file(path, "w", version=2), frames, "f8", LJ, lammps=True)
        data = path.read_bytes()
        whole = self.table("force", path, "--source", "forces", "--radius", "5")
        cut.write_bytes(data[:len(data) * 3 // 4])
        out = self.dir / "cut.csv"
        self.mdana("force", cut, "--source", "forces", "--radius", "5", "-o", out, code=3)
        part = running.read_csv(out)
        rows = len(part["time"])
        self.assertTrue(20 < rows < len(frames))
        for name in ("step", "time", "X", "F"):
            self.assertEqual(part[name], whole[name][:rows], name)


if __name__ == "__main__":
    unittest.TestCase.maxDiff = None
    running.main()
