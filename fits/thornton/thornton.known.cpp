// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "fits/collision_law.hpp"
#include "fits/force_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const ForceLaw thornton_law;
extern const CollisionLaw thornton_collision;
std::vector<KnownAnswer> thornton_known();

namespace {

using std::numbers::pi;

/// Without adhesion at delta_max = 4 delta_Y: F in pi R* p_y delta_Y is 11/3 (Hertz 16/3), so that
/// R_p = 16/11 R*, and delta_p = 4 (1 - 11/16) delta_Y = 5/4 delta_Y.
std::vector<KnownAnswer> plain() {
  ElasticContact c{2, 3, 0, 0.1 / 1.6};
  const double yield = pi * pi / 4 * 0.01 / 9 * 2, unit = pi * 2 * 0.1 * yield;
  c.delta_max = 4 * yield;
  const ForceBranch& back = unloading(thornton_law);
  return {
      {"F at yield", thornton_law.force(yield, c), 2.0 / 3.0 * unit, 14},
      {"F at 4 delta_Y", thornton_law.force(4 * yield, c), 11.0 / 3.0 * unit, 14},
      {"work up to 4 delta_Y", thornton_law.energy(4 * yield, c), (8 - 4.0 / 3.0 + 0.1) * unit * yield,
       14},
      {"stiffness beyond yield", thornton_law.stiffness(4 * yield, c), pi * 2 * 0.1, 14},
      {"p_c beyond yield", thornton_law.pressure(0, 4 * yield, c), 0.1, 14},
      {"F where unloading begins", back.force(4 * yield, c), 11.0 / 3.0 * unit, 13.5},
      {"a where unloading begins", back.contact_radius(4 * yield, c), std::sqrt(2 * 4 * yield), 14},
      {"delta where the contact ends", back.least_delta(c), 1.25 * yield, 14},
      {"work gained back: 3 F^2/(10 E* a)", back.energy(4 * yield, c),
       0.3 * std::pow(11.0 / 3.0 * unit, 2) / (3 * std::sqrt(8 * yield)), 13.5},
  };
}

/// With adhesion, R* = E* = 1: a = 1/4, of JKR's p = p0 y - q/y half of p0 = 2a/pi at y = 1/2.
std::vector<KnownAnswer> adhesive() {
  const double a = 0.25, p0 = 2 * a / pi, q = p0 / 64, y = 0.5, p = p0 * y - q / y;
  const double gamma = q * q * pi * a / 4, delta = a * a - std::sqrt(4 * pi * gamma * a);
  ElasticContact c{1, 1, gamma, p / 1.6};
  c.delta_max = delta;
  const double force = pi * a * a * ((1 - y * y) * p + 2.0 / 3.0 * p0 * y * y * y - 2 * q * y);
  const ForceBranch& back = unloading(thornton_law);
  return {
      {"a, with adhesion", thornton_law.contact_radius(delta, c), a, 14},
      {"F of the pressure cut off", thornton_law.force(delta, c), force, 14},
      {"F where unloading begins, with adhesion", back.force(delta, c), force, 13},
      {"a where unloading begins, with adhesion", back.contact_radius(delta, c), a, 13.5},
      {"p at y", thornton_law.pressure(a * std::sqrt(0.75), delta, c), p, 13.5},
  };
}

/// Eq. 13 at v = v_Y is 1; at x^2 = 23/3 its inner root is 3: e^2 = 6 sqrt(3)/5 (1 - 1/46)/sqrt(7).
std::vector<KnownAnswer> collisions() {
  const auto at = [](double x) {
    return collide(thornton_collision, {{73.5, 1e7, 65.5, x * 0.17}, {0, Collision::unknown, 0.17}});
  };
  return {
      {"e at v_Y", at(1 + 1e-15).e, 1, 14},
      {"e^2 where the root is 3", at(std::sqrt(23.0 / 3)).e_squared,
       1.2 * std::sqrt(3.0) * (1 - 1.0 / 46) / std::sqrt(7.0), 14},
      {"e far beyond yield, printed digits", at(1e12).e * 1e3, 1.18499, 5.5},
  };
}

}  // namespace

std::vector<KnownAnswer> thornton_known() {
  std::vector<KnownAnswer> answers = plain();
  for (const auto& more : {adhesive(), collisions()})
    answers.insert(answers.end(), more.begin(), more.end());
  return answers;
}

}  // namespace mdana
