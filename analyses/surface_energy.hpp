// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "analyses/analysis.hpp"
#include "analyses/value.hpp"

namespace mdana {

struct EnergyParts {
  std::string potential;  ///< column with the potential energy of an atom; empty: not summed
  bool thermal = false;   ///< from velocities
};

/// Energies of bodies 1 and 2: the sum of the atoms' potential energies, and half the sum of
/// m (v - V)^2 about the body's velocity V (in mass velocity^2: see force_per_mass_acceleration).
/// Columns for b = 1, 2: count<b> [potential<b>] [thermal<b>] [energy].
/// Throws InputError if a value is not finite.
std::unique_ptr<Analysis> make_surface_energy(EnergyParts parts);

/// gamma = excess/(4 pi R^2), excess = U - N e_1; P1 C1. Its error follows from theirs.
Value surface_energy(const Value& excess, const Value& radius);

}  // namespace mdana
