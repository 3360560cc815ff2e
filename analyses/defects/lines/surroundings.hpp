// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analyses/defects/lines/own_frames.hpp"
#include "analyses/defects/zone.hpp"

namespace mdana::defects {

/// What is about some seeds.
struct Surroundings {
  Zone zone;
  std::vector<OwnFrame> own;       ///< of the zone's atoms
  std::vector<Tetrahedron> cells;  ///< of its filled tetrahedra, in order

  /// What is about other seeds of the frame, so that it is about all: a tetrahedron of the whole crystal is found
  /// about each of its corners.
  void add(Surroundings other);
};

}  // namespace mdana::defects
