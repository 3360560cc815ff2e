// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fits/force_law.hpp"

namespace mdana {

/// A contact on the stable branch of JKR, lengths in R*, pressures in E* (so that powers of two in
/// the units change no bit). Without adhesion x = 0, and it is that of Hertz.
struct JkrContact {
  double a = 0;  ///< contact radius; 0 without contact
  double x = 0;  ///< (a0/a)^1.5 = 1/u^1.5, from 0 to 6 at pull-off

  /// F = 4/3 a^3 (1 - x), P1 eq. 6.
  double force() const { return 4.0 / 3.0 * a * a * a * (1 - x); }
  /// dF/ddelta = 2a (6 - 3x)/(6 - x).
  double stiffness() const { return 2 * a * ((6 - 3 * x) / (6 - x)); }
  /// U = a^5 (8/15 - 8/9 x + 2/9 x^2), P1 eq. 7; zero where the spheres are apart.
  double energy() const { return a * a * a * a * a * (8.0 / 15.0 - 8.0 / 9.0 * x + 2.0 / 9.0 * x * x); }
  /// p = 2a/pi (y - x/(3y)), y = sqrt(1 - r^2/a^2), P1 eq. 9 at r = 0; zero for r >= a.
  double pressure(double r) const;
};

/// At a given delta/R*, with gamma/(E* R*).
JkrContact jkr_contact(double delta, double gamma);

/// Of spheres with their units.
JkrContact jkr_contact(double delta, const ElasticContact& contact);

/// Pull-off: delta/R* = -(3/4)^(2/3) delta0/R*.
double jkr_least_delta(double gamma);

}  // namespace mdana
