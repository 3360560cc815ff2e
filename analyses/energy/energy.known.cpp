// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/energy.hpp"

#include <array>

#include "readers/known_answer.hpp"

namespace mdana {

std::vector<KnownAnswer> energy_known();

// Body 1: the corners of a cube of edge 2, each of mass 2, far from the origin and on a drift of
// 2^24; it turns with w = (0, 0, 1/2), so that L = I w with I = 2 * 8 * 2 = 32 and E_rot = w^2 I/2 = 4,
// and breathes with u = dx/4: sum of m u^2/2 = 8 * 3/16 = 1.5. Breathing has no angular momentum.
// Body 2: masses 1 and 3 on a line 8 apart, m* = 3/4, with relative speeds of 4 across it and 2 along
// it: K_t = m*/2 (16 + 4) = 7.5; E_rot = m*/2 16 = 6; degrees of freedom 6 - 3 - 2 = 1.
std::vector<KnownAnswer> energy_known() {
  constexpr double far = 1024, drift = 0x1p24;
  AtomBlock block;
  block.reset(0, 10);
  const auto x = block.make_real("x"), y = block.make_real("y"), z = block.make_real("z");
  const auto vx = block.make_real("vx"), vy = block.make_real("vy"), vz = block.make_real("vz");
  const auto w = block.make_real("c_pe");
  for (std::size_t i = 0; i < 8; ++i) {
    const double dx = i & 1 ? 1 : -1, dy = i & 2 ? 1 : -1, dz = i & 4 ? 1 : -1;
    x[i] = far + dx;
    y[i] = far + dy;
    z[i] = far + dz;
    vx[i] = drift - dy / 2 + dx / 4;
    vy[i] = drift + dx / 2 + dy / 4;
    vz[i] = drift + dz / 4;
    w[i] = i % 2 ? 1e16 : -1e16;
  }
  w[3] += 2;  // the neighbour of 1e16
  x[9] = 8;
  vy[8] = 3;
  vy[9] = -1;
  vx[8] = 1.5;
  vx[9] = -0.5;
  const std::vector<BodyIndex> body{1, 1, 1, 1, 1, 1, 1, 1, 2, 2};
  const std::vector<double> mass{2, 2, 2, 2, 2, 2, 2, 2, 1, 3};

  const FrameHeader header;
  const auto analysis = make_energy("c_pe");
  const auto partial = analysis->begin({header, {}});
  partial->add({block, body, mass});
  std::array<double, 8> row{};
  partial->close(row);
  return {{"kinetic energy about the centre, on a drift of 2^24", row[0], 5.5, 15},
          {"rotation of a cube's corners", row[1], 4, 15},
          {"degrees of freedom of eight atoms", row[2], 18, 16},
          {"potential energy of which 1e16 cancels", row[3], 2, 16},
          {"kinetic energy of two masses", row[4], 7.5, 15},
          {"rotation of two masses, singular inertia", row[5], 6, 15},
          {"degrees of freedom of two atoms", row[6], 1, 16}};
}

}  // namespace mdana
