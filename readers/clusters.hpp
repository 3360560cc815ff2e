// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "readers/bodies.hpp"
#include "readers/box.hpp"

namespace mdana {

/// Connected components of points.
struct Clusters {
  double link_distance = 0;             ///< points closer than this are connected [length]
  std::vector<std::uint32_t> of_point;  ///< component of each point, 0, 1, ... in no given order
  std::vector<std::size_t> sizes;       ///< points in each component
};

/// Connects points nearer than 1.5 times the median distance to the nearest neighbour (in fcc and
/// bcc crystals that reaches beyond the second shell, and not across a gap of two layers). Works at
/// any length scale and density contrast. Across periodic faces of the box the nearest images count;
/// positions must then be wrapped into it. Throws InputError at positions that
/// are not finite, or all the same.
Clusters find_clusters(const Eigen::Matrix3Xd& points, const Box& box = {});

/// Components of at least `smallest` points as bodies 1, 2, ... ordered by lowest id; the ids of a
/// body as sorted runs. Points of smaller components belong to no body.
/// Throws InputError if an id stands twice.
std::vector<Bodies::Run> cluster_runs(const Clusters& clusters, std::span<const std::int64_t> ids,
                                      std::size_t smallest);

}  // namespace mdana
