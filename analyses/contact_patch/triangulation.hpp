// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace mdana {

using Triangle = std::array<std::uint32_t, 3>;  ///< indices of its corners

/// The Delaunay triangles of finite points; none if all are on a line. Of points that coincide
/// one is used. Exact predicates: right for any points, scaled ones give the same triangles.
std::vector<Triangle> delaunay_triangles(std::span<const Eigen::Vector2d> points);

}  // namespace mdana
