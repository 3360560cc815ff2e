// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/jkr_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mdana {
namespace {

const double least_d = -std::pow(0.75, 2.0 / 3.0);  // pull-off

/// Beyond pull-off by more than rounding of delta/delta0 can explain.
bool detached(double d) {
  return d < least_d * (1 + 8 * std::numeric_limits<double>::epsilon());
}

/// sqrt(u) on the stable branch, the larger root of 3 s^4 - 2 s = d, for d >= least_d. Newton from
/// above on a convex function: monotone, no bracketing needed.
double stable_root(double d) {
  double s = 1 + std::pow(std::max(d, 0.0) / 3, 0.25);
  for (int i = 0; i < 100; ++i) {
    const double slope = 12 * s * s * s - 2;
    if (!(slope > 0)) return s;
    const double next = s - (3 * s * s * s * s - 2 * s - d) / slope;
    if (!(next < s)) return s;
    s = next;
  }
  return s;
}

/// P1 eq. 8, in R*.
double equilibrium_radius(double gamma) { return std::cbrt(9 * std::numbers::pi * gamma); }

}  // namespace

double JkrContact::pressure(double r) const {
  if (r >= a) return 0;
  const double y = std::sqrt((1 - r / a) * (1 + r / a));
  return 2 / std::numbers::pi * a * (y - x / (3 * y));
}

JkrContact jkr_contact(double delta, double gamma) {
  const double a0 = equilibrium_radius(gamma);
  if (a0 == 0) return {delta <= 0 ? 0.0 : std::sqrt(delta), 0};
  const double d = delta / (a0 * a0 / 3);
  if (detached(d)) return {};
  const double s = stable_root(d);
  return {a0 * s * s, std::min(1 / (s * s * s), 6.0)};
}

JkrContact jkr_contact(double delta, const ElasticContact& c) {
  return jkr_contact(delta / c.radius, c.surface_energy / c.radius / c.modulus);
}

double jkr_least_delta(double gamma) {
  const double a0 = equilibrium_radius(gamma);
  return a0 * a0 / 3 * least_d;
}

}  // namespace mdana
