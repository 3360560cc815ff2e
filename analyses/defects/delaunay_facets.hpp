// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace mdana::defects {

/// Corners of a triangle, by the right hand seen from outside.
using Facet = std::array<std::uint32_t, 3>;

/// Facets between tetrahedra of the Delaunay triangulation that are solid, by their circumradius, and
/// those that are not or nothing, as far as they have a corner that is a seed. `number` tells equal points in
/// equal lattices apart: they are moved by 1e-9, hashed from it, which makes the triangulation unique and
/// quick; lengths are those of the points as they are.
std::vector<Facet> boundary_facets(const std::vector<Eigen::Vector3d>& points,
                                   const std::vector<std::uint32_t>& number,
                                   const std::vector<char>& seed, double circumradius);

}  // namespace mdana::defects
