// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "fits/collision_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const CollisionLaw stress_collision;
std::vector<KnownAnswer> stress_known();

// Without adhesion and with little damping lam exp(b u), b = 2B/pi, the loss is that of the elastic
// motion. B = 0: 4 lam d_max^1.5 0.4 Beta(3/5, 3/2), T = C R = 2 C R*. With zeta = 1 the
// exponential is summed, b^k/k! u^(k+3)/... : 4 lam sum_k b^k/k! u_max^(3+k) 0.4 Beta((3 + k)/5,
// 3/2).
std::vector<KnownAnswer> stress_known() {
  const double nu = 0.25, C = 1e-8, lam = 4 * C / (nu * nu), none = Collision::unknown;
  const double pi = 3.141592653589793, B = 1, b = 2 / pi * B;
  const auto lost = [&](double stress) {
    const CollisionInput input{{1, 1, 1, 1}, {0, nu, C, stress, 1, none, 1, 0}};
    return 1 - collide(stress_collision, input, {.tolerance = 1e-12}).e_squared;
  };
  const double u_max = std::pow(15.0 / 16.0, 0.2);
  double loss = 0, factor = 4 * lam * 0.4 * u_max * u_max * u_max;
  for (int k = 0; k < 40; ++k) {
    loss += factor * std::beta((3.0 + k) / 5, 1.5);
    factor *= b * u_max / (k + 1);
  }
  return {
      {"loss without stress", lost(0), 4 * lam * std::pow(u_max, 3) * 0.4 * std::beta(0.6, 1.5), 5},
      {"loss with stress", lost(B), loss, 5},
  };
}

}  // namespace mdana
