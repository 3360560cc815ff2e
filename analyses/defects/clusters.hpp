// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "analyses/defects/labels.hpp"
#include "readers/disjoint_sets.hpp"

namespace mdana::defects {

/// Connected fcc atoms, joined across slabs.
class ClusterFinder {
 public:
  /// The piece of each of the slab's own fcc atoms, by place: 1, 2, ... among the pieces of all slabs; 0 is none.
  /// Slabs in their order.
  std::vector<std::uint32_t> add(const Sites& sites);
  /// Clusters of the pieces 0 (none), 1, ...: 1, 2, ... by lowest index of an atom.
  std::vector<std::uint32_t> numbers();

 private:
  void remember(const Sites& sites, const std::vector<std::uint32_t>& piece);
  void join_with_last(std::uint32_t index, std::uint32_t piece);

  DisjointSets pieces_{1};
  std::vector<std::uint32_t> lowest_{0};  ///< index of an atom of each piece
  std::vector<std::pair<std::uint32_t, std::uint32_t>> last_;  ///< index and piece at the end of the slab before
};

}  // namespace mdana::defects
