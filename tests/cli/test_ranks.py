# SPDX-License-Identifier: GPL-3.0-or-later
"""Several processes share the work of a command: what they write is, to the last byte, what one writes alone."""

import gzip
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

import dumps
import running
import test_signals
from running import ROOT, SAMPLE, Case

RANKS, THREADS = (1, 2, 3, 5), (1, 2)
MPIRUN = shutil.which("mpirun")
GRAINS = ROOT / "sample-data" / "aggregate-tiny"
HERTZ = ROOT / "sample-data" / "hertz-tiny" / "dump.lammpstrj.gz"
CUT = 29  # whole frames before the damage, of 47
ENVIRONMENT = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def start(*programs):
    """mpirun of command lines, each as one rank, or (number, command line)."""
    line = []
    for entry in programs:
        ranks, arguments = entry if isinstance(entry[0], int) else (1, entry)
        line += [":"] * bool(line) + ["-n", str(ranks), *map(str, arguments)]
    return subprocess.run([MPIRUN, "--oversubscribe", "--bind-to", "none", *line], env=ENVIRONMENT, text=True, check=False,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300)


def balls(step, atoms, wrapped=False):
    """Two random balls, one of which lies across a face of the box, that come nearer; more atoms than a block has."""
    random = np.random.default_rng(step)
    points = random.normal(size=(atoms, 3))
    points *= (random.random((atoms, 1))**(1 / 3) / np.linalg.norm(points, axis=1, keepdims=True))
    body = np.arange(atoms) % 2
    points[:, 0] += np.where(body, 1, -1) * (1 - 0.05 * step) + 4.3
    velocity = random.normal(size=(atoms, 3)) * 0.01
    if wrapped:
        points %= 8
    rows = np.column_stack([np.arange(1, atoms + 1), body + 1, points, velocity])
    bounds = "pp pp pp" if wrapped else "ff ff ff"
    lines = "\n".join("%d %d %.6f %.6f %.6f %.6f %.6f %.6f" % tuple(row) for row in rows)
    return (f"ITEM: UNITS\nlj\nITEM: TIME\n{0.5 * step}\nITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{atoms}\n"
            f"ITEM: BOX BOUNDS {bounds}\n0 8\n0 8\n0 8\nITEM: ATOMS id type x y z vx vy vz\n{lines}\n")


def without_time(text):
    return re.sub(r'"(fit_)?seconds": [^,\n]*', "", text)


