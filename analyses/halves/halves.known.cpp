// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/halves.hpp"

#include <array>

#include "analyses/motion.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

std::vector<KnownAnswer> halves_known();

// Four atoms of mass 1 a body on the x axis, on a drift of 1e6 along y and x. Body 1 at -7 -5 -3 +1,
// body 2 at -2 3 5 8: the centres are at -3.5 and 3.5, the plane at 0. Of the crossed atoms, at +1 and
// -2, each counts on the side where it is: 17/4 - (-17/4) = 8.5 = 7 + 2/4 (1 + 2).
std::vector<KnownAnswer> halves_known() {
  constexpr double drift = 1 << 20;
  const std::array<double, 8> along{-7, -5, -3, 1, -2, 3, 5, 8}, speed{2, 2, 2, 1, -1, -2, -2, -3};
  AtomBlock block;
  block.reset(0, along.size());
  for (const char* name : {"y", "z", "vz"}) block.make_real(name);
  const auto x = block.make_real("x"), vx = block.make_real("vx"), vy = block.make_real("vy");
  for (std::size_t i = 0; i < along.size(); ++i) {
    x[i] = along[i];
    vx[i] = drift + speed[i];
    vy[i] = drift;
  }
  const std::vector<BodyIndex> body{1, 1, 1, 1, 2, 2, 2, 2};
  const std::vector<double> mass(along.size(), 1.0);
  std::array<BodyMotion, 2> motion;
  motion[0] = {4, 4, {-3.5, 0, 0}, {drift + 1.75, drift, 0}, {0, 0, 0}};
  motion[1] = {4, 4, {3.5, 0, 0}, {drift - 2, drift, 0}, {0, 0, 0}};
  const FrameHeader header;
  const auto partial = make_halves({5, 5}, true)->begin({header, motion});
  partial->add({block, body, mass});
  std::array<double, 4> row{};
  partial->close(row);
  return {{"distance of the halves, two atoms crossed", row[0], 8.5, 15},
          {"mutual velocity of the halves", row[1], (2 + 2 + 2 - 1) / 4.0 - (1 - 2 - 2 - 3) / 4.0, 15},
          {"atoms below the plane", row[2], 4, 16},
          {"atoms above the plane", row[3], 4, 16}};
}

}  // namespace mdana
