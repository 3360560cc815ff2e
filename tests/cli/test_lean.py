# SPDX-License-Identifier: GPL-3.0-or-later
"""What a build leaves out by its lists, it does not look for: the preset `lean` (see tests/long/test_lean_build.py, which
builds it)."""

import subprocess
from pathlib import Path

import running
from running import ROOT

LOOKED_FOR = ("CGAL_DIR", "HDF5_C_", "NETCDF_LIBRARY", "MPI_")


def looked_for(cache):
    text = Path(cache).read_text(encoding="utf-8")
    return {name for name in LOOKED_FOR if any(line.startswith(name) for line in text.splitlines())}


class Lean(running.Case):
    def test_configuring_does_not_look_for_libraries_that_are_not_needed(self):
        done = subprocess.run(["cmake", "--preset", "lean", "-S", ROOT, "-B", self.dir / "lean"], cwd=ROOT, text=True,
                              capture_output=True, timeout=300, check=False)
        if "unrecognized" in done.stderr.lower() or "No such preset" in done.stderr:
            self.fail(done.stderr)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(looked_for(self.dir / "lean" / "CMakeCache.txt"), set())

    def test_the_whole_build_does(self):
        """Else the test before would say nothing."""
        cache = Path(running.program).parent / "CMakeCache.txt"
        if not cache.is_file():
            self.skipTest("mdana does not stand in its build directory")
        self.assertLessEqual({"CGAL_DIR", "HDF5_C_"}, looked_for(cache))


if __name__ == "__main__":
    running.main()
