// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analyses/analysis.hpp"

namespace mdana {

/// Where in a periodic box each body is, however it lies across the faces: the mean direction of
/// the phases 2 pi s of its atoms along each edge, s being the scaled coordinate (Bai & Breen 2008,
/// J. Graph. Tools 13, 53). Columns: sums of cos, sin and s along the three edges, and atoms, of each
/// body.
std::unique_ptr<Analysis> make_box_centres(std::size_t bodies);

/// The periodic images that belong together: atoms are moved to the image nearest to their body's
/// centre, bodies to the image nearest to where they were in the frame before. In the first frame
/// they stay where most of their atoms are, unless that is more than 2/3 of an edge from body 1: then
/// they are its neighbours through the face. For wrapped positions without image flags. Right for bodies that are smaller
/// than half the box and move less than half of it from frame to frame.
class Unwrapping {
 public:
  /// Settles the centres of a frame from its row of `make_box_centres`.
  void begin(const Box& box, std::span<const double> row);

  /// Moves the atoms of a block that belong to a body. Returns how many lie so far from their body's
  /// centre (more than 0.4 of an edge) that their image is uncertain.
  std::size_t apply(AtomBlock& block, std::span<const BodyIndex> body) const;

 private:
  Eigen::Vector3d beside_first(Eigen::Vector3d scaled) const;
  Eigen::Vector3d nearest_image(Eigen::Vector3d scaled, const Eigen::Vector3d& to) const;

  Box box_;
  Eigen::Matrix3d scaling_;               ///< inverse of the edges
  std::vector<Eigen::Vector3d> centres_;  ///< scaled; of body 1, 2, ...
};

}  // namespace mdana
