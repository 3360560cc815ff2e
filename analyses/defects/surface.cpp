// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "readers/disjoint_sets.hpp"

namespace mdana::defects {
namespace {

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

/// Area and volume of each part, greatest area first; the triangles in that order, too.
SurfaceMesh mesh_of(const Zone& zone, const std::vector<Corners>& triangles, double spacing) {
  const std::vector<std::uint32_t> root = parts_of(triangles);
  std::vector<SurfacePart> by_root(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Corners& t = triangles[i];
    const Eigen::Vector3d& origin = zone.at[triangles[root[i]][0]];  // of the part: no cancellation
    SurfacePart& part = by_root[root[i]];
    part.area += area_of(zone, t);
    part.volume += (zone.at[t[0]] - origin).dot((zone.at[t[1]] - origin).cross(zone.at[t[2]] - origin)) / 6;
    ++part.triangles;
  }
  std::vector<std::uint32_t> order;
  for (std::uint32_t r = 0; r < by_root.size(); ++r)
    if (by_root[r].triangles > 0) order.push_back(r);
  std::ranges::stable_sort(order, std::greater(), [&](std::uint32_t r) { return by_root[r].area; });
  std::vector<std::uint32_t> rank(by_root.size());
  SurfaceMesh mesh;
  for (const std::uint32_t r : order) {
    rank[r] = static_cast<std::uint32_t>(mesh.parts.size());
    SurfacePart part = by_root[r];
    part.area *= spacing * spacing;
    part.volume *= spacing * spacing * spacing;
    mesh.parts.push_back(part);
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Corners& t = triangles[i];
    mesh.triangles.push_back({zone.atom[t[0]], zone.atom[t[1]], zone.atom[t[2]]});
    mesh.part.push_back(rank[root[i]]);
  }
  return mesh;
}

using BoundingBox = Eigen::AlignedBox3d;

Eigen::Vector3d position(const Sites& sites, const FrameAtoms& atoms, std::size_t place) {
  const std::uint32_t i = sites.grid.atom[place];
  return {atoms.x[i], atoms.y[i], atoms.z[i]};
}

/// Where atoms of both bodies are, and what is within a distance of it; empty if that is nowhere.
BoundingBox overlap(const Sites& sites, const FrameAtoms& atoms, double distance) {
  std::array<BoundingBox, 3> box;
  for (std::size_t p = 0; p < sites.body.size(); ++p)
    if (sites.body[p] <= 2) box[sites.body[p]].extend(position(sites, atoms, p));
  if (box[1].isEmpty() || box[2].isEmpty()) return {};
  const Eigen::Vector3d rim = Eigen::Vector3d::Constant(distance);
  for (BoundingBox& b : box) b = {b.min() - rim, b.max() + rim};
  return box[1].intersection(box[2]);
}

/// Where a body may end: atoms without structure, and those in touch with another body.
std::vector<char> borders(const Sites& sites, const FrameAtoms& atoms) {
  std::vector<char> seeds(sites.site.size());
  std::vector<std::uint32_t> doubtful;
  const BoundingBox both = overlap(sites, atoms, touching * sites.grid.spacing);
  for (std::uint32_t p = 0; p < seeds.size(); ++p) {
    seeds[p] = sites.site[p] != Site::crystal;
    if (!seeds[p] && both.contains(position(sites, atoms, p))) doubtful.push_back(p);
  }
  std::vector<char> touches(doubtful.size());
  for_neighbours(sites, doubtful, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
    touches[k] = std::ranges::any_of(found, [&](const Neighbour& n) {
      return n.d2 < touching * touching && sites.body[n.place] != sites.body[doubtful[k]];
    });
  });
  for (std::size_t k = 0; k < doubtful.size(); ++k) seeds[doubtful[k]] = touches[k];
  return seeds;
}

/// Triangles of atoms that are all `near`, by the body that all corners are of; 0: of both.
std::array<double, 3> areas_near(const SurfaceMesh& mesh, const FrameAtoms& atoms, const std::vector<char>& near) {
  std::array<double, 3> areas{};
  const auto at = [&](std::uint32_t i) { return Eigen::Vector3d(atoms.x[i], atoms.y[i], atoms.z[i]); };
  for (const auto& t : mesh.triangles) {
    if (!near[t[0]] || !near[t[1]] || !near[t[2]]) continue;
    const bool same = atoms.body[t[0]] == atoms.body[t[1]] && atoms.body[t[0]] == atoms.body[t[2]];
    areas[same ? atoms.body[t[0]] : 0] += (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).norm() / 2;
  }
  return areas;
}

/// What of the bodies' surfaces is not at the surface of both together.
Value patch(const Sites& sites, const FrameAtoms& atoms, const std::vector<char>& seeds,
            const std::array<SurfaceMesh, 2>& bodies) {
  constexpr double rim = 3;  ///< [spacings]: beyond it nothing of one body changes the surface of the other
  const BoundingBox both = overlap(sites, atoms, rim * sites.grid.spacing);
  std::vector<char> near_seeds(seeds.size()), near(seeds.size());
  for (std::size_t p = 0; p < seeds.size(); ++p)
    near_seeds[p] = near[sites.grid.atom[p]] = seeds[p] && both.contains(position(sites, atoms, p));
  const Zone zone = zone_about(sites, atoms, near_seeds, 0);
  const SurfaceMesh together = mesh_of(zone, triangulate(zone, false, sites.threads).open, sites.grid.spacing);
  const auto left = areas_near(together, atoms, near);
  const double first = areas_near(bodies[0], atoms, near)[1] - left[1];
  const double second = areas_near(bodies[1], atoms, near)[2] - left[2];
  return {(first + second) / 2, std::max(std::abs(first - second), left[0]) / 2, dimension::area};
}

}  // namespace

BodySurfaces find_surfaces(const Sites& sites, const FrameAtoms& atoms) {
  const std::vector<char> seeds = borders(sites, atoms);
  BodySurfaces found;
  for (const BodyIndex body : {BodyIndex{1}, BodyIndex{2}}) {
    const Zone zone = zone_about(sites, atoms, seeds, body);
    found.body[body - 1u] = mesh_of(zone, triangulate(zone, false, sites.threads).open, sites.grid.spacing);
  }
  if (!overlap(sites, atoms, touching * sites.grid.spacing).isEmpty())
    found.patch = patch(sites, atoms, seeds, found.body);
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

}  // namespace mdana
