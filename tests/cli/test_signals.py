# SPDX-License-Identifier: GPL-3.0-or-later
"""SIGINT, SIGTERM and SIGUSR1 in the middle of a long sweep, and of a fit, which does not look at them: exit codes 130, 75 and
75, a word on the standard error, no file."""

import gzip
import os
import signal
import subprocess
import time
from pathlib import Path

import dumps
import running
from running import Case

ATOMS = 200_000
FRAMES = 600  # of 10 MB each, as text: at 1 GB/s still 6 s of reading; they compress to 80 kB each


def long_dump(path):
    """Every frame has the same atoms: gzip members that are made once and written again and again."""
    pair = dumps.two_cubes(0, 0.0, 12.0).without("fx", "fy", "fz")
    rows = pair.rows() * (ATOMS // len(pair.atoms))
    atoms = gzip.compress(rows.encode(), 6)
    with open(path, "wb") as file:
        for k in range(FRAMES):
            head = pair.head().replace("ITEM: NUMBER OF ATOMS\n16\n", f"ITEM: NUMBER OF ATOMS\n{ATOMS}\n")
            head = head.replace("ITEM: TIMESTEP\n0\n", f"ITEM: TIMESTEP\n{k}\n")
            head = head.replace("ITEM: TIME\n0.0\n", f"ITEM: TIME\n{k}\n")
            file.write(gzip.compress(head.encode()) + atoms)


class Signals(Case):
    def stop(self, number, *arguments):
        """The exit code and standard error after the signal, sent when the sweep has read a good part of the dump."""
        with subprocess.Popen([running.program, *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True) as process:
            try:
                self.wait_until_busy(process)
                process.send_signal(number)
                sent = time.monotonic()
                out, error = process.communicate(timeout=20)
                # A stop is looked for after each block of atoms, some milliseconds of work; 5 s is for a busy machine.
                self.assertLess(time.monotonic() - sent, 5)
            finally:
                process.kill()
        self.assertEqual(out, "")
        return process.returncode, error

    def wait_until_busy(self, process):
        """Until its handlers are there, and more was read than the looks at the first frame take."""
        place = Path("/proc") / str(process.pid)
        deadline = time.monotonic() + 20
        while time.monotonic() < deadline:
            self.assertIsNone(process.poll(), "mdana ended before the signal")
            status = dict(line.split(":", 1) for line in (place / "status").read_text().splitlines() if ":" in line)
            caught = int(status["SigCgt"], 16)
            read = int((place / "io").read_text().split()[1])  # rchar
            if caught >> (signal.SIGINT - 1) & caught >> (signal.SIGTERM - 1) & caught >> (signal.SIGUSR1 - 1) & 1 and read > 2_000_000:
                return
            time.sleep(0.01)
        self.fail("mdana did not begin to read within 20 s")

    def test_exit_codes(self):
        dump = self.dir / "long.gz"
        long_dump(dump)
        for number, code, commands in ((signal.SIGINT, 130, ("info", "check", "force", "contact-radius", "fit-hertz")),
                                       (signal.SIGTERM, 75, ("info", "check", "force", "contact-radius", "fit-hertz")),
                                       (signal.SIGUSR1, 75, ("check", "force"))):
            for command in commands:
                with self.subTest(f"{signal.Signals(number).name} {command}"):
                    done, error = self.stop(number, command, dump, "--json", "-o", self.dir / "out.json")
                    self.assertEqual(done, code, error)
                    self.assertIn("nothing was written", error)
                    self.assertEqual(os.listdir(self.dir), ["long.gz"])

    def test_a_fit_is_ended_after_ten_seconds(self):
        table = running.ROOT / "sample-data" / "restitution.csv"
        with subprocess.Popen([running.program, "fit-contact", "--law", "krijt", table, "--table2", "--per-radius", "T_vis", "--bootstrap",
                               "100000", "-o", self.dir / "out.json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            try:
                time.sleep(2)
                process.send_signal(signal.SIGUSR1)
                out, error = process.communicate(timeout=30)
            finally:
                process.kill()
        self.assertEqual(process.returncode, 75, error)
        self.assertEqual((out, error), ("", "mdana: stopped\n"))
        self.assertEqual(os.listdir(self.dir), [])


if __name__ == "__main__":
    if not os.path.exists("/proc/self/io"):
        running.skip("no /proc/PID/io to see by how far the program is")
    running.main()