class Ranks(Case):
    @classmethod
    def setUpClass(cls):
        cls.texts = dumps.split(dumps.read_text(SAMPLE))
        cls.large = [balls(step, 150_000) for step in range(3)]

    def write(self, name, text):
        path = self.dir / name
        path.write_bytes(gzip.compress(text.encode(), 1) if name.endswith(".gz") else text.encode())
        return path

    def outcome(self, ranks, arguments, outputs):
        """Exit code, standard output without the time it took, own words on the standard error, and all files written."""
        place = self.dir / "out"
        place.mkdir()
        files = [argument for name, file in outputs.items() for argument in (name, place / file)]
        line = [running.program, *arguments, *files, "--json"]
        done = start((ranks, line)) if ranks else running.run(*line[1:])
        told = without_time(done.stdout)
        said = [text for text in done.stderr.splitlines() if text.startswith("mdana: ")]
        written = {file.name: without_time(file.read_text()) for file in place.iterdir()}
        shutil.rmtree(place)
        return done.returncode, told, said, written

    def assert_same(self, *arguments, outputs=None, ranks=RANKS, threads=THREADS, code=0):
        outputs = {"-o": "table.csv"} if outputs is None else outputs
        alone = self.outcome(0, [*arguments, "--threads", 1], outputs)
        self.assertEqual(alone[0], code, alone[2])
        for count in ranks:
            for each in threads:
                with self.subTest(f"{arguments[0]} on {count} ranks with {each} threads"):
                    shared = self.outcome(count, [*arguments, "--threads", each], outputs)
                    self.assertEqual(shared[::2], alone[::2])
                    self.assertEqual(sorted(shared[3]), sorted(alone[3]))
                    different = [name for name in alone[3] if shared[3][name] != alone[3][name]]
                    self.assertEqual((different, shared[1] == alone[1]), ([], True), f"{shared[1]}\n{alone[1]}")
        return alone

    def test_frames(self):
        for command in (["force", "--compare"], ["contact-radius"], ["energy"], ["compress"], ["collision"]):
            self.assert_same(command[0], SAMPLE, *command[1:], outputs={"-o": "out.json"}, ranks=(3,))
        self.assert_same("force", SAMPLE)
        self.assert_same("contact-radius", SAMPLE, "--frames", "3:40:2")
        self.assert_same("fit-hertz", HERTZ, ranks=(2,))
        self.assert_same("fit-force", HERTZ, "--law", "hertz", ranks=(2,), threads=(1,))

    def test_network(self):
        self.assert_same("network", GRAINS / "dump.lammpstrj.gz")
        self.assert_same("network", GRAINS / "dump.lammpstrj.gz", "--contacts", GRAINS / "contacts.dump.gz", ranks=(3,))

    def test_products_of_frames(self):
        outputs = {"-o": "out.json", "--dump": "labels.lammpstrj", "--vtp": "picture", "--ca": "lines", "--segments": "lines.csv"}
        alone = self.assert_same("defects", SAMPLE, "--frames", "10:35:5", "--csp", outputs=outputs)
        self.assertEqual(len(alone[3]), 3 + 5 * 4)

    def test_blocks_of_large_frames(self):
        dump = self.write("large.dump", "".join(self.large))
        self.assert_same("contact-radius", dump, "--radius", 1, "--layer", 0.1)
        self.assert_same("energy", self.write("large.dump.gz", "".join(self.large)), "--radius", 1, ranks=(3,))
        self.assert_same("contact-radius", dump, "--radius", 1, "--layer", 0.1, "--memory", "1M", ranks=(2,))

    def test_wrapped_positions(self):
        few = self.write("few.dump", "".join(balls(step, 150_000, wrapped=True) for step in range(2)))
        self.assert_same("contact-radius", few, "--radius", 1, "--layer", 0.1, ranks=(2, 3))
        many = self.write("many.dump", "".join(balls(step, 200, wrapped=True) for step in range(12)))
        self.assert_same("force", many, "--radius", 1, ranks=(5,))
        self.assert_same("defects", many, "--no-lines", "--spacing", 0.3, ranks=(5,), outputs={"--dump": "labels.dump"})

    def test_damage(self):
        bad = self.texts[CUT].replace(".", "!", 400).replace("!", ".", 399)
        turned_back = self.texts[CUT].replace("ITEM: TIMESTEP\n", "ITEM: TIMESTEP\n-")
        for name, text in [("cut", self.texts[CUT][:2000]), ("wrong number", bad + "".join(self.texts[CUT + 1:])),
                           ("step", turned_back + "".join(self.texts[CUT + 1:]))]:
            with self.subTest(name):
                dump = self.write("damaged.dump", "".join(self.texts[:CUT]) + text)
                self.assert_same("force", dump, "--radius", 5, "--units", "lj", code=3, ranks=(2, 5), threads=(2,))
                self.assert_same("force", dump, "--radius", 5, "--units", "lj", "--strict", code=1, ranks=(3,), threads=(1,))

    def test_damage_in_blocks(self):
        lines = self.large[2].splitlines(keepends=True)
        for at in (50_000, 140_000):
            lines[at] = lines[at].replace(".", "x", 1)
        dump = self.write("damaged.dump", "".join(self.large[:2]) + "".join(lines[:-5]))
        alone = self.assert_same("contact-radius", dump, "--radius", 1, "--layer", 0.1, code=3, threads=(1,))
        self.assertIn(f"damaged.dump:{2 * len(lines) + 50_001}", alone[1])

    def test_one_message_of_all(self):
        for arguments, code in ((["force", self.dir / "missing"], 1), (["force", SAMPLE, "--stride", 0], 2), (["info", SAMPLE], 2)):
            done = start((3, [running.program, *arguments]))
            self.assertEqual((done.returncode, done.stdout), (code, ""))
            self.assertEqual(done.stderr.count("mdana: "), 1, done.stderr)

    def test_a_rank_that_fails(self):
        """Frames before what it fails at are kept; nothing is if it has another input than the others."""
        out = self.dir / "table.csv"
        dump = self.write("large.dump", "".join(balls(step, 20_000) for step in range(3)))
        line = [running.program, "defects", dump, "--memory", "1M", "--spacing", "0.05", "-o", out, "--no-surface", "--no-lines",
                "--threads", "1", "--json"]
        done = start(line, ["env", f"TMPDIR={self.dir / 'nowhere'}", *line], line)
        self.assertEqual(done.returncode, 3, done.stderr)
        dump.unlink()
        self.assertIn("rank 1: ", done.stdout)
        self.assertEqual(len(out.read_text().splitlines()), 2)
        out.unlink()
        done = start([running.program, "force", SAMPLE, "-o", out], [running.program, "force", self.dir / "missing", "-o", out])
        self.assertEqual(done.returncode, 1)
        self.assertIn("mdana: rank 1: ", done.stderr)
        self.assertEqual(list(self.dir.iterdir()), [])

    def test_a_rank_that_dies(self):
        dump = self.write("large.dump", "".join(self.large))
        line = [running.program, "energy", dump, "--radius", "1", "-o", self.dir / "table.csv"]
        done = start(line, ["timeout", "--signal", "KILL", "0.2", *line])
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual([file.name for file in self.dir.iterdir()], ["large.dump"])

    def test_stop(self):
        dump = self.dir / "long.gz"
        test_signals.long_dump(dump)
        line = [MPIRUN, "--oversubscribe", "--bind-to", "none", "-n", "2", running.program, "energy", dump, "--radius", "5",
                "-o", self.dir / "table.csv"]
        with subprocess.Popen(line, env=ENVIRONMENT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True) as process:
            time.sleep(2)
            self.assertIsNone(process.poll(), "mdana ended before the signal")
            process.send_signal(signal.SIGTERM)
            out, _ = process.communicate(timeout=60)
        self.assertNotEqual(process.returncode, 0)
        self.assertEqual((out, os.listdir(self.dir)), ("", ["long.gz"]))


if __name__ == "__main__":
    if not MPIRUN:
        running.skip("no mpirun")
    if not Path(os.path.realpath(sys.argv[1])).with_name("libmdana_mpi.so").exists():
        running.skip("this build has no MPI")
    running.main()
