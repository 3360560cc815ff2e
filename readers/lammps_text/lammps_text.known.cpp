// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/known_dump.hpp"

namespace mdana {

std::vector<KnownAnswer> lammps_text_known();

namespace {

constexpr const char* dump = R"(ITEM: TIMESTEP
5000000000
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS xy xz yz pp pp ff
-5 6 2
-2 3 -1
0 16 1
ITEM: ATOMS id xs ys zs type ix iy iz
7 0.5 0.25 0.125 1 0 0 0
3 1 1 1 2 1 0 -2
)";

}  // namespace

std::vector<KnownAnswer> lammps_text_known() {
  return read_tilted_pair(dump).answers;
}

}  // namespace mdana
