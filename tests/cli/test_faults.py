# SPDX-License-Identifier: GPL-3.0-or-later
"""Disks that are full, outputs that vanish, inputs that change while they are read: a clear error, and nothing half
written is left or believed."""

import os
import resource
import shutil
import signal
import subprocess
import time
from pathlib import Path

import dumps
import running
import studies
from running import SAMPLE, Case

LIMIT = 4096  # bytes of a file: less than any of the outputs


def small_files():
    """As on a full disk: no file grows beyond LIMIT."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (LIMIT, LIMIT))


class FullDisk(Case):
    def refuse(self, *arguments, output):
        """Fails, names the output, leaves what was there."""
        before = {path: path.read_bytes() for path in self.dir.iterdir() if path.is_file()}
        done = running.run(*arguments, preexec_fn=small_files)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(str(output), done.stderr)
        self.assertIn("File too large", done.stderr)
        self.assertEqual({path: path.read_bytes() for path in self.dir.iterdir() if path.is_file()}, before)

    def test_nothing_half_written(self):
        outputs = {"force.csv": ["force", SAMPLE, "-o"], "force.h5": ["force", SAMPLE, "-o"],
                   "labelled.lammpstrj": ["defects", SAMPLE, "--frames", "last", "--dump"],
                   "out.lammpstrj": ["convert", SAMPLE, "-o"], "out.lammpstrj.gz": ["convert", SAMPLE, "-o"],
                   "out.h5": ["convert", SAMPLE, "-o"]}
        for name, arguments in outputs.items():
            for before in (None, b"an older result"):
                with self.subTest(f"{name} {'anew' if before is None else 'over an older one'}"):
                    output = self.dir / name
                    if before is not None:
                        output.write_bytes(before)
                    self.refuse(*arguments, output, output=output)
                    output.unlink(missing_ok=True)

    def test_an_output_that_cannot_be_made_is_told_before_anything_is_computed(self):
        missing = self.dir / "missing" / "force.csv"
        done = running.run("force", SAMPLE, "-o", missing)
        self.assertEqual(done.returncode, 1)
        self.assertIn(str(missing.parent), done.stderr)


class ChangingInput(Case):
    FRAMES, ATOMS = 60, 20_000  # 1 MB each: a tenth of a second

    def setUp(self):
        super().setUp()
        pair = dumps.two_cubes(0, 0.0, 12.0).without("fx", "fy", "fz")
        self.rows = pair.rows() * (self.ATOMS // len(pair.atoms))
        self.head = pair.head().replace("ITEM: NUMBER OF ATOMS\n16\n", f"ITEM: NUMBER OF ATOMS\n{self.ATOMS}\n")
        self.dump = self.dir / "dump.lammpstrj"
        self.write()

    def frame(self, k):
        return self.head.replace("ITEM: TIMESTEP\n0\n", f"ITEM: TIMESTEP\n{k}\n").replace("ITEM: TIME\n0.0\n", f"ITEM: TIME\n{k}\n") + self.rows

    def write(self):
        with open(self.dump, "w", encoding="utf-8") as file:
            for k in range(self.FRAMES):
                file.write(self.frame(k))

    def in_the_middle(self, change, *arguments):
        """mdana stopped so many milliseconds after it began to read, and going on after the change."""
        for milliseconds in (0, 2, 5, 10, 20, 30, 40, 60, 80, 100):
            self.write()
            with subprocess.Popen([running.program, *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True) as process:
                self.wait_until_reading(process)
                time.sleep(milliseconds / 1000)
                process.send_signal(signal.SIGSTOP)
                change()
                process.send_signal(signal.SIGCONT)
                out, error = process.communicate(timeout=running.SECONDS)
            yield process.returncode, out, error

    def wait_until_reading(self, process):
        maps = Path("/proc") / str(process.pid) / "maps"
        deadline = time.monotonic() + 20
        while time.monotonic() < deadline and process.poll() is None and str(self.dump) not in maps.read_text():
            time.sleep(0.001)

    def test_cut(self):
        told = 0
        for code, out, error in self.in_the_middle(lambda: os.truncate(self.dump, 3_000_000), "energy", self.dump, "--bodies", "type",
                                                 "--threads", "1"):
            self.assertIn(code, (0, 1, 3), error)
            self.assertTrue(code == 0 or str(self.dump) in error + out, error + out)
            told += code == 1 and "cut it while it was read" in error
        self.assertGreater(told, 0, "no run was cut while it read")

    def test_written_to(self):
        def append():
            with open(self.dump, "a", encoding="utf-8") as file:
                file.write(self.frame(self.FRAMES))
        told = 0
        for code, out, error in self.in_the_middle(append, "energy", self.dump, "--bodies", "type", "--threads", "1"):
            self.assertIn(code, (0, 3), error)
            told += "changed while it was read" in out
        self.assertGreater(told, 0, "no run saw the change")

    def test_replaced(self):
        """By another file of the same name, as editors and rsync do: what was opened is read to its end."""
        whole = self.document("energy", self.dump, "--bodies", "type")["frames"]
        def replace():
            other = self.dir / "other"
            other.write_text(self.frame(0), encoding="utf-8")
            os.replace(other, self.dump)
        frames = set()
        for code, out, error in self.in_the_middle(replace, "energy", self.dump, "--bodies", "type", "--json"):
            self.assertIn(code, (0, 1), error)
            if code == 0:
                frames.add(running.parse_json(out)["frames"])
        self.assertLessEqual(frames, {whole, 1})


class Studies(studies.Study):
    def test_output_removed_meanwhile(self):
        study = self.study()
        for milliseconds in (30, 100, 200, 300):
            shutil.rmtree(self.out, ignore_errors=True)
            with subprocess.Popen([running.program, "report", study, "-o", self.out], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True) as process:
                time.sleep(milliseconds / 1000)
                shutil.rmtree(self.out, ignore_errors=True)
                _, error = process.communicate(timeout=running.SECONDS)
            self.assertGreaterEqual(process.returncode, 0, error)  # no crash
            self.assertTrue(process.returncode == 0 or str(self.out) in error, error)
            shutil.rmtree(self.out, ignore_errors=True)  # what was written behind the removal is no report
            self.report()


if __name__ == "__main__":
    if not os.path.exists("/proc/self/maps"):
        running.skip("no /proc/PID/maps to see that the program reads")
    running.main()
