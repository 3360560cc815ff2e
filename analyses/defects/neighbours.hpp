// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "analyses/defects/cell_grid.hpp"

namespace mdana::defects {

struct Neighbour {
  std::uint32_t place;      ///< of the sorted atoms of the grid
  Eigen::Vector3f offset;   ///< from the atom to it [spacings]
  float d2;                 ///< squared distance
};
using Neighbours = std::vector<Neighbour>;

/// Finds the neighbours of one atom after another. For one thread.
class NeighbourSearch {
 public:
  virtual ~NeighbourSearch() = default;
  /// All others within reach, by place. Throws InputError if there are thousands.
  virtual void about(std::uint32_t place, Neighbours& found) = 0;
};

/// Makes searches on the same atoms, one for each thread; the grid must outlive them.
using SearchMaker = std::function<std::unique_ptr<NeighbourSearch>()>;

SearchMaker cell_search(const CellGrid& grid);

/// By CGAL's k-d tree. Finds the same, much slower.
SearchMaker tree_search(const CellGrid& grid);

/// Vector from a sorted atom to another [spacings]; exact if they are neighbours.
Eigen::Vector3f offset(const CellGrid& grid, std::uint32_t from, std::uint32_t to);

/// The squared length, as the kernels compute it.
inline float squared_length(const Eigen::Vector3f& v) {
  return v.x() * v.x() + v.y() * v.y() + v.z() * v.z();
}

[[noreturn]] void too_many_neighbours();

}  // namespace mdana::defects
