// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/units.hpp"

namespace mdana {

/// Boltzmann's constant in the system's energy unit by its unit of temperature (K; in lj 1, with
/// temperatures in epsilon/k_B). The values are those that LAMMPS computes temperatures with.
double boltzmann(Units units);

/// Unit of temperature for axes and tables.
const char* temperature_symbol(Units units);

}  // namespace mdana
