// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "readers/disjoint_sets.hpp"

namespace mdana::defects {
namespace {

using BoundingBox = Eigen::AlignedBox3d;

/// An edge between two triangles.
struct Edge {
  std::uint32_t low, high, triangle;
  auto operator<=>(const Edge&) const = default;
};

Edge edge(std::uint32_t a, std::uint32_t b, std::uint32_t triangle) {
  return {std::min(a, b), std::max(a, b), triangle};
}

/// Parts of a surface: triangles that share an edge are in one.
std::vector<std::uint32_t> parts_of(const std::vector<Corners>& triangles) {
  std::vector<Edge> edges;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(edge(triangles[t][k], triangles[t][(k + 1) % 3], t));
  std::ranges::sort(edges);
  DisjointSets sets(triangles.size());
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].low == edges[i - 1].low && edges[i].high == edges[i - 1].high)
      sets.join(edges[i].triangle, edges[i - 1].triangle);
  std::vector<std::uint32_t> part(triangles.size());
  for (std::uint32_t t = 0; t < part.size(); ++t) part[t] = static_cast<std::uint32_t>(sets.root(t));
  return part;
}

double area_of(const Zone& zone, const Corners& t) {
  return (zone.at[t[1]] - zone.at[t[0]]).cross(zone.at[t[2]] - zone.at[t[0]]).norm() / 2;
}

/// Area and volume of the part that each triangle is of, by its lowest triangle.
std::vector<SurfacePart> by_root(const Zone& zone, const std::vector<Corners>& triangles,
                                 const std::vector<std::uint32_t>& root) {
  std::vector<SurfacePart> parts(triangles.size());
  const double unit = zone.spacing, area = unit * unit, volume = unit * unit * unit;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Corners& t = triangles[i];
    const Eigen::Vector3d& origin = zone.at[triangles[root[i]][0]];  // of the part: no cancellation
    SurfacePart& part = parts[root[i]];
    part.area += area * area_of(zone, t);
    part.volume += volume / 6 *
                   (zone.at[t[0]] - origin).dot((zone.at[t[1]] - origin).cross(zone.at[t[2]] - origin));
    ++part.triangles;
  }
  return parts;
}

/// The corners of the triangles as points of the mesh.
void add_triangles(SurfaceMesh& mesh, const Zone& zone, const std::vector<Corners>& triangles) {
  std::vector<std::uint32_t> point_of(zone.size(), ~0u);
  for (const Corners& t : triangles) {
    Corners& made = mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& point = point_of[t[k]];
      if (point == ~0u) {
        point = static_cast<std::uint32_t>(mesh.points.size());
        mesh.points.push_back(zone.position(t[k]));
      }
      made[k] = point;
    }
  }
}

/// The parts, greatest area first, and the triangles.
SurfaceMesh mesh_of(const Zone& zone, const std::vector<Corners>& triangles) {
  const std::vector<std::uint32_t> root = parts_of(triangles);
  const std::vector<SurfacePart> parts = by_root(zone, triangles, root);
  std::vector<std::uint32_t> order;
  for (std::uint32_t r = 0; r < parts.size(); ++r)
    if (parts[r].triangles > 0) order.push_back(r);
  std::ranges::stable_sort(order, std::greater(), [&](std::uint32_t r) { return parts[r].area; });
  std::vector<std::uint32_t> rank(parts.size());
  SurfaceMesh mesh;
  for (const std::uint32_t r : order) {
    rank[r] = static_cast<std::uint32_t>(mesh.parts.size());
    mesh.parts.push_back(parts[r]);
  }
  for (const std::uint32_t r : root) mesh.part.push_back(rank[r]);
  add_triangles(mesh, zone, triangles);
  return mesh;
}

/// Area and volume with the narrower and the wider limit: half of what they differ by.
void add_errors(SurfaceMesh& mesh, const Zone& zone, const ZoneCells& narrow, const ZoneCells& wide) {
  const SurfaceMesh less = mesh_of(zone, narrow.open), more = mesh_of(zone, wide.open);
  const auto half_range = [](double a, double b, double c) { return (std::max({a, b, c}) - std::min({a, b, c})) / 2; };
  mesh.area_error = half_range(less.area(), mesh.area(), more.area());
  mesh.volume_error = half_range(less.volume(), mesh.volume(), more.volume());
}

/// What a place may be as a seed.
enum Seed : char { no_seed, inner_seed, near_seed };

