// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_patch/triangulation.hpp"

#include <utility>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace mdana {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

}  // namespace

std::vector<Triangle> delaunay_triangles(std::span<const Eigen::Vector2d> points) {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> numbered;
  numbered.reserve(points.size());
  for (const Eigen::Vector2d& p : points)
    numbered.emplace_back(Kernel::Point_2(p.x(), p.y()), static_cast<std::uint32_t>(numbered.size()));
  const Delaunay delaunay(numbered.begin(), numbered.end());
  std::vector<Triangle> triangles;
  for (const auto face : delaunay.finite_face_handles())
    triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return triangles;
}

}  // namespace mdana
