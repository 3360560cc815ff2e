// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <numbers>

#include "fits/force_law.hpp"

namespace mdana {
namespace {

double contact_radius(double delta, const ElasticContact& c) {
  return delta <= 0 ? 0.0 : std::sqrt(c.radius * delta);
}

double force(double delta, const ElasticContact& c) {
  return delta <= 0 ? 0.0 : 4.0 / 3.0 * c.modulus * std::sqrt(c.radius * delta) * delta;
}

double least_delta(const ElasticContact&) { return 0; }

double stiffness(double delta, const ElasticContact& c) {
  return 2 * c.modulus * contact_radius(delta, c);
}

/// 8/15 E* sqrt(R*) delta^2.5.
double energy(double delta, const ElasticContact& c) { return 0.4 * force(delta, c) * delta; }

/// 2 E*/(pi R*) sqrt(a^2 - r^2), P1 eq. 4 at r = 0.
double pressure(double r, double delta, const ElasticContact& c) {
  const double a = contact_radius(delta, c);
  return r >= a ? 0 : 2 / std::numbers::pi * c.modulus * (std::sqrt((a - r) * (a + r)) / c.radius);
}

constexpr std::array parameters{contact_parameter::radius, contact_parameter::modulus};

}  // namespace

extern const ForceLaw hertz_law;
const ForceLaw hertz_law{
    {force, contact_radius, least_delta, stiffness, energy, pressure, contact_radius},
    "hertz",
    "elastic spheres without adhesion",
    parameters};

}  // namespace mdana
