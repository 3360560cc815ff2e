// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string_view>

#include "readers/dimension.hpp"
#include "readers/units.hpp"

namespace mdana::amber_netcdf {

using UnitSystems = std::set<Units>;

/// The unit systems of LAMMPS in which quantities of that dimension (length, time, velocity, force)
/// have the unit that an attribute names, as LAMMPS and AMBER write it; "lj" is that of any
/// quantity.
UnitSystems systems_with(mdana::Dimension dimension, std::string_view unit);

UnitSystems all_systems();

/// Those that are in both sets.
UnitSystems common(const UnitSystems& a, const UnitSystems& b);

/// The only one, if there is only one.
std::optional<Units> only(const UnitSystems& systems);

}  // namespace mdana::amber_netcdf
