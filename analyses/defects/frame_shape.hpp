// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <Eigen/Geometry>

#include "analyses/frame_store.hpp"
#include "analyses/moments.hpp"
#include "readers/box.hpp"

namespace mdana::defects {

/// Where the atoms of a frame are, all together and by body; [0] is not used.
struct FrameShape {
  Eigen::AlignedBox3d box;
  std::array<Eigen::AlignedBox3d, 3> of_body;
  std::array<Moments<3>, 3> moments;  ///< of atoms of mass 1, if they are wanted

  /// Where atoms of both bodies are, and what is within a distance of it; empty if that is nowhere.
  Eigen::AlignedBox3d overlap(double distance) const;
  /// Radii of the ball with as many atoms of fcc, a^3/4 each, and of the one with the same radius of
  /// gyration, sqrt(5/3) r_g; 0 without atoms.
  std::array<double, 2> ball_radii(BodyIndex body, double spacing) const;
};

/// Throws InputError if a position is not finite.
FrameShape shape_of(const FrameStore& frame, bool moments);

/// Throws InputError if a body goes on through a periodic face: its atoms there have no neighbours.
void refuse_wrapped(const FrameStore& frame, const Box& box, double spacing);

}  // namespace mdana::defects
