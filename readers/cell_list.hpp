// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace mdana {

/// Points sorted by the cubic cell that holds them; only occupied cells are kept, so that empty
/// space costs nothing. The points, at least one and all finite, must outlive it.
class CellList {
 public:
  /// Cells of width `edge` [length].
  CellList(const Eigen::Matrix3Xd& points, double edge) : points_(points), edge_(edge) {
    origin_ = points.rowwise().minCoeff();
    for (Eigen::Index i = 0; i < points.cols(); ++i) sorted_.emplace_back(cell_of(i), i);
    std::sort(sorted_.begin(), sorted_.end());
  }

  /// Calls use(j, squared distance) for the other points j in the 27 cells around point i.
  template <class Use>
  void for_neighbours(Eigen::Index i, Use&& use) const {
    const Cell c = cell_of(i);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for_row({c[0] + dx, c[1] + dy, c[2] - 1}, {c[0] + dx, c[1] + dy, c[2] + 1}, i, use);
  }

  /// Calls use(i, j, squared distance) once for each two points in the same or in adjacent cells;
  /// in all, the time of the number of points and of such pairs.
  template <class Use>
  void for_pairs(Use&& use) const {
    constexpr std::array<std::array<std::int64_t, 2>, 4> ahead{{{0, 1}, {1, -1}, {1, 0}, {1, 1}}};
    std::array<Place, 4> from;  // where the rows ahead begin: later and later, as points are sorted
    from.fill(sorted_.begin());
    for (Place at = sorted_.begin(); at != sorted_.end(); ++at) {
      const Cell& c = at->first;
      pair_with(at, std::next(at), {c[0], c[1], c[2] + 1}, use);
      for (std::size_t row = 0; row < ahead.size(); ++row) {
        const auto [dx, dy] = ahead[row];
        const Cell first{c[0] + dx, c[1] + dy, c[2] - 1}, last{first[0], first[1], c[2] + 1};
        while (from[row] != sorted_.end() && from[row]->first < first) ++from[row];
        pair_with(at, from[row], last, use);
      }
    }
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  using Place = std::vector<std::pair<Cell, Eigen::Index>>::const_iterator;

  template <class Use>
  void pair_with(Place at, Place it, const Cell& last, Use& use) const {
    for (; it != sorted_.end() && it->first <= last; ++it)
      use(at->second, it->second,
          (points_.col(it->second) - points_.col(at->second)).squaredNorm());
  }

  Cell cell_of(Eigen::Index i) const {
    const Eigen::Vector3d scaled = ((points_.col(i) - origin_) / edge_).cwiseMin(0x1p62);
    return {static_cast<std::int64_t>(scaled.x()), static_cast<std::int64_t>(scaled.y()),
            static_cast<std::int64_t>(scaled.z())};
  }

  template <class Use>
  void for_row(const Cell& first, const Cell& last, Eigen::Index i, Use& use) const {
    auto it = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{first, Eigen::Index{0}});
    for (; it != sorted_.end() && it->first <= last; ++it)
      if (it->second != i)
        use(it->second, (points_.col(it->second) - points_.col(i)).squaredNorm());
  }

  const Eigen::Matrix3Xd& points_;
  double edge_;
  Eigen::Vector3d origin_;
  std::vector<std::pair<Cell, Eigen::Index>> sorted_;
};

}  // namespace mdana
