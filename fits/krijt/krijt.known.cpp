// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "fits/collision_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const CollisionLaw krijt_collision;
std::vector<KnownAnswer> krijt_known();

// Scaled variables with F_c = delta_0 = m* = 1, so tau = 1: gamma = 1/(3 pi R*), a_0^2 = 3R*,
// E* = 9 pi gamma R*^2/a_0^3. R* = 3: a_0 = 3, E* = 1/3. At u = 4: d = 44, and the energy is
// w_0^2/2 + U((4/9)^(1/3)).
std::vector<KnownAnswer> krijt_known() {
  const double pi = 3.141592653589793, gamma = 1 / (9 * pi);
  const double u = std::cbrt(4.0 / 9.0),
               first = u * u * (4.8 * u * u * u - 8 * std::sqrt(u * u * u) + 2);
  const double w0 = std::sqrt(2 * (4.8 * 1024 - 8 * 128 + 2 * 16 - first));
  const CollisionInput elastic{{3, 1, 1.0 / 3, w0}, {gamma, 0.25, 0, Collision::unknown, 1, 0}};
  const Collision jkr = collide(krijt_collision, elastic, {.tolerance = 1e-11});
  CollisionInput fast = elastic;
  fast.values[2] = 1e-9;
  fast.values[5] = 1;
  const Collision nearly = collide(krijt_collision, fast);
  const double loss = (6 * std::pow(4.0, 4.0 / 3.0) + 4) / 5 * std::pow(6.0, -4.0 / 3.0);
  CollisionInput slow = elastic;
  slow.values[2] = 0.01;
  slow.impact.velocity = 0.1;
  return {
      {"e without dissipation is JKR's", jkr.e, std::sqrt(1 - 2 * loss / (w0 * w0)), 15},
      {"delta_max without dissipation", jkr.delta_max, 44, 10},
      {"e^2 of a fast crack", nearly.e_squared, 1 - 2 * loss / (w0 * w0), 5},
      {"delta_max of a fast crack", nearly.delta_max, 44, 5},
      {"e of a slow impact", collide(krijt_collision, slow).e, 0, 16},
  };
}

}  // namespace mdana
