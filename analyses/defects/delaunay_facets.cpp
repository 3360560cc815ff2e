// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/delaunay_facets.hpp"

#include <utility>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace mdana::defects {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using Cell = CGAL::Triangulation_cell_base_with_info_3<  // whether it is solid
    bool, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

/// A number of -1 to 1 from two, without pattern (the finaliser of MurmurHash3).
double hashed(std::uint64_t a, std::uint64_t b) {
  std::uint64_t h = 4 * a + b + 0x9e3779b97f4a7c15;
  h = (h ^ (h >> 33)) * 0xff51afd7ed558ccd;
  h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53;
  return static_cast<double>(static_cast<std::int64_t>(h ^ (h >> 33))) * 0x1p-63;
}

/// Whether the circumsphere is small; its centre c from the first corner: 2 (p_i - p_0) . c = |p_i - p_0|^2.
bool is_solid(Delaunay::Cell_handle cell, const std::vector<Eigen::Vector3d>& points, double radius) {
  const auto corner = [&](int i) { return points[cell->vertex(i)->info()]; };
  Eigen::Matrix3d edges;
  for (int i = 0; i < 3; ++i) edges.row(i) = corner(i + 1) - corner(0);
  const Eigen::Vector3d squares = edges.rowwise().squaredNorm();
  const Eigen::Vector3d twice = edges.inverse() * squares;
  return twice.norm() < 2 * radius;
}

/// The three corners opposite to one, seen from outside.
Facet opposite(Delaunay::Cell_handle cell, int i, const std::vector<Eigen::Vector3d>& points) {
  Facet facet;
  for (int k = 0; k < 3; ++k) facet[static_cast<std::size_t>(k)] = cell->vertex((i + 1 + k) % 4)->info();
  const Eigen::Vector3d& a = points[facet[0]];
  const Eigen::Vector3d normal = (points[facet[1]] - a).cross(points[facet[2]] - a);
  if (normal.dot(points[cell->vertex(i)->info()] - a) > 0) std::swap(facet[1], facet[2]);
  return facet;
}

}  // namespace

std::vector<Facet> boundary_facets(const std::vector<Eigen::Vector3d>& points,
                                   const std::vector<std::uint32_t>& number,
                                   const std::vector<char>& seed, double circumradius) {
  std::vector<std::pair<Kernel::Point_3, std::uint32_t>> moved;
  moved.reserve(points.size());
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    const auto along = [&](int axis) {
      return points[k][axis] + 1e-9 * hashed(number[k], static_cast<std::uint64_t>(axis));
    };
    moved.emplace_back(Kernel::Point_3(along(0), along(1), along(2)), k);
  }
  Delaunay delaunay(moved.begin(), moved.end());
  std::vector<Facet> facets;
  if (delaunay.dimension() < 3) return facets;
  for (const auto cell : delaunay.all_cell_handles())
    cell->info() = !delaunay.is_infinite(cell) && is_solid(cell, points, circumradius);
  for (const auto cell : delaunay.finite_cell_handles()) {
    for (int i = 0; i < 4 && cell->info(); ++i) {
      if (cell->neighbor(i)->info()) continue;
      const Facet facet = opposite(cell, i, points);
      if (seed[facet[0]] || seed[facet[1]] || seed[facet[2]]) facets.push_back(facet);
    }
  }
  return facets;
}

}  // namespace mdana::defects
