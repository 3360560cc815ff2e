// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "fits/collision_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const CollisionLaw viscous_hertz_collision;
std::vector<KnownAnswer> viscous_hertz_known();

// Little damping: the loss is that of the elastic motion, with F_dis = lam sqrt(d) w in units of
// R*, m*, E* and v = 1 and d_max^2.5 = 15/16: 1 - e^2 = 4 lam d_max^1.5 0.4 B(3/5, 3/2), less
// O(lam^2).
std::vector<KnownAnswer> viscous_hertz_known() {
  const double nu = 0.25, T = 1e-7, lam = 2 * T / (nu * nu);
  const Collision c =
      collide(viscous_hertz_collision, {{1, 1, 1, 1}, {nu, T}}, {.tolerance = 1e-12});
  const double loss = 4 * lam * std::pow(15.0 / 16.0, 0.6) * 0.4 * std::beta(0.6, 1.5);
  const Collision elastic = collide(viscous_hertz_collision, {{1, 1, 1, 1}, {nu, 0}});
  return {
      {"loss of little damping", 1 - c.e_squared, loss, 5},
      {"e^2 of little damping", c.e_squared, 1 - loss, 10.5},
      {"delta_max of little damping", c.delta_max, std::pow(15.0 / 16.0, 0.4), 5.5},
      {"e without damping", elastic.e, 1, 16},
  };
}

}  // namespace mdana
