// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "readers/dimension.hpp"

namespace mdana {

/// The unit systems of LAMMPS (its command `units`). They are stated by the dump, the scene file or
/// an option, never guessed.
enum class Units { lj, real, metal, si, cgs, electron, micro, nano };

/// The system of that name; nothing if there is none.
std::optional<Units> parse_units(std::string_view name);

std::string_view name(Units units);

/// All names, for messages: "lj, real, metal, ...".
std::string units_names();

/// Force in the system's force unit of one mass unit accelerated by one length/time^2 (LAMMPS:
/// mvv2e; 1 in systems whose units are consistent). The values are those that LAMMPS integrates
/// with, so that forces from velocities agree with the forces that it prints.
double force_per_mass_acceleration(Units units);

/// Symbol for axes and tables, e.g. "eV/Å" for a force in metal units; empty if dimensionless.
std::string symbol(Units units, Dimension dimension);

}  // namespace mdana
