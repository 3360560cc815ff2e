// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "analyses/defects/lines/network.hpp"

namespace mdana::defects {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// Distances along the points.
std::vector<double> along(const Points& points) {
  std::vector<double> s{0};
  for (std::size_t i = 1; i < points.size(); ++i) s.push_back(s.back() + (points[i] - points[i - 1]).norm());
  return s;
}

/// The value at `at` of the parabola through the points within `width` of it, those farther away counting less
/// (Cleveland, J. Am. Stat. Assoc. 74 (1979) 829). A parabola does not shrink circles as a mean does.
Eigen::Vector3d local_parabola(const std::vector<double>& s, const Points& points, double at, double width) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d right = Eigen::Matrix3d::Zero();
  const auto first = std::ranges::lower_bound(s, at - width) - s.begin();
  for (auto i = static_cast<std::size_t>(first); i < s.size() && s[i] < at + width; ++i) {
    const double u = (s[i] - at) / width, edge = 1 - std::abs(u * u * u);
    const double weight = edge * edge * edge;
    const Eigen::Vector3d powers(1, u, u * u);
    normal += weight * powers * powers.transpose();
    right += weight * powers * points[i].transpose();
  }
  normal.diagonal() += Eigen::Vector3d(0, 1e-9, 1e-9) * normal(0, 0);  // fewer than three points
  return normal.ldlt().solve(right).row(0);
}

/// The points of a closed line, gone round once before and once behind.
void go_round(Points& points) {
  const Points once = points;
  points.insert(points.end(), once.begin(), once.end());
  points.insert(points.end(), once.begin(), once.end());
}

}  // namespace

Points smoothed(const Points& raw, bool closed, double width, double step) {
  if (raw.size() < 2) return raw;
  Points points = raw;
  if (closed) go_round(points);
  const std::vector<double> s = along(points);
  const double begin = closed ? s[raw.size()] : 0;
  const double whole = closed ? s[2 * raw.size()] - begin : s.back();
  const double window = std::min(width, whole / (closed ? 3 : 1));
  const auto count = std::max<std::size_t>(closed ? 8 : 2, static_cast<std::size_t>(std::ceil(whole / step)) + 1);
  Points smooth;
  for (std::size_t k = 0; k < count; ++k)
    smooth.push_back(local_parabola(s, points, begin + whole * static_cast<double>(k) / static_cast<double>(count - !closed), window));
  if (closed) smooth.push_back(smooth.front());
  return smooth;
}

void smooth(LineNetwork& network, double width, double step) {
  std::vector<Eigen::Vector3d> sum(network.nodes.size(), Eigen::Vector3d::Zero());
  std::vector<int> count(network.nodes.size());
  for (LineSegment& segment : network.segments) {
    const bool closed = segment.from == segment.to && network.nodes[segment.from].passed;
    Points raw = segment.points;
    if (!closed) {
      raw.insert(raw.begin(), network.nodes[segment.from].at);
      raw.push_back(network.nodes[segment.to].at);
    }
    segment.points = smoothed(raw, closed, width, step);
    for (const auto& [node, at] : {std::pair{segment.from, segment.points.front()}, std::pair{segment.to, segment.points.back()}}) {
      sum[node] += at;
      ++count[node];
    }
  }
  for (std::size_t node = 0; node < sum.size(); ++node)
    if (count[node] > 0) network.nodes[node].at = sum[node] / count[node];
  for (LineSegment& segment : network.segments) {
    segment.points.front() = network.nodes[segment.from].at;
    segment.points.back() = network.nodes[segment.to].at;
  }
}

}  // namespace mdana::defects
