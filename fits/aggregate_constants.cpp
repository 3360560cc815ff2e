// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/aggregate_constants.hpp"

#include <cmath>

namespace mdana {

using std::numbers::pi;

double cpe_coordination(double phi) { return 12 * (phi / largest_filling); }

double bcca_coordination(double phi) { return 2 + 9.38 * std::pow(phi, 1.62); }

ElasticContact grain_contact(double grain_radius, double modulus, double poisson_ratio,
                             double surface_energy) {
  return {.radius = grain_radius / 2,
          .modulus = modulus / (2 * (1 - poisson_ratio * poisson_ratio)),
          .surface_energy = surface_energy};
}

double equilibrium_radius(const ElasticContact& c) {
  return c.radius * std::cbrt(9 * pi * (c.surface_energy / c.radius / c.modulus));
}

double equilibrium_overlap(const ElasticContact& c) {
  const double a0 = equilibrium_radius(c);
  return a0 * (a0 / (3 * c.radius));
}

double pull_force(const ElasticContact& c) { return 3 * pi * c.surface_energy * c.radius; }

double contact_stiffness(const ElasticContact& c) {
  return 1.2 * c.modulus * equilibrium_radius(c);
}

double bulk_modulus(double phi, double coordination, double stiffness, double grain_radius) {
  return phi * coordination / (6 * pi) * (stiffness / grain_radius);
}

// With q = 2 E*/(3 K):  q (1 - nu^2) = 1 - 2 nu; the root of it between -1 and 1/2.
double aggregate_poisson_ratio(double reduced_modulus, double bulk) {
  const double q = 2 * reduced_modulus / (3 * bulk);
  return (1 - q) / (1 + std::sqrt(1 - q + q * q));
}

double static_yield_stress(double phi, double grain_radius, double surface_energy,
                           double rolling_displacement) {
  const double roll = 6 * pi * pi * surface_energy * (rolling_displacement / grain_radius);
  return roll / grain_radius * std::pow(1 / phi - 1 / largest_filling, -3);
}

}  // namespace mdana
