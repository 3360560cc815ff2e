// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include "analyses/defects/delaunay_facets.hpp"
#include "readers/disjoint_sets.hpp"

namespace mdana::defects {
namespace {

constexpr double zone_reach = 2 * solid_circumradius;  ///< [spacings] of the seeds: the greatest sphere

/// Points near the seeds [spacings].
struct Zone {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::uint32_t> number;  ///< of the atom in the frame
  std::vector<char> seed;
};

/// Places of atoms of the other body that may touch this one: in the box about it.
std::vector<std::uint32_t> others_near(const Sites& sites, const FrameAtoms& atoms, BodyIndex body) {
  const auto position = [&](std::size_t p) {
    const std::uint32_t i = sites.grid.atom[p];
    return Eigen::Vector3d(atoms.x[i], atoms.y[i], atoms.z[i]);
  };
  Eigen::AlignedBox3d box;
  for (std::size_t p = 0; p < sites.body.size(); ++p)
    if (sites.body[p] == body) box.extend(position(p));
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(reach * sites.grid.spacing);
  const Eigen::AlignedBox3d about(box.min() - margin, box.max() + margin);
  std::vector<std::uint32_t> places;
  for (std::size_t p = 0; p < sites.body.size(); ++p)
    if (sites.body[p] != body && about.contains(position(p)))
      places.push_back(static_cast<std::uint32_t>(p));
  return places;
}

/// Atoms of the body without a structure, and those that have one only with atoms of the other body.
std::vector<char> seeds(const Sites& sites, const FrameAtoms& atoms, BodyIndex body) {
  std::vector<char> seed(sites.structure.size());
  for (std::size_t p = 0; p < seed.size(); ++p)
    seed[p] = sites.body[p] == body && sites.site[p] != Site::crystal;
  const auto others = others_near(sites, atoms, body);
  std::vector<std::vector<std::uint32_t>> beside(others.size());
  for_neighbours(sites, others, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
    for (const Neighbour& n : found)
      if (sites.body[n.place] == body) beside[k].push_back(n.place);
  });
  for (const auto& places : beside)
    for (const std::uint32_t place : places) seed[place] = 1;
  return seed;
}

/// Cells of the grid whose atoms may be in reach of a seed: two rows of cells on every side.
class NearSeeds {
 public:
  NearSeeds(const CellGrid& grid, const std::vector<char>& seed) : near_(grid.cells()) {
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
      const auto first = seed.begin() + grid.start[cell], end = seed.begin() + grid.start[cell + 1];
      if (std::find(first, end, 1) == end) continue;
      for (int dz = -2; dz <= 2; ++dz)
        for (int dy = -2; dy <= 2; ++dy) mark(grid, grid.key[cell], dy, dz);
    }
  }
  bool operator[](std::size_t cell) const { return near_[cell]; }

 private:
  void mark(const CellGrid& grid, std::uint64_t key, int dy, int dz) {
    const std::uint64_t low = key_beside(key, -2, dy, dz);
    for (std::size_t at = grid.at_or_after(low); at < grid.cells() && grid.key[at] <= low + 4; ++at)
      near_[at] = true;
  }
  std::vector<bool> near_;
};

Zone zone_of(const Sites& sites, const FrameAtoms& atoms, BodyIndex body) {
  static_assert(zone_reach < 2 * reach);
  const std::vector<char> seed = seeds(sites, atoms, body);
  const NearSeeds near(sites.grid, seed);
  const double scale = 1 / sites.grid.spacing;
  const std::uint32_t first = sites.grid.atom.front();
  const Eigen::Vector3d origin(atoms.x[first], atoms.y[first], atoms.z[first]);
  Zone zone;
  for (std::size_t cell = 0; cell < sites.grid.cells(); ++cell) {
    if (!near[cell]) continue;
    for (std::uint32_t p = sites.grid.start[cell]; p < sites.grid.start[cell + 1]; ++p) {
      if (sites.body[p] != body) continue;
      const std::uint32_t i = sites.grid.atom[p];
      zone.points.push_back(scale * (Eigen::Vector3d(atoms.x[i], atoms.y[i], atoms.z[i]) - origin));
      zone.number.push_back(i);
      zone.seed.push_back(seed[p]);
    }
  }
  return zone;
}

/// Twice the area and six times the volume of one closed surface.
struct Sheet {
  double area = 0, volume = 0;
};

std::map<std::uint32_t, Sheet> closed_sheets(const Zone& zone, const std::vector<Facet>& facets) {
  DisjointSets sets(zone.points.size());
  for (const Facet& f : facets) {
    sets.join(f[0], f[1]);
    sets.join(f[0], f[2]);
  }
  std::map<std::uint32_t, Sheet> sheets;
  for (const Facet& f : facets) {
    const auto &a = zone.points[f[0]], &b = zone.points[f[1]], &c = zone.points[f[2]];
    Sheet& sheet = sheets[sets.root(f[0])];
    sheet.area += (b - a).cross(c - a).norm();
    sheet.volume += a.dot(b.cross(c));
  }
  return sheets;
}

}  // namespace

BodySurface find_surface(const Sites& sites, const FrameAtoms& atoms, BodyIndex body) {
  const Zone zone = zone_of(sites, atoms, body);
  const auto facets = boundary_facets(zone.points, zone.number, zone.seed, solid_circumradius);
  const double d = sites.grid.spacing;
  BodySurface surface;
  for (const auto& [root, sheet] : closed_sheets(zone, facets)) {
    const double volume = d * d * d * sheet.volume / 6;
    if (volume < 0) {
      ++surface.voids;
      surface.void_volume -= volume;
      continue;
    }
    surface.area += d * d * sheet.area / 2;
    surface.volume += volume;
  }
  if (surface.volume > 0)
    surface.radius = std::cbrt(3 * surface.volume / (4 * std::numbers::pi)) + d / std::sqrt(6.0);
  return surface;
}

}  // namespace mdana::defects
