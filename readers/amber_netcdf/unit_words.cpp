// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/amber_netcdf/unit_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <string>

namespace mdana::amber_netcdf {
namespace {

using enum Units;

/// Units in lower case without blanks, brackets and the s of the plural.
struct System {
  Units units;
  std::string_view length, time, force;
};

// LAMMPS, command `units`.
constexpr std::array<System, 8> systems{{
    {lj, "lj", "lj", "lj"},
    {real, "angstrom", "femtosecond", "kcal/mol/angstrom"},
    {metal, "angstrom", "picosecond", "ev/angstrom"},
    {si, "meter", "second", "newton"},
    {cgs, "centimeter", "second", "dyne"},
    {electron, "bohr", "femtosecond", "hartree/bohr"},
    {micro, "micrometer", "microsecond", "picogram*micrometer/microsecond^2"},
    {nano, "nanometer", "nanosecond", "attogram*nanometer/nanosecond^2"},
}};

std::string plain(std::string_view unit) {
  std::string text;
  for (const char c : unit) {
    if (c == '/' && text.ends_with('s')) text.pop_back();
    if (std::string_view(" ()").find(c) == std::string_view::npos)
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  if (text.ends_with('s')) text.pop_back();
  return text == "kilocalorie/mole/angstrom" ? "kcal/mol/angstrom" : text;  // AMBER's word
}

std::string unit_of(const System& system, mdana::Dimension dimension) {
  if (dimension == dimension::length) return std::string(system.length);
  if (dimension == dimension::time) return std::string(system.time);
  if (dimension == dimension::force) return std::string(system.force);
  if (system.units == lj) return "lj";
  if (system.units == electron) return "bohr/atomictimeunit";
  return std::string(system.length) + "/" + std::string(system.time);
}

}  // namespace

UnitSystems systems_with(mdana::Dimension dimension, std::string_view unit) {
  UnitSystems found;
  for (const System& system : systems)
    if (unit_of(system, dimension) == plain(unit)) found.insert(system.units);
  return found;
}

UnitSystems all_systems() {
  UnitSystems all;
  for (const System& system : systems) all.insert(system.units);
  return all;
}

UnitSystems common(const UnitSystems& a, const UnitSystems& b) {
  UnitSystems both;
  std::ranges::set_intersection(a, b, std::inserter(both, both.end()));
  return both;
}

std::optional<Units> only(const UnitSystems& systems) {
  if (systems.size() != 1) return std::nullopt;
  return *systems.begin();
}

}  // namespace mdana::amber_netcdf
