// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "fits/force_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const ForceLaw andrews_law;
std::vector<KnownAnswer> andrews_known();

// Forces in pi R* Y delta_Y at delta_max = 4 delta_Y, where delta_end = 3 delta_Y.
std::vector<KnownAnswer> andrews_known() {
  using std::numbers::pi;
  ElasticContact c{2, 3, 0, 0.1};
  const double yield = pi * pi / 4 * 0.01 / 9 * 2, unit = pi * 2 * 0.1 * yield;
  c.delta_max = 4 * yield;
  const ForceBranch& back = unloading(andrews_law);
  return {
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
}

}  // namespace mdana
