# SPDX-License-Identifier: GPL-3.0-or-later
"""The JSON documents: one on the standard output, with the names that other programs rely on."""

import ctypes
import ctypes.util
import re
import subprocess
import time

import dumps
import running
from running import SAMPLE, Case


class Digest(ctypes.Structure):
    _fields_ = [("low", ctypes.c_uint64), ("high", ctypes.c_uint64)]


def xxh3(data):
    """XXH3-128 of the bytes in one go, by python3-xxhash or else the C library; None if neither is there."""
    try:
        import xxhash

        return "xxh3:" + xxhash.xxh3_128_hexdigest(data)
    except ImportError:
        name = ctypes.util.find_library("xxhash")
    if not name:
        return None
    function = ctypes.CDLL(name).XXH3_128bits
    function.restype, function.argtypes = Digest, [ctypes.c_char_p, ctypes.c_size_t]
    digest = function(data, len(data))
    return f"xxh3:{digest.high:016x}{digest.low:016x}"


class Documents(Case):
    COMMANDS = ("info", "force", "contact-radius", "fit-hertz")

    def assert_number(self, number, *, estimated=False):
        """{value, error}: finite, the error null or not negative."""
        self.assertLessEqual({"value", "error"}, set(number))
        self.assertIsInstance(number["value"], (int, float))
        if estimated or number["error"] is not None:
            self.assertGreaterEqual(number["error"], 0)

    def test_every_document(self):
        version = self.mdana("--version").stdout.split()[1]
        data = SAMPLE.read_bytes()
        for command in self.COMMANDS:
            with self.subTest(command):
                started = time.monotonic()
                document = self.document(command, SAMPLE)
                wall = time.monotonic() - started
                self.assertEqual(document["command"], command)
                self.assertEqual(document["mdana_version"], version)
                self.assertEqual(document["units"], "lj")
                self.assertGreater(document["seconds"], 0)
                self.assertLess(document["seconds"], wall)
                self.assertEqual([type(w) for w in document["warnings"]], [str] * len(document["warnings"]))
                [record] = document["inputs"]
                self.assertEqual(record["path"], str(SAMPLE))
                self.assertEqual(record["size"], len(data))
                self.assertRegex(record["hash"], r"\Axxh3:[0-9a-f]{32}\Z")
                if (known := xxh3(data)) is not None:
                    self.assertEqual(record["hash"], known)

    def test_hash_is_of_the_bytes_on_disk(self):
        """Also of a plain file longer than any buffer, and of one with something behind the last whole frame."""
        if xxh3(b"") is None:
            self.skipTest("no xxhash")
        whole = dumps.read_text(SAMPLE)
        for name, text in (("plain", whole), ("blank", whole + "\n \n"), ("cut", whole[:-1000])):
            with self.subTest(name):
                path = self.dir / f"{name}.dump"
                path.write_text(text, encoding="utf-8")
                for command in ("info", "force"):
                    document = self.document(command, path, code=3 if name == "cut" else 0)
                    self.assertEqual(document["inputs"][0]["hash"], xxh3(path.read_bytes()))
                    self.assertEqual(document["inputs"][0]["size"], path.stat().st_size)

    def test_info(self):
        frames = dumps.read(SAMPLE)
        document = self.document("info", SAMPLE)
        self.assertEqual(document["frames"], len(frames))
        self.assertEqual(document["atoms"], [1206, 1206])
        self.assertEqual(document["columns"], frames[0].columns)
        self.assertEqual(document["steps"], [frames[0].step, frames[-1].step])
        self.assertEqual(document["body_count"], 2)
        self.assertEqual(document["box"]["origin"], [-38.4, -25, -25])
        self.assertEqual(document["box"]["edges"], [[76.8, 0, 0], [0, 50, 0], [0, 0, 50]])
        self.assertEqual(document["box"]["periodic"], [False] * 3)

    def test_info_without_units(self):
        """A dump that nothing can be computed from has the names of every document all the same; units are null."""
        path = self.dir / "bare.dump"
        path.write_text(dumps.read_text(SAMPLE).replace("ITEM: UNITS\nlj\n", ""), encoding="utf-8")
        document = self.document("info", path)
        self.assertLessEqual({"mdana_version", "inputs", "seconds", "warnings", "frames", "columns"}, set(document))
        self.assertIn("--units", document["left_out"][0]["reason"])
        self.assertIn("units", document)
        self.assertIsNone(document["units"])

    def test_force(self):
        document = self.document("force", SAMPLE)
        self.assertIn(document["outcome"], ("bounce", "stick", "unresolved"))
        for name in ("F_max", "F_min_loading", "delta_max", "hysteresis_area"):
            self.assert_number(document[name], estimated=True)
        self.assertEqual(document["force_source"], "velocities")
        self.assertTrue(document["radius_source"].startswith("scene"))
        self.assertEqual(self.document("force", SAMPLE, "--radius", "5")["radius_source"], "option")

    def test_contact_radius(self):
        numbers = self.document("contact-radius", SAMPLE)["contact_radius"]["gyration"]
        for name in ("max", "at_delta_max", "end"):
            self.assert_number(numbers[name])
        self.assertGreaterEqual(numbers["max"]["value"], numbers["at_delta_max"]["value"])

    def test_fit_hertz(self):
        document = self.document("fit-hertz", SAMPLE)
        for name in ("E_star", "R"):
            number = document[name]
            self.assert_number(number, estimated=True)
            spread = number["spread"]
            self.assertLessEqual(spread["min"], number["value"])
            self.assertGreaterEqual(spread["max"], number["value"])
            # The published error is at least the spread and the standard error (issue: the spread is the real error).
            self.assertGreaterEqual(number["error"], spread["deviation"])
            self.assertGreaterEqual(number["error"], number["standard_error"])
        self.assertEqual(document["method"], "force")
        self.assertEqual(document["min_force_fraction"], 0.05)
        self.assertEqual(document["max_force_fraction"], 1)
        self.assertEqual(document["phase"], "loading")
        self.assertEqual(document["points"], len(self.table("fit-hertz", SAMPLE)["F"]))
        self.assertTrue(any("adhesi" in w for w in document["warnings"]), "a Hertz fit of an adhesive scene")

    def test_fit_hertz_settings(self):
        """They are in the document, and an exact Hertz force gives its E* and R back whatever they are. Tolerance: the
        sums of forces and positions are rounded at 1e-16 of about 100; at the smallest forces kept that is 1e-12."""
        path = dumps.write(self.dir / "hertz.dump", dumps.hertz_bounce(modulus=60, radius=5))
        for method in ("force", "linear"):
            for phase in ("loading", "all"):
                for loss in ("none", "huber", "cauchy"):
                    with self.subTest(f"{method} {phase} {loss}"):
                        document = self.document("fit-hertz", path, "--method", method, "--phase", phase, "--loss",
                                                 loss, "--min-force-fraction", 0.1, "--max-force-fraction", 0.9)
                        self.assertEqual([document[n] for n in ("method", "phase", "loss", "min_force_fraction",
                                                                "max_force_fraction", "force_source")],
                                         [method, phase, loss, 0.1, 0.9, "forces"])
                        self.assertAlmostEqual(document["E_star"]["value"], 60, delta=60e-10)
                        self.assertAlmostEqual(document["R"]["value"], 5, delta=5e-10)

    def test_json_file_is_what_is_printed(self):
        for command in self.COMMANDS:
            with self.subTest(command):
                out = self.dir / f"{command}.json"
                done = self.mdana(command, SAMPLE, "--json", "-o", out)
                self.assertEqual(out.read_text(encoding="utf-8"), done.stdout)
                running.parse_json(done.stdout)

    def test_terminal_shows_the_same_numbers(self):
        """To the digits it prints: the value is within half a unit of the last one, the unit stands behind."""
        document = self.document("force", SAMPLE)
        text = self.mdana("force", SAMPLE).stdout
        for name, unit in (("F_max", "ε/σ"), ("delta_max", "σ"), ("hysteresis_area", "ε")):
            found = re.search(rf"(?m)^{name} +(-?[\d.]+) ± ([\d.]+) {unit}$", text)
            self.assertIsNotNone(found, f"{name} in\n{text}")
            for shown, exact in zip(found.groups(), (document[name]["value"], document[name]["error"])):
                digits = len(shown.partition(".")[2])
                self.assertLessEqual(abs(float(shown) - exact), 0.5000001 * 10**-digits)
        self.assertIn(document["outcome"], text)
        self.assertIn("warning: ", self.mdana("fit-hertz", SAMPLE).stdout)

    def test_a_path_that_is_not_utf8(self):
        """Linux file names are bytes; the document must still be JSON, or the refusal say why."""
        name = str(self.dir).encode() + b"/d\xfcmp.gz"
        with open(name, "wb") as file:
            file.write(SAMPLE.read_bytes())
        done = subprocess.run([running.program.encode(), b"force", name, b"--json"], capture_output=True, check=False,
                              timeout=running.SECONDS)
        if done.returncode == 0:
            running.parse_json(done.stdout.decode())
        else:
            self.assertNotIn(b"json.exception", done.stderr)


if __name__ == "__main__":
    running.main()