/// Where a body may end: atoms without structure, and those in touch with another body. Near seeds are those
/// within a box.
std::vector<char> borders(const Sites& sites, const BoundingBox& may_touch, const BoundingBox& near) {
  std::vector<char> seeds(sites.site.size());
  std::vector<std::uint32_t> doubtful;
  for (std::uint32_t p = 0; p < seeds.size(); ++p) {
    if (sites.site[p] != Site::crystal)
      seeds[p] = near.contains(sites.position(p)) ? near_seed : inner_seed;
    else if (may_touch.contains(sites.position(p)))
      doubtful.push_back(p);
  }
  for_neighbours(sites, doubtful, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
    const bool touches = std::ranges::any_of(found, [&](const Neighbour& n) {
      return n.d2 < touching * touching && sites.body[n.place] != sites.body[doubtful[k]];
    });
    if (touches) seeds[doubtful[k]] = near_seed;
  });
  return seeds;
}

/// Triangles of near seeds [spacings^2], by the body that all corners are of; 0: of both.
std::array<double, 3> areas_near(const Zone& zone, const std::vector<Corners>& triangles) {
  std::array<double, 3> areas{};
  for (const Corners& t : triangles) {
    if (std::ranges::any_of(t, [&](std::uint32_t i) { return zone.seed[i] != near_seed; })) continue;
    const bool same = zone.body[t[0]] == zone.body[t[1]] && zone.body[t[0]] == zone.body[t[2]];
    areas[same ? zone.body[t[0]] : 0] += area_of(zone, t);
  }
  return areas;
}

}  // namespace

SurfaceFinder::SurfaceFinder(const FrameShape& shape, double spacing)
    : origin_(shape.box.min()), spacing_(spacing), touching_(shape.overlap(touching * spacing)) {
  constexpr double rim = 3;  ///< [spacings]: beyond it nothing of one body changes the surface of the other
  if (!touching_.isEmpty()) near_ = shape.overlap(rim * spacing);
}

void SurfaceFinder::add(const Sites& sites) {
  std::vector<char> seeds = borders(sites, touching_, near_);
  for (const BodyIndex body : {BodyIndex{1}, BodyIndex{2}}) bodies_[body - 1u].add(sites, seeds, body);
  for (char& seed : seeds)
    if (seed != near_seed) seed = no_seed;
  both_.add(sites, seeds, 0);
}

BodySurfaces SurfaceFinder::surfaces(std::size_t threads) && {
  BodySurfaces found;
  std::array<double, 2> alone{};
  for (std::size_t b = 0; b < 2; ++b) {
    const Zone zone = std::move(bodies_[b]).zone(origin_, spacing_);
    const auto cells = triangulate(zone, false, threads, filled_limits);
    found.body[b] = mesh_of(zone, cells[0].open);
    add_errors(found.body[b], zone, cells[1], cells[2]);
    alone[b] = areas_near(zone, cells[0].open)[b + 1];
  }
  if (touching_.isEmpty()) return found;
  const Zone zone = std::move(both_).zone(origin_, spacing_);
  const auto left = areas_near(zone, triangulate(zone, false, threads).open);
  const double unit = spacing_ * spacing_, first = alone[0] - left[1], second = alone[1] - left[2];
  found.patch = {unit * (first + second) / 2, unit * std::max(std::abs(first - second), left[0]) / 2, dimension::area};
  return found;
}

}  // namespace mdana::defects

namespace mdana {

double SurfaceMesh::area() const {
  double sum = 0;
  for (const SurfacePart& p : parts) sum += p.volume < 0 ? 0 : p.area;
  return sum;
}

double SurfaceMesh::volume() const {
  double sum = 0;
  for (const SurfacePart& p : parts) sum += std::max(0.0, p.volume);
  return sum;
}

std::size_t SurfaceMesh::voids() const {
  return static_cast<std::size_t>(std::ranges::count_if(parts, [](const SurfacePart& p) { return p.volume < 0; }));
}

double SurfaceMesh::void_volume() const {
  double sum = 0;
  for (const SurfacePart& p : parts) sum += std::max(0.0, -p.volume);
  return sum;
}

double SurfaceMesh::radius(double spacing) const {
  return volume() > 0 ? std::cbrt(0.75 / std::numbers::pi * volume()) + spacing / std::sqrt(6.0) : 0;
}

double SurfaceMesh::radius_error(double spacing) const {
  constexpr double layer = 0.1;  // [spacings]; half a layer is 0.41 on {111}, 0.35 on {100}, 0.25 on {110}
  if (!(volume() > 0)) return 0;
  const double of_volume = std::cbrt(0.75 / std::numbers::pi * volume()) * volume_error / (3 * volume());
  return std::hypot(layer * spacing, of_volume);
}

}  // namespace mdana
