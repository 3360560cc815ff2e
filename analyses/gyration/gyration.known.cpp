// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/gyration.hpp"

#include <cmath>

#include "readers/known_answer.hpp"

namespace mdana {

std::vector<KnownAnswer> gyration_known();

// Body 1: the corners of a cube of edge 2h far from the origin, r_g^2 = 3 h^2, R = sqrt(5) h; the
// running mean is rounded to epsilon * offset, 5e-13 h: 12 digits.
// Body 2: masses 1 and 3 a distance d apart, r_g^2 = 3/16 d^2, R = sqrt(5)/4 d.
std::vector<KnownAnswer> gyration_known() {
  constexpr double h = 0.5, d = 8.0, offset = 1024.0;
  AtomBlock block;
  block.reset(0, 10);
  const auto x = block.make_real("x"), y = block.make_real("y"), z = block.make_real("z");
  for (std::size_t i = 0; i < 8; ++i) {
    x[i] = offset + (i & 1 ? h : -h);
    y[i] = offset + (i & 2 ? h : -h);
    z[i] = offset + (i & 4 ? h : -h);
  }
  y[9] = d;
  const std::vector<BodyIndex> body{1, 1, 1, 1, 1, 1, 1, 1, 2, 2};
  const std::vector<double> mass{2, 2, 2, 2, 2, 2, 2, 2, 1, 3};

  const FrameHeader header;
  const auto partial = make_gyration()->begin({header, {}});
  partial->add({block, body, mass});
  std::array<double, 2> radius{};
  partial->close(radius);
  return {{"radius of a cube's corners", radius[0], std::sqrt(5.0) * h, 12},
          {"radius of two masses", radius[1], std::sqrt(5.0) / 4 * d, 15}};
}

}  // namespace mdana
