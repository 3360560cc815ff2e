// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include "analyses/defects/neighbours.hpp"
#include "analyses/defects/structure_kernel.hpp"

namespace mdana::defects {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using NumberedPoint = std::pair<Kernel::Point_3, std::uint32_t>;
using Traits = CGAL::Search_traits_adapter<NumberedPoint,
                                           CGAL::First_of_pair_property_map<NumberedPoint>,
                                           CGAL::Search_traits_3<Kernel>>;
using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
using Tree = Search::Tree;

/// Whole positions of the sorted atoms, modulo nothing, in spacings: cell and place in it.
Kernel::Point_3 point(const CellGrid& grid, std::size_t cell, std::uint32_t place) {
  const auto middle = middle_of(grid.key[cell]);
  const std::int32_t at[] = {grid.x[place], grid.y[place], grid.z[place]};
  double position[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto number = static_cast<double>(grid.key[cell] >> (21 * k) & 0x1fffff);
    const auto within = static_cast<std::int32_t>(static_cast<std::uint32_t>(at[k]) -
                                                  static_cast<std::uint32_t>(middle[k]));
    position[k] = (number - 0.5) * reach + within / units_a_spacing;
  }
  return {position[0], position[1], position[2]};
}

struct PointTree {
  explicit PointTree(const CellGrid& grid) {
    for (std::size_t cell = 0; cell < grid.cells(); ++cell)
      for (std::uint32_t place = grid.start[cell]; place < grid.start[cell + 1]; ++place)
        points.emplace_back(point(grid, cell, place), place);
    tree.insert(points.begin(), points.end());
    tree.build();
  }
  std::vector<NumberedPoint> points;
  Tree tree;
};

class TreeSearch final : public NeighbourSearch {
 public:
  TreeSearch(const CellGrid& grid, std::shared_ptr<const PointTree> points)
      : grid_(grid), points_(std::move(points)) {}

  void about(std::uint32_t place, Neighbours& found) override {
    constexpr double beyond = 1.001 * reach;
    for (unsigned count = 24;; count *= 2) {
      if (count > Candidates::capacity) too_many_neighbours();
      const Search search(points_->tree, points_->points[place].first, count);
      found.clear();
      double farthest = 0;
      for (const auto& [point, d2] : search) {
        farthest = std::max(farthest, d2);
        take(place, point.second, found);
      }
      if (farthest > beyond * beyond || count >= points_->points.size()) break;
    }
    std::sort(found.begin(), found.end(),
              [](const Neighbour& a, const Neighbour& b) { return a.place < b.place; });
  }

 private:
  void take(std::uint32_t place, std::uint32_t other, Neighbours& found) const {
    if (other == place) return;
    const Eigen::Vector3f to = offset(grid_, place, other);
    const float d2 = squared_length(to);
    if (d2 < static_cast<float>(reach * reach)) found.push_back({other, to, d2});
  }

  const CellGrid& grid_;
  std::shared_ptr<const PointTree> points_;
};

}  // namespace

SearchMaker tree_search(const CellGrid& grid) {
  return [&grid, points = std::make_shared<const PointTree>(grid)] {
    return std::make_unique<TreeSearch>(grid, points);
  };
}

}  // namespace mdana::defects
