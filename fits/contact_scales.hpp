// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fits/collision_law.hpp"
#include "fits/dual.hpp"

namespace mdana {

/// A number with its derivatives by all that a law is given: R*, m*, E*, v, then the law's values.
inline constexpr int most_parameters = 12;
using Parameter = Dual<most_parameters>;

/// A law's input as numbers that know their derivatives.
struct LawInput {
  explicit LawInput(const CollisionInput& input);
  Parameter radius, mass, modulus, velocity;
  std::vector<Parameter> values;
};

/// What one is in scaled variables.
struct ContactScales {
  bool adhesive = true;  ///< p_c/E* = pressure (u - 1/(3 sqrt u)), else pressure u
  Parameter delta, time, radius, force, pressure, modulus;

  Parameter speed() const { return delta / time; }
  double centre_pressure(double u) const;  ///< [pressure]
};

/// a_0, delta_0, F_c (P1 eq. 8), tau = sqrt(m* delta_0/F_c), P = 2 a_0/(pi R*).
ContactScales jkr_scales(const LawInput& input, const Parameter& surface_energy);
/// d with E* sqrt(R*) d^2.5 = m* v^2, time d/v, radius sqrt(R* d): the impact speed is 1.
ContactScales hertz_scales(const LawInput& input);

}  // namespace mdana
