// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "fits/force_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const ForceLaw dmt_law;
std::vector<KnownAnswer> dmt_known();

std::vector<KnownAnswer> dmt_known() {
  using std::numbers::pi;
  // Whole numbers: a = sqrt(4 * 9) = 6, Hertz 4/3 * 3/4 * 6 * 9 = 54, attraction 4 pi gamma R* = 8.
  const ElasticContact c{4, 0.75, 0.5 / pi};
  return {
      {"a = sqrt(R* delta)", dmt_law.contact_radius(9, c), 6, 15},
      {"F = F_Hertz - 4 pi gamma R*", dmt_law.force(9, c), 46, 15},
      {"F at touch", dmt_law.force(0, c), -8, 15},
      {"F without overlap", dmt_law.force(-1e-12, c), 0, 16},
      {"dF/ddelta = 2 E* a", dmt_law.stiffness(9, c), 9, 15},
      {"U = 2/5 F_Hertz delta - 8 delta", dmt_law.energy(9, c), 0.4 * 54 * 9 - 72, 14.5},
      {"p_c = 2 E* a/(pi R*)", dmt_law.pressure(0, 9, c), 2.25 / pi, 15},
  };
}

}  // namespace mdana
