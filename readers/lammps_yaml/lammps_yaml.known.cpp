// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/known_dump.hpp"

namespace mdana {

std::vector<KnownAnswer> lammps_yaml_known();

namespace {

constexpr const char* dump = R"(---
creator: LAMMPS
timestep: 5000000000
units: metal
time: 0.125
natoms: 2
boundary: [ p, p, p, p, f, f, ]
thermo:
  - keywords: [ Step, Temp, ]
  - data: [ 5000000000, 1.5, ]
box:
  - [ -5, 6 ]
  - [ -2, 3 ]
  - [ 0, 16 ]
  - [ 2, -1, 1 ]
keywords: [ id, xs, ys, zs, type, element, ix, iy, iz,  ]
data:
  - [ 7, 0.5, 0.25, 0.125, 1, Si, 0, 0, 0, ]
  - [ 3, 1, 1, 1, 2, 'O', 1, 0, -2, ]
...
)";

}  // namespace

std::vector<KnownAnswer> lammps_yaml_known() {
  TiltedPair pair = read_tilted_pair(dump);
  pair.add("time", pair.header.time.value_or(0), 0.125);
  return pair.answers;
}

}  // namespace mdana
