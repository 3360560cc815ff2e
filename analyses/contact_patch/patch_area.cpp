// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "analyses/contact_patch.hpp"
#include "analyses/contact_patch/triangulation.hpp"

namespace mdana {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Cells by which the edge is off for each atom at it, as layers through crystals of any orientation
/// have rows and gaps; how it was set is told in contact_patch.md.
constexpr double irregular_edge = 0.2;

/// Area of an atom in a close-packed plane, in spacings squared.
const double close_packed = std::sqrt(3.0) / 2;

Points in_spacings(std::span<const Eigen::Vector2d> points, double spacing) {
  Points scaled;
  scaled.reserve(points.size());
  for (const Eigen::Vector2d& p : points) scaled.push_back(p / spacing);
  return scaled;
}

/// Indices by distance from the mean, farthest first: an order that neither the order of the atoms
/// nor the axes of the plane change.
std::vector<std::size_t> outermost_first(const Points& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : points) mean += p / static_cast<double>(points.size());
  std::vector<double> distance;
  for (const Eigen::Vector2d& p : points) distance.push_back((p - mean).squaredNorm());
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return distance[a] > distance[b]; });
  return order;
}

/// Points kept so that no two are nearer than stacked_distance: four at most in a cell.
class Unstacked {
 public:
  void offer(const Eigen::Vector2d& p) {
    const double i = std::floor(p.x() / stacked_distance), j = std::floor(p.y() / stacked_distance);
    for (const double side : {-1, 0, 1}) {
      const auto end = cells_.upper_bound({i + side, j + 1});
      for (auto at = cells_.lower_bound({i + side, j - 1}); at != end; ++at)
        if ((points_[at->second] - p).squaredNorm() < stacked_distance * stacked_distance) return;
    }
    cells_.emplace(Cell(i, j), points_.size());
    points_.push_back(p);
  }
  Points take() { return std::move(points_); }

 private:
  using Cell = std::pair<double, double>;
  std::multimap<Cell, std::size_t> cells_;
  Points points_;
};

Points unstacked(const Points& points) {
  Unstacked kept;
  for (const std::size_t k : outermost_first(points)) kept.offer(points[k]);
  return kept.take();
}

double twice_area(const Points& p, const Triangle& t) {
  const Eigen::Vector2d a = p[t[1]] - p[t[0]], b = p[t[2]] - p[t[0]];
  return std::abs(a.x() * b.y() - a.y() * b.x());
}

/// The circumradius abc/(4A) is at most the greatest; not that of points on a line.
bool is_small(const Points& p, const Triangle& t) {
  const double sides = (p[t[1]] - p[t[0]]).norm() * (p[t[2]] - p[t[1]]).norm() *
                       (p[t[0]] - p[t[2]]).norm();
  return sides < 2 * greatest_circumradius * twice_area(p, t);
}

std::size_t distinct(std::vector<std::uint32_t> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return static_cast<std::size_t>(std::unique(numbers.begin(), numbers.end()) - numbers.begin());
}

std::size_t corners(const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> all;
  for (const Triangle& t : triangles) all.insert(all.end(), t.begin(), t.end());
  return distinct(std::move(all));
}

/// Corners at the edge: those of sides that belong to one triangle only.
std::size_t edge_corners(const std::vector<Triangle>& triangles) {
  std::vector<Edge> sides;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) sides.push_back(std::minmax(t[k], t[(k + 1) % 3]));
  std::sort(sides.begin(), sides.end());
  std::vector<std::uint32_t> at_edge;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i + 1 < sides.size() && sides[i] == sides[i + 1])
      ++i;
    else
      at_edge.insert(at_edge.end(), {sides[i].first, sides[i].second});
  }
  return distinct(std::move(at_edge));
}

}  // namespace

double PatchArea::radius() const { return std::sqrt(area / std::numbers::pi); }

double PatchArea::radius_error() const {
  return area > 0 ? 0.5 * radius() * (error / area) : std::sqrt(error / std::numbers::pi);
}

PatchArea patch_area(std::span<const Eigen::Vector2d> points, double spacing) {
  const Points flat = unstacked(in_spacings(points, spacing));
  std::vector<Triangle> triangles = delaunay_triangles(flat);
  std::erase_if(triangles, [&](const Triangle& t) { return !is_small(flat, t); });
  const double unit = spacing * spacing;
  if (triangles.empty()) return {0, close_packed * static_cast<double>(flat.size()) * unit, 0, 0};
  double twice = 0;
  for (const Triangle& t : triangles) twice += twice_area(flat, t);
  const double cell = twice / static_cast<double>(triangles.size()) * unit;  // two triangles an atom
  PatchArea patch{0, 0, corners(triangles), edge_corners(triangles)};
  const auto edge = static_cast<double>(patch.boundary);
  patch.area = cell * static_cast<double>(patch.atoms);
  patch.error = cell * std::hypot(2 * std::sqrt(edge / 12), irregular_edge * edge);
  return patch;
}

}  // namespace mdana
