// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "fits/force_law.hpp"

namespace mdana {
namespace {

/// a0, delta0 and F_c of P1 eq. 8: u = a/a0, d = delta/delta0, force in F_c.
struct Scales {
  double radius, delta, force;

  explicit Scales(const ElasticContact& c)
      : radius(std::cbrt(9 * std::numbers::pi * c.surface_energy * c.radius * (c.radius / c.modulus))),
        delta(radius * (radius / (3 * c.radius))),
        force(3 * std::numbers::pi * c.surface_energy * c.radius) {}
};

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

double contact_radius(double delta, const ElasticContact& c) {
  const Scales scales(c);
  const double d = delta / scales.delta;
  if (detached(d)) return 0;
  const double s = stable_root(d);
  return scales.radius * s * s;
}

double force(double delta, const ElasticContact& c) {
  const Scales scales(c);
  const double d = delta / scales.delta;
  if (detached(d)) return 0;
  const double s = stable_root(d);
  const double s3 = s * s * s;
  return scales.force * 4 * s3 * (s3 - 1);
}

double least_delta(const ElasticContact& c) { return Scales(c).delta * least_d; }

}  // namespace

extern const ForceLaw jkr_law;
const ForceLaw jkr_law{"jkr", "elastic spheres with short-range adhesion", force, contact_radius,
                       least_delta};

}  // namespace mdana
