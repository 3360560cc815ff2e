// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "analyses/defects.hpp"
#include "analyses/defects/frame_shape.hpp"
#include "analyses/defects/zone.hpp"

namespace mdana::defects {

/// The surfaces of bodies 1 and 2, each as if it were alone: the sides of filled tetrahedra among its
/// atoms that no two of them share. The patch: what of both is not at the surface of both together, its mean;
/// error: half the difference, or half of what spans from body to body, whichever is more.
class SurfaceFinder {
 public:
  SurfaceFinder(const FrameShape& shape, double spacing);
  void add(const Sites& sites);
  BodySurfaces surfaces(std::size_t threads) &&;  ///< of all slabs

 private:
  Eigen::Vector3d origin_;
  double spacing_;
  Eigen::AlignedBox3d touching_, near_;  ///< where bodies may touch, and what that may change
  std::array<ZoneParts, 2> bodies_;
  ZoneParts both_;  ///< about the seeds near the other body
};

}  // namespace mdana::defects
