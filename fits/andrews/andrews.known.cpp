// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "fits/collision_law.hpp"
#include "fits/force_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const ForceLaw andrews_law;
extern const CollisionLaw andrews_collision;
std::vector<KnownAnswer> andrews_known();

namespace {

using std::numbers::pi;

/// x^2 = 25.375 makes delta_max = 4 delta_Y: e^2 is (2 + 4/15)/(8 - 4/3 + 1/10), and after yield the
/// plastic part is an arc of a circle; at v_Y, t_max is 1.4716... delta_Y/v.
std::vector<KnownAnswer> collisions() {
  const double Y = 0.1, strain = pi / 2 * Y / 3, yield = strain * strain * 2, m = 5;
  const double v_y = strain * strain * std::sqrt(8 * pi * 8 * Y / (15 * m));
  const Collision c = collide(andrews_collision, {{2, m, 3, std::sqrt(25.375) * v_y}, {Y}});
  const Collision at_yield = collide(andrews_collision, {{2, m, 3, v_y * (1 + 1e-15)}, {Y}});
  const Collision soft = collide(andrews_collision, {{2, m, 3, 1}, {1e-9}});
  return {
      {"delta_max = 4 delta_Y", c.delta_max, 4 * yield, 14},
      {"e^2 at 4 delta_Y", c.e_squared, (2 + 4.0 / 15) / (8 - 4.0 / 3 + 0.1), 14},
      {"e at v_Y", at_yield.e, 1, 13},
      {"t_max at v_Y", at_yield.t_max * v_y / yield, 1.471637592, 9.5},
      // P2 eq. 33 with m* = 16 pi/3 rho R*^3: pi/2 sqrt(m*/(pi R* Y)).
      {"t_max of the rigid plastic limit", soft.t_max, pi / 2 * std::sqrt(m / (pi * 2 * 1e-9)), 12},
  };
}

}  // namespace

// Forces in pi R* Y delta_Y at delta_max = 4 delta_Y, where delta_end = 3 delta_Y.
std::vector<KnownAnswer> andrews_known() {
  ElasticContact c{2, 3, 0, 0.1};
  const double yield = pi * pi / 4 * 0.01 / 9 * 2, unit = pi * 2 * 0.1 * yield;
  c.delta_max = 4 * yield;
  const ForceBranch& back = unloading(andrews_law);
  std::vector<KnownAnswer> answers{
      {"F at yield", andrews_law.force(yield, c), 2.0 / 3.0 * unit, 14},
      {"F at 4 delta_Y", andrews_law.force(4 * yield, c), 11.0 / 3.0 * unit, 14},
      {"work up to delta_Y: pi R* Y delta_Y^2 4/15", andrews_law.energy(yield, c),
       4.0 / 15.0 * unit * yield, 14},
      {"work up to 4 delta_Y", andrews_law.energy(4 * yield, c), (8 - 4.0 / 3.0 + 0.1) * unit * yield,
       14},
      {"p_c beyond yield", andrews_law.pressure(0, 4 * yield, c), 0.1, 14},
      {"F where the return begins", back.force(4 * yield, c), 11.0 / 3.0 * unit, 14},
      {"delta where the contact ends", back.least_delta(c), 3 * yield, 14},
      // x = delta_Y/4: (3 sqrt(1/4) + 2/3 (1/4)^1.5) pi R* Y delta_Y.
      {"F on the return", back.force(3.25 * yield, c), (1.5 + 1.0 / 12) * unit, 13.5},
      {"energy gained back: 2 + 4/15", back.energy(4 * yield, c), (2 + 4.0 / 15) * unit * yield, 14},
      {"p on the return, at the centre", back.pressure(0, 3.25 * yield, c), 0.05, 13.5},
  };
  for (const KnownAnswer& answer : collisions()) answers.push_back(answer);
  return answers;
}

}  // namespace mdana
