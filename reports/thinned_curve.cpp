// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/thinned_curve.hpp"

#include <algorithm>
#include <utility>

namespace mdana {
namespace {

using Eigen::Vector2d;

double distance_to_line(const Vector2d& point, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a, from = point - a;
  const double part = along.squaredNorm() > 0 ? std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
  return (from - part * along).norm();
}

}  // namespace

std::vector<Vector2d> thinned_curve(const std::vector<Vector2d>& points, double tolerance) {
  if (points.size() < 3) return points;
  std::vector<char> kept(points.size(), 0);
  kept.front() = kept.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> parts{{0, points.size() - 1}};
  while (!parts.empty()) {
    const auto [first, last] = parts.back();
    parts.pop_back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i)
      if (const double d = distance_to_line(points[i], points[first], points[last]); d > most) farthest = i, most = d;
    if (farthest == first) continue;
    kept[farthest] = 1;
    parts.insert(parts.end(), {{first, farthest}, {farthest, last}});
  }
  std::vector<Vector2d> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) result.push_back(points[i]);
  return result;
}

}  // namespace mdana
