// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fits/force_law.hpp"

namespace mdana {
namespace {

using std::numbers::pi;

/// P2 eq. 24: (pi^2/4)(Y/E*)^2 R*.
double yield_delta(const ElasticContact& c) {
  const double strain = pi / 2 * (c.yield_strength / c.modulus);
  return strain * strain * c.radius;
}

double contact_radius(double delta, const ElasticContact& c) {
  return delta <= 0 ? 0.0 : std::sqrt(c.radius * delta);
}

double hertz_force(double delta, const ElasticContact& c) {
  return 4.0 / 3.0 * c.modulus * contact_radius(delta, c) * delta;
}

namespace loading {

/// P2 eqs 23, 26: pi R* Y (delta - delta_Y/3) beyond yield.
double force(double delta, const ElasticContact& c) {
  const double yield = yield_delta(c);
  if (!(delta > yield)) return hertz_force(delta, c);
  return pi * c.radius * c.yield_strength * (delta - yield / 3);
}

double least_delta(const ElasticContact&) { return 0; }

double stiffness(double delta, const ElasticContact& c) {
  if (delta > yield_delta(c)) return pi * c.radius * c.yield_strength;
  return 2 * c.modulus * contact_radius(delta, c);
}

/// P2 eq. 27: pi R* Y (delta^2/2 - delta delta_Y/3 + delta_Y^2/10) beyond yield.
double energy(double delta, const ElasticContact& c) {
  const double yield = yield_delta(c);
  if (!(delta > yield)) return 0.4 * hertz_force(delta, c) * delta;
  const double d = yield / delta;
  return pi * c.radius * c.yield_strength * delta * delta * (0.5 - d * (1.0 / 3.0 - d / 10));
}

/// P2 eqs 59, 61: 2 E*/(pi R*) sqrt(a^2 - r^2), cut off at Y.
double pressure(double r, double delta, const ElasticContact& c) {
  const double a = contact_radius(delta, c);
  if (r >= a) return 0;
  return std::min(2 / pi * c.modulus * (std::sqrt((a - r) * (a + r)) / c.radius), c.yield_strength);
}

}  // namespace loading

namespace returning {

/// P2 eq. 69: where the contact ends, delta_max - delta_Y, which is a_Y,max^2/R* (65).
double least_delta(const ElasticContact& c) { return std::max(c.delta_max - yield_delta(c), 0.0); }

bool apart(double delta, const ElasticContact& c) { return delta <= least_delta(c); }

double contact_radius(double delta, const ElasticContact& c) {
  return apart(delta, c) ? 0 : std::sqrt(c.radius * delta);
}

/// P2 eq. 68: 2 E* sqrt(R*) (delta_end x^0.5 + 2/3 x^1.5), x = delta - delta_end.
double force(double delta, const ElasticContact& c) {
  if (apart(delta, c)) return 0;
  const double end = least_delta(c), x = delta - end;
  return 2 * c.modulus * std::sqrt(c.radius * x) * (end + 2.0 / 3.0 * x);
}

double stiffness(double delta, const ElasticContact& c) {
  if (apart(delta, c)) return 0;
  const double end = least_delta(c), root = std::sqrt(c.radius * (delta - end));
  return c.modulus * (end * (c.radius / root) + 2 * root);
}

double energy(double delta, const ElasticContact& c) {
  if (apart(delta, c)) return 0;
  const double end = least_delta(c), x = delta - end;
  return 2 * c.modulus * std::sqrt(c.radius * x) * x * (2.0 / 3.0 * end + 4.0 / 15.0 * x);
}

/// P2 eqs 66, 67: within a_Y,max that of Hertz at its rim.
double pressure(double r, double delta, const ElasticContact& c) {
  if (apart(delta, c) || r >= contact_radius(delta, c)) return 0;
  const double outer = std::max(least_delta(c), r / c.radius * r);
  return 2 / pi * c.modulus * std::sqrt(std::max(delta - outer, 0.0) / c.radius);
}

}  // namespace returning

constexpr std::array parameters{contact_parameter::radius, contact_parameter::modulus,
                                contact_parameter::yield_strength};

const ForceBranch way_back{returning::force,          returning::contact_radius,
                           returning::least_delta,    returning::stiffness,
                           returning::energy,         returning::pressure,
                           returning::contact_radius};

}  // namespace

extern const ForceLaw andrews_law;
const ForceLaw andrews_law{
    {loading::force, contact_radius, loading::least_delta, loading::stiffness, loading::energy,
     loading::pressure, contact_radius},
    "andrews",
    "elastic, perfectly plastic spheres without adhesion",
    parameters,
    &way_back};

}  // namespace mdana
