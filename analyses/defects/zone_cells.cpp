// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "analyses/defects/atom_hash.hpp"
#include "analyses/defects/zone.hpp"
#include "analyses/ranges.hpp"

namespace mdana::defects {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
/// With the squared circumradius of a cell that has a seed and its circumcentre in the slab.
using Cell = CGAL::Triangulation_cell_base_with_info_3<double, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

constexpr std::size_t most_atoms = 30000, least_atoms = 2000;  ///< of a slab, about
constexpr double thick = 16 * widest_limit;  ///< for a slab: what it shares with others is an eighth of that
constexpr double shift = 1e-9;  ///< [spacings]

/// A number from -1 to 1 that depends on an atom and an axis alone.
double scatter(std::int64_t number, std::uint64_t axis) {
  return static_cast<double>(static_cast<std::int64_t>(hash_of(static_cast<std::uint64_t>(number) * 3 + axis))) *
         0x1p-63;
}

std::vector<Eigen::Vector3d> shifted(const Zone& zone) {
  std::vector<Eigen::Vector3d> points = zone.at;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (Eigen::Index k = 0; k < 3; ++k)
      points[i][k] += shift * scatter(zone.number[i], static_cast<std::uint64_t>(k));
  return points;
}

/// Circumcentre relative to the first corner; not finite for a flat one.
Eigen::Vector3d circumcentre(const std::vector<Eigen::Vector3d>& points, const Tetrahedron& t) {
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k) edges.row(k) = points[t[static_cast<std::size_t>(k) + 1]] - points[t[0]];
  return edges.inverse() * (edges.rowwise().squaredNorm() / 2);
}

/// Atoms between two coordinates, and those beyond that may touch a circumsphere about them.
struct ZoneSlab {
  double low, high;
  std::vector<std::uint32_t> atoms;
};

/// Cuts across the longest side; where, follows from the atoms alone.
std::vector<ZoneSlab> slabs_of(const std::vector<Eigen::Vector3d>& points, Eigen::Index& axis) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(p);
  box.sizes().maxCoeff(&axis);
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto along = [&](std::uint32_t i) { return points[i][axis]; };
  std::ranges::sort(order, {}, along);
  const auto thick_ones = static_cast<std::size_t>(box.sizes()[axis] / thick);
  const std::size_t count = std::max(points.size() / most_atoms, std::min(points.size() / least_atoms, thick_ones)) + 1;
  std::vector<ZoneSlab> slabs;
  for (std::size_t k = 0; k < count; ++k) {
    ZoneSlab slab{k == 0 ? -HUGE_VAL : along(order[k * points.size() / count]),
              k + 1 == count ? HUGE_VAL : along(order[(k + 1) * points.size() / count]), {}};
    const auto first = std::ranges::lower_bound(order, slab.low - widest_limit, {}, along);
    const auto end = std::ranges::upper_bound(order, slab.high + widest_limit, {}, along);
    slab.atoms.assign(first, end);
    slabs.push_back(std::move(slab));
  }
  return slabs;
}

/// The triangulation of a slab, and which of its cells are its own.
class SlabCells {
 public:
  SlabCells(const Zone& zone, const std::vector<Eigen::Vector3d>& points, const ZoneSlab& slab, Eigen::Index axis)
      : zone_(zone), points_(points), slab_(slab), axis_(axis) {
    std::vector<std::pair<Kernel::Point_3, std::uint32_t>> numbered;
    for (const std::uint32_t i : slab.atoms)
      numbered.emplace_back(Kernel::Point_3(points[i].x(), points[i].y(), points[i].z()), i);
    delaunay_.insert(numbered.begin(), numbered.end());
    for (const auto cell : delaunay_.all_cell_handles()) cell->info() = squared_radius(cell);
  }

  /// What is filled by a limit.
  void collect(double limit, ZoneCells& found, bool cells) const {
    const auto filled = [limit](const Handle& cell) { return cell->info() < limit * limit; };
    for (const auto cell : delaunay_.finite_cell_handles()) {
      if (!filled(cell)) continue;
      if (cells) found.cells.push_back(turned(cell));
      for (int side = 0; side < 4; ++side)
        if (!filled(cell->neighbor(side))) add(found.open, cell, side);
    }
  }

