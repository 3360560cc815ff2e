// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/units.hpp"

#include <array>

#include <fmt/format.h>

namespace mdana {
namespace {

struct System {
  Units units;
  std::string_view name, mass, length, time, force, energy;
  double mvv2e;  // LAMMPS, update.cpp: Update::set_units
};

constexpr double real_mvv2e = 48.88821291 * 48.88821291;

constexpr std::array<System, 8> systems{{
    {Units::lj, "lj", "m", "σ", "τ", "ε/σ", "ε", 1.0},
    {Units::real, "real", "g/mol", "Å", "fs", "kcal/mol/Å", "kcal/mol", real_mvv2e},
    {Units::metal, "metal", "g/mol", "Å", "ps", "eV/Å", "eV", 1.0364269e-4},
    {Units::si, "si", "kg", "m", "s", "N", "J", 1.0},
    {Units::cgs, "cgs", "g", "cm", "s", "dyn", "erg", 1.0},
    {Units::electron, "electron", "u", "bohr", "fs", "Ha/bohr", "Ha", 1.06657236},
    {Units::micro, "micro", "pg", "µm", "µs", "pg·µm/µs²", "pg·µm²/µs²", 1.0},
    {Units::nano, "nano", "ag", "nm", "ns", "ag·nm/ns²", "ag·nm²/ns²", 1.0},
}};

const System& system_of(Units units) { return systems[static_cast<std::size_t>(units)]; }

std::string power(std::string_view symbol, int exponent) {
  if (exponent == 0) return {};
  if (exponent == 1) return std::string(symbol);
  return fmt::format("{}^{}", symbol, exponent);
}

std::string product(const System& s, Dimension d) {
  std::string text;
  for (const std::string& factor :
       {power(s.mass, d.mass), power(s.length, d.length), power(s.time, d.time)})
    if (!factor.empty()) text += (text.empty() ? "" : " ") + factor;
  return text;
}

}  // namespace

std::optional<Units> parse_units(std::string_view name) {
  for (const System& s : systems)
    if (s.name == name) return s.units;
  return std::nullopt;
}

std::string_view name(Units units) { return system_of(units).name; }

std::string units_names() {
  std::string text;
  for (const System& s : systems) text += (text.empty() ? "" : ", ") + std::string(s.name);
  return text;
}

double force_per_mass_acceleration(Units units) { return system_of(units).mvv2e; }

std::string symbol(Units units, Dimension d) {
  const System& s = system_of(units);
  if (d == dimension::force) return std::string(s.force);
  if (d == dimension::energy) return std::string(s.energy);
  if (d == dimension::velocity) return fmt::format("{}/{}", s.length, s.time);
  if (d == dimension::pressure)
    return units == Units::si ? "Pa" : fmt::format("{}/{}^3", s.energy, s.length);
  if (d == dimension::surface_energy) return fmt::format("{}/{}^2", s.energy, s.length);
  return product(s, d);
}

}  // namespace mdana
