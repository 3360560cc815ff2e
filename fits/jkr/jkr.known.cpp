// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "fits/force_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const ForceLaw jkr_law;
std::vector<KnownAnswer> jkr_known();

// Points (u, d, F/F_c) of the curve d = 3u^2 - 2 sqrt(u), F/F_c = 4(u^3 - u^1.5) with whole numbers
// or plain powers, for the spheres of Yoshida, Kokubo & Tanaka 2024, Table II, R = 147 (R* = R/2).
std::vector<KnownAnswer> jkr_known() {
  const ElasticContact c{73.5, 65.5, 3.17};
  const double f_c = 3 * std::numbers::pi * 3.17 * 73.5;
  const double a0 = std::cbrt(9 * std::numbers::pi * 3.17 * 73.5 * 73.5 / 65.5);
  const double delta0 = a0 * a0 / (3 * 73.5);
  const double least = jkr_law.least_delta(c);
  // u and F at pull-off are known to sqrt(epsilon) only: a vertical tangent. A step of 1e-15 above.
  const double pull_off = least * (1 - 1e-15);
  const double force_minimum = -std::pow(4.0, -2.0 / 3.0) * delta0;
  return {
      {"delta at pull-off", least, -std::pow(0.75, 2.0 / 3.0) * delta0, 14},
      {"delta at pull-off, printed digits", least, -1.42066, 5},
      {"F at delta = 0, printed digits", jkr_law.force(0, c), -1951.93, 5},
      {"F at delta = 0 is -8/9 F_c", jkr_law.force(0, c), -8.0 / 9.0 * f_c, 14},
      {"a at delta = 0 is (2/3)^(2/3) a0", jkr_law.contact_radius(0, c),
       std::pow(2.0 / 3.0, 2.0 / 3.0) * a0, 14},
      {"F at equilibrium, in F_c", jkr_law.force(delta0, c) / f_c, 0, 14},
      {"a at equilibrium is a0", jkr_law.contact_radius(delta0, c), a0, 14},
      {"least force is -F_c", jkr_law.force(force_minimum, c), -f_c, 14},
      {"a at least force", jkr_law.contact_radius(force_minimum, c), std::pow(4.0, -1.0 / 3.0) * a0,
       14},
      {"F at pull-off is -5/9 F_c", jkr_law.force(pull_off, c), -5.0 / 9.0 * f_c, 6},
      {"a at pull-off", jkr_law.contact_radius(pull_off, c), std::pow(6.0, -2.0 / 3.0) * a0, 6},
      {"F beyond pull-off", jkr_law.force(1.01 * least, c), 0, 16},
      // d = 3 * 4^2 - 2 * 2 = 44: u = 4, F = 4 (64 - 8) F_c = 224 F_c.
      {"F deep in contact", jkr_law.force(44 * delta0, c), 224 * f_c, 13.5},
  };
}

}  // namespace mdana
