// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "fits/force_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const ForceLaw hertz_law;
std::vector<KnownAnswer> hertz_known();

std::vector<KnownAnswer> hertz_known() {
  // Whole numbers: a = sqrt(4 * 9) = 6, F = 4/3 * 3/4 * 6 * 9 = 54.
  const ElasticContact whole{4, 0.75, 0};
  // Two spheres of radius 100 nm, 7 GPa: F = 4/3 E* a^3/R*, the same law by way of a.
  const ElasticContact grains{5e-8, 7e9, 0};
  const double a = 1e-9;
  const double delta = a * (a / grains.radius);
  return {
      {"a = sqrt(R* delta)", hertz_law.contact_radius(9, whole), 6, 15},
      {"F = 4/3 E* sqrt(R*) delta^1.5", hertz_law.force(9, whole), 54, 15},
      {"a of grains, SI", hertz_law.contact_radius(delta, grains), a, 15},
      {"F = 4/3 E* a^3/R* of grains, SI", hertz_law.force(delta, grains),
       4.0 / 3.0 * 7e9 * (a * a * (a / 5e-8)), 14.5},
      {"F without overlap", hertz_law.force(-1e-12, grains), 0, 16},
      {"least delta", hertz_law.least_delta(grains), 0, 16},
  };
}

}  // namespace mdana
