// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "fits/collision_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const CollisionLaw krijt_plastic_collision;
std::vector<KnownAnswer> krijt_plastic_known();

// Without adhesion and viscosity e is that of Thornton and Ning (P1 eq. 13). Its roots come out for
// (v/v_Y)^2 = 3.5: 6x^2/5 - 1/5 = 4.
std::vector<KnownAnswer> krijt_plastic_known() {
  const double none = Collision::unknown;
  const auto e_squared = [&](double v, double v_y, double y) {
    const CollisionInput input{{1, 1, 1, v}, {0, 0.25, 0, none, 1, 0, v_y, y}};
    return collide(krijt_plastic_collision, input).e_squared;
  };
  const double law = 6 * std::sqrt(3.0) / 5 * (20.0 / 21.0) / std::sqrt(5.0);
  // v_Y by Y: (pi/2)^2 sqrt(8 pi/15) p_y^(5/2) with p_y = 1.6 Y = 0.25.
  const double v_y = std::pow(std::numbers::pi / 2, 2) * std::sqrt(8 * std::numbers::pi / 15) / 32;
  const double fast = 1e6;
  return {
      {"e^2 at (v/v_Y)^2 = 3.5", e_squared(std::sqrt(3.5), 1, none), law, 14},
      {"e^2 at the yield velocity", e_squared(1, 1, none), 1, 15},
      {"e^2 below the yield velocity", e_squared(0.5, 1, none), 1, 16},
      {"v_Y by the yield strength", e_squared(std::sqrt(3.5) * v_y, none, 0.25 / 1.6), law, 14},
      {"e far above", std::sqrt(e_squared(fast, 1, none)),
       std::sqrt(6 * std::sqrt(3.0) / 5 / std::sqrt(2 * std::sqrt(1.2))) / std::pow(fast, 0.25), 5},
  };
}

}  // namespace mdana
