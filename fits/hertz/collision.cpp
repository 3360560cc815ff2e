// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "fits/collision_law.hpp"

namespace mdana {
namespace {

/// t_max v/delta_max = integral of 1/sqrt(1 - x^2.5) = sqrt(pi) Gamma(7/5)/Gamma(9/10).
const double compression_time =
    std::sqrt(std::numbers::pi) * std::tgamma(1.4) / std::tgamma(0.9);

/// P1 eqs 3, 4, 15: 8/15 E* sqrt(R*) delta_max^2.5 = m* v^2/2, p_c = 2 E* a/(pi R*).
Collision collide_hertz(const CollisionInput& input, const CollisionSettings& settings) {
  const Impact& i = input.impact;
  Collision c;
  c.outcome = CollisionOutcome::bounce;
  c.e = c.e_squared = 1;
  c.e_error = c.e_squared_error = 0;
  // x = delta_max/R* from quotients that neither overflow nor vanish.
  const double x = std::pow(15.0 / 16.0 * (i.mass / (i.radius * i.radius * i.radius)) *
                                (i.velocity * (i.velocity / i.modulus)), 0.4);
  c.delta_max = x * i.radius;
  c.t_max = compression_time * (c.delta_max / i.velocity);
  c.contact_time = 2 * c.t_max;
  c.a_max = std::sqrt(x) * i.radius;
  c.p_c_max = 2 / std::numbers::pi * i.modulus * std::sqrt(x);
  c.energy_residual = 0;
  (void)settings;
  return c;
}

}  // namespace

extern const CollisionLaw hertz_collision;
const CollisionLaw hertz_collision{"hertz", "elastic spheres without adhesion", {}, collide_hertz};

}  // namespace mdana
