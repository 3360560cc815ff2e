// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/physical.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

// SI, exact since 2019
constexpr double avogadro = 6.02214076e23;
constexpr double electronvolt = 1.602176634e-19;
constexpr double boltzmann = 1.380649e-23;

struct Material {
  std::string_view name;
  double mass;    // g/mol
  double length;  // nm
  double energy;  // meV
  std::string_view source;
};

constexpr std::array<Material, 3> materials{{
    {"argon", 39.95, 0.341, 10.32, "Michels, Wijker & Wijker 1949"},
    {"water", 18.02, 0.319, 53, "Hirschfelder, Curtiss & Bird 1967"},
    {"silver", 107.87, 0.2644, 345, "Halicioglu & Pound 1975"},
}};

struct UnitName {
  std::string_view name;
  double si;
};

constexpr std::array<UnitName, 5> mass_units{{{"", 1}, {"kg", 1}, {"g", 1e-3},
                                              {"g/mol", 1e-3 / avogadro}, {"u", 1.66053906660e-27}}};
constexpr std::array<UnitName, 4> length_units{{{"", 1}, {"m", 1}, {"nm", 1e-9}, {"A", 1e-10}}};
constexpr std::array<UnitName, 5> energy_units{{{"", 1}, {"J", 1}, {"eV", electronvolt},
                                                {"meV", 1e-3 * electronvolt}, {"K", boltzmann}}};

PhysicalUnits units_of(const Material& m) {
  return {std::string(m.name),
          fmt::format("Yoshida, Kokubo & Tanaka 2024, Table I, after {}", m.source),
          m.mass * 1e-3 / avogadro, m.length * 1e-9, m.energy * 1e-3 * electronvolt};
}

/// "10.32meV" in SI. Throws InputError.
template <std::size_t Size>
double quantity(std::string_view text, const std::array<UnitName, Size>& units,
                const std::string& whole) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view unit = text.substr(static_cast<std::size_t>(rest - text.data()));
  std::string known;
  for (const UnitName& u : units) {
    const double si = value * u.si;
    if (error == std::errc{} && unit == u.name && std::isfinite(si) && si > 0) return si;
    if (!u.name.empty()) known += (known.empty() ? "" : ", ") + std::string(u.name);
  }
  throw InputError(fmt::format("physical '{}': '{}' is not a number greater than zero, with one of "
                               "the units {} or none", whole, text, known));
}

[[noreturn]] void fail(const std::string& text) {
  throw InputError(fmt::format("physical '{}': argon, water, silver or "
                               "m=...,sigma=...,epsilon=... expected, each once", text));
}

/// Sets one of the three, which must not have been set.
void put(PhysicalUnits& units, std::string_view part, const std::string& text) {
  const std::size_t equals = part.find('=');
  if (equals == std::string_view::npos) fail(text);
  const std::string_view name = part.substr(0, equals), value = part.substr(equals + 1);
  if (name == "m" && units.mass == 0) units.mass = quantity(value, mass_units, text);
  else if (name == "sigma" && units.length == 0) units.length = quantity(value, length_units, text);
  else if (name == "epsilon" && units.energy == 0)
    units.energy = quantity(value, energy_units, text);
  else fail(text);
}

}  // namespace

double PhysicalUnits::time() const { return length * std::sqrt(mass / energy); }

double PhysicalUnits::of(Dimension d) const {
  return std::pow(mass, d.mass) * std::pow(length, d.length) * std::pow(time(), d.time);
}

PhysicalUnits parse_physical(const std::string& text) {
  for (const Material& m : materials)
    if (m.name == text) return units_of(m);
  PhysicalUnits units{"as given", "option", 0, 0, 0};
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    put(units, rest.substr(0, comma), text);
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  if (units.mass == 0 || units.length == 0 || units.energy == 0) fail(text);
  return units;
}

}  // namespace mdana
