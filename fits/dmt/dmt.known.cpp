// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "fits/collision_law.hpp"
#include "fits/force_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const ForceLaw dmt_law;
extern const CollisionLaw dmt_collision;
std::vector<KnownAnswer> dmt_known();

std::vector<KnownAnswer> dmt_known() {
  using std::numbers::pi;
  // Whole numbers: a = sqrt(4 * 9) = 6, Hertz 4/3 * 3/4 * 6 * 9 = 54, attraction 4 pi gamma R* = 8.
  const ElasticContact c{4, 0.75, 0.5 / pi};
  // At delta = 9: m* v^2/2 = 2/5 54 * 9 - 8 * 9 = 122.4.
  const Collision impact = collide(dmt_collision, {{4, 2, 0.75, std::sqrt(122.4)}, {0.5 / pi}});
  const Collision plain = collide(dmt_collision, {{4, 2, 0.75, std::sqrt(194.4)}, {0}});
  return {
      {"a = sqrt(R* delta)", dmt_law.contact_radius(9, c), 6, 15},
      {"F = F_Hertz - 4 pi gamma R*", dmt_law.force(9, c), 46, 15},
      {"F at touch", dmt_law.force(0, c), -8, 15},
      {"F without overlap", dmt_law.force(-1e-12, c), 0, 16},
      {"dF/ddelta = 2 E* a", dmt_law.stiffness(9, c), 9, 15},
      {"U = 2/5 F_Hertz delta - 8 delta", dmt_law.energy(9, c), 0.4 * 54 * 9 - 72, 14.5},
      {"p_c = 2 E* a/(pi R*)", dmt_law.pressure(0, 9, c), 2.25 / pi, 15},
      {"delta_max of an impact", impact.delta_max, 9, 14},
      {"e", impact.e, 1, 16},
      {"t_max without adhesion", plain.t_max * std::sqrt(194.4) / 9, 1.471637592, 9.5},
  };
}

}  // namespace mdana