 private:
  using Handle = Delaunay::Cell_handle;

  /// Ascending, so that what is computed of them is the same in every slab.
  Tetrahedron corners(const Handle& cell) const {
    Tetrahedron t;
    for (int k = 0; k < 4; ++k) t[static_cast<std::size_t>(k)] = cell->vertex(k)->info();
    std::ranges::sort(t);
    return t;
  }

  /// Ascending but for the last two, which come in the order that turns the cell as CGAL does.
  Tetrahedron turned(const Handle& cell) const {
    bool even = true;
    for (int k = 0; k < 4; ++k)
      for (int m = 0; m < k; ++m) even ^= cell->vertex(m)->info() > cell->vertex(k)->info();
    Tetrahedron t = corners(cell);
    if (!even) std::swap(t[2], t[3]);
    return t;
  }

  /// Of a cell with a seed and its circumcentre within the slab; else infinite.
  double squared_radius(const Handle& cell) const {
    if (delaunay_.is_infinite(cell)) return HUGE_VAL;
    const Tetrahedron t = corners(cell);
    if (std::ranges::none_of(t, [&](std::uint32_t i) { return zone_.seed[i]; })) return HUGE_VAL;
    const Eigen::Vector3d centre = circumcentre(points_, t);
    const double along = points_[t[0]][axis_] + centre[axis_];
    return along >= slab_.low && along < slab_.high ? centre.squaredNorm() : HUGE_VAL;
  }

  void add(std::vector<Corners>& open, const Handle& cell, int side) const {
    Corners facet;
    for (std::size_t k = 0; k < 3; ++k) facet[k] = cell->vertex(static_cast<int>(outward[side][k]))->info();
    std::ranges::rotate(facet, std::ranges::min_element(facet));
    if (std::ranges::any_of(facet, [&](std::uint32_t i) { return zone_.seed[i]; })) open.push_back(facet);
  }

  const Zone& zone_;
  const std::vector<Eigen::Vector3d>& points_;
  const ZoneSlab& slab_;
  Eigen::Index axis_;
  Delaunay delaunay_;
};

/// Sorts the facets and removes those that two slabs share, each turned to its own side.
void close_shared(std::vector<Corners>& open) {
  const auto unturned = [](const Corners& f) { return Corners{f[0], std::min(f[1], f[2]), std::max(f[1], f[2])}; };
  std::ranges::sort(open, [&](const Corners& a, const Corners& b) {
    return std::pair(unturned(a), a) < std::pair(unturned(b), b);
  });
  std::vector<Corners> left;
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (i + 1 < open.size() && unturned(open[i]) == unturned(open[i + 1]))
      ++i;
    else
      left.push_back(open[i]);
  }
  open = std::move(left);
}

}  // namespace

std::vector<ZoneCells> triangulate(const Zone& zone, bool cells, std::size_t threads, std::span<const double> limits) {
  std::vector<ZoneCells> all(limits.size());
  if (zone.size() < 4) return all;
  const std::vector<Eigen::Vector3d> points = shifted(zone);
  Eigen::Index axis = 0;
  const std::vector<ZoneSlab> slabs = slabs_of(points, axis);
  std::vector<std::vector<ZoneCells>> parts(slabs.size(), all);
  for_ranges(slabs.size(), 1, threads, [&](std::size_t first, std::size_t end) {
    for (std::size_t k = first; k < end; ++k) {
      const SlabCells found(zone, points, slabs[k], axis);
      for (std::size_t i = 0; i < limits.size(); ++i) found.collect(limits[i], parts[k][i], cells);
    }
  });
  for (std::size_t i = 0; i < limits.size(); ++i) {
    for (auto& part : parts) {
      all[i].cells.insert(all[i].cells.end(), part[i].cells.begin(), part[i].cells.end());
      all[i].open.insert(all[i].open.end(), part[i].open.begin(), part[i].open.end());
      part[i] = {};
    }
    std::ranges::sort(all[i].cells);
    close_shared(all[i].open);
  }
  return all;
}

ZoneCells triangulate(const Zone& zone, bool cells, std::size_t threads) {
  return std::move(triangulate(zone, cells, threads, std::span(filled_limits).first(1)).front());
}

}  // namespace mdana::defects
