// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "readers/dimension.hpp"

namespace mdana {

/// What the units lj stand for in a material.
struct PhysicalUnits {
  std::string name;    ///< "argon", or "as given"
  std::string source;  ///< of the three values
  double mass = 0;     ///< m [kg]
  double length = 0;   ///< sigma [m]
  double energy = 0;   ///< epsilon [J]

  double time() const;           ///< tau = sigma sqrt(m/epsilon) [s]
  double of(Dimension d) const;  ///< a quantity of this dimension that is 1 in units lj [SI]
};

/// "argon", "water" or "silver" (Yoshida, Kokubo & Tanaka 2024, Table I), or
/// "m=39.95g/mol,sigma=0.341nm,epsilon=10.32meV"; numbers without a unit are in kg, m and J. Throws
/// InputError.
PhysicalUnits parse_physical(const std::string& text);

}  // namespace mdana
