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

double pull_off_force(const ElasticContact& c) {
  return 4 * std::numbers::pi * c.surface_energy * c.radius;
}

/// F = 4/3 E* sqrt(R*) delta^1.5 - 4 pi gamma R*.
double force(double delta, const ElasticContact& c) {
  if (delta < 0) return 0;
  return 4.0 / 3.0 * c.modulus * contact_radius(delta, c) * delta - pull_off_force(c);
}

double least_delta(const ElasticContact&) { return 0; }

double stiffness(double delta, const ElasticContact& c) {
  return 2 * c.modulus * contact_radius(delta, c);
}

/// Since touch: the law does not tell how far the attraction reaches.
double energy(double delta, const ElasticContact& c) {
  if (delta <= 0) return 0;
  return 8.0 / 15.0 * c.modulus * contact_radius(delta, c) * delta * delta -
         pull_off_force(c) * delta;
}

/// That of Hertz: the attraction acts outside the contact.
double pressure(double r, double delta, const ElasticContact& c) {
  const double a = contact_radius(delta, c);
  return r >= a ? 0 : 2 / std::numbers::pi * c.modulus * (std::sqrt((a - r) * (a + r)) / c.radius);
}

constexpr std::array parameters{contact_parameter::radius, contact_parameter::modulus,
                                contact_parameter::surface_energy};

}  // namespace

extern const ForceLaw dmt_law;
const ForceLaw dmt_law{
    {force, contact_radius, least_delta, stiffness, energy, pressure, contact_radius},
    "dmt",
    "elastic spheres with attraction about the contact",
    parameters};

}  // namespace mdana
