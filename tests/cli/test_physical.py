# SPDX-License-Identifier: GPL-3.0-or-later
"""Results in SI besides those in units lj: --physical."""

import dumps
import running
from running import SAMPLE, Case

# Argon of Table I by hand: 39.95 g/mol, 0.341 nm, 10.32 meV with the SI's N_A and e.
MASS, SIGMA, EPSILON = 0.03995 / 6.02214076e23, 0.341e-9, 10.32e-3 * 1.602176634e-19
UNITS = {"N": EPSILON / SIGMA, "m": SIGMA, "J": EPSILON, "Pa": EPSILON / SIGMA**3, "J/m^2": EPSILON / SIGMA**2}


def numbers(node, name=""):
    """Every {value, error} of a document by its name."""
    if isinstance(node, dict) and "value" in node and "error" in node and not name.endswith(".si"):
        yield name, node
    elif isinstance(node, dict) and name != ".physical":
        for key, inner in node.items():
            yield from numbers(inner, f"{name}.{key}")


class Physical(Case):
    def check(self, document, wanted):
        """Each number has its SI value, by hand, with the unit that is wanted of it."""
        found = dict(numbers(document))
        self.assertLessEqual(set(wanted), set(found))
        for name, unit in wanted.items():
            number, si = found[name], found[name]["si"]
            self.assertEqual(si["unit"], unit, name)
            self.assertAlmostEqual(si["value"] / (number["value"] * UNITS[unit]), 1, delta=1e-12)
            if number["error"] is None:
                self.assertIsNone(si["error"])
            else:
                self.assertAlmostEqual(si["error"], number["error"] * UNITS[unit], delta=1e-12 * abs(si["error"]))

    def test_commands(self):
        self.check(self.document("force", SAMPLE, "--physical", "argon"),
                   {".F_max": "N", ".F_min_loading": "N", ".delta_max": "m", ".hysteresis_area": "J",
                    ".radius_sum": "m"})
        self.check(self.document("contact-radius", SAMPLE, "--physical", "argon"),
                   {".contact_radius.gyration.max": "m", ".contact_radius.gyration.end": "m"})
        self.check(self.document("fit-hertz", SAMPLE, "--physical", "argon"), {".E_star": "Pa", ".R": "m"})
        surface = self.document("surface-energy", SAMPLE, "--frames", "0:1", "--energy", "-4000", "--physical", "argon")
        self.check(surface, {".gamma.cut": "J/m^2", ".gamma.volume": "J/m^2", ".e_1": "J", ".bulk_modulus": "Pa"})

    def test_numbers_in_lj_stay(self):
        plain, physical = (dict(numbers(self.document("fit-hertz", SAMPLE, *more)))
                           for more in ((), ("--physical", "silver")))
        self.assertEqual(set(plain), set(physical))
        for name, number in plain.items():
            self.assertNotIn("si", number)
            self.assertEqual({key: value for key, value in physical[name].items() if key != "si"}, number)

    def test_material_is_told(self):
        document = self.document("force", SAMPLE, "--physical", "argon")
        told = document["physical"]
        self.assertEqual(told["name"], "argon")
        self.assertIn("Table I", told["source"])
        self.assertAlmostEqual(told["mass"]["value"] / MASS, 1, delta=1e-12)
        self.assertAlmostEqual(told["time"]["value"] * 1e12, 2.16, delta=0.005)
        self.assertAlmostEqual(told["velocity"]["value"], 158, delta=0.5)
        given = self.document("force", SAMPLE, "--physical", f"m={MASS!r},sigma=0.341nm,epsilon=10.32meV")
        self.assertAlmostEqual(given["F_max"]["si"]["value"] / document["F_max"]["si"]["value"], 1, delta=1e-12)

    def test_terminal_shows_both(self):
        text = self.mdana("force", SAMPLE, "--physical", "argon").stdout
        self.assertRegex(text, r"(?m)^F_max +106\.1 ± 5\.6 ε/σ \(5\.14\d*e-10 ± 2\.7e-11 N\)$")
        self.assertRegex(text, r"(?m)^physical +argon: ")

    def test_only_for_units_lj(self):
        path = dumps.write(self.dir / "metal.dump", [dumps.replace(f, units="metal") for f in dumps.read(SAMPLE)])
        self.refused("force", path, "--masses", "1=1,2=1", "--timestep", "0.1", "--physical", "argon", code=1,
                     says=["--physical", "metal"])

    def test_unknown_materials_are_refused(self):
        for text in ("gold", "m=1,sigma=1", "m=1,sigma=1,epsilon=1pound"):
            self.refused("force", SAMPLE, "--physical", text, code=2, says=[text])


if __name__ == "__main__":
    running.main()
