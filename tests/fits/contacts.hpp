// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "fits/force_law.hpp"

namespace mdana::test {

inline const ElasticContact lj{73.5, 65.5, 3.17, 0.15 * 65.5, 1.091};  // P1, R = 147
inline const ElasticContact ice{5e-8, 3.7e9, 0.1, 3e8, 3e-10};         // SI, grains of 0.1 um
inline const ElasticContact stiff{1e6, 1e12, 1e-3, 1e9, 1e-9};         // almost no adhesion
inline const ElasticContact weak{1e-4, 1e9, 1e-3, 1e5, 1e-8};          // yields under its adhesion

/// a0, delta0 and F_c of P1 eq. 8.
inline double jkr_radius(const ElasticContact& c) {
  return std::cbrt(9 * std::numbers::pi * c.surface_energy * c.radius * c.radius / c.modulus);
}
inline double jkr_delta(const ElasticContact& c) {
  return jkr_radius(c) * jkr_radius(c) / (3 * c.radius);
}
inline double pull_off_force(const ElasticContact& c) {
  return 3 * std::numbers::pi * c.surface_energy * c.radius;
}

/// Where a contact without adhesion yields whose centre bears Y (P2 eq. 24).
inline double yield_delta(const ElasticContact& c) {
  return std::numbers::pi * std::numbers::pi / 4 * std::pow(c.yield_strength / c.modulus, 2) *
         c.radius;
}

}  // namespace mdana::test
