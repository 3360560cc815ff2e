// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "fits/collision_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const CollisionLaw power_collision;
std::vector<KnownAnswer> power_known();

// Without adhesion F_dis = D v^2 a^3 grows with depth as the force 4/3 a^3 does: with y = v^2 and
// x = delta^2.5, dy/dx = -0.8 (4/3 + D y) down and -0.8 (4/3 - D y) up, so 0.8 D x_max = ln(1 +
// 3D/4) and e^2 = 1/(1 + 3D/4). Units R* = m* = E* = v = 1.
std::vector<KnownAnswer> power_known() {
  const auto collision = [](double D) {
    return collide(power_collision, {{1, 1, 1, 1}, {0, D, 2, 3}}, {.tolerance = 1e-11});
  };
  const auto depth = [](double D) { return std::pow(std::log1p(0.75 * D) / (0.8 * D), 0.4); };
  return {
      {"e^2 of D = 4/3", collision(4.0 / 3.0).e_squared, 0.5, 10.5},
      {"e^2 of D = 4", collision(4).e_squared, 0.25, 10.5},
      {"e^2 of D = 132", collision(132).e_squared, 0.01, 10},
      {"delta_max of D = 4", collision(4).delta_max, depth(4), 10},
      {"e of D = 0", collision(0).e, 1, 16},
  };
}

}  // namespace mdana
