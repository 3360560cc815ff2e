// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/clusters.hpp"

#include <algorithm>
#include <numeric>

namespace mdana::defects {
namespace {

/// Calls use(a, b) for the neighbours b of each own fcc atom a that are fcc, too.
template <class Use>
void for_bonds(const Sites& sites, const std::vector<std::uint32_t>& own, const Use& use) {
  const auto search = sites.search();
  Neighbours found;
  for (const std::uint32_t place : own) {
    search->about(place, found);
    for (const Neighbour& n : found)
      if (n.d2 < between_shells * between_shells && sites.structure[n.place] == Structure::fcc) use(place, n.place);
  }
}

}  // namespace

std::vector<std::uint32_t> ClusterFinder::add(const Sites& sites) {
  auto own = places_of(sites, Structure::fcc);
  std::erase_if(own, [&](std::uint32_t place) { return !sites.is_own(place); });
  DisjointSets sets(sites.structure.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> beyond;  // own place, index in another slab
  for_bonds(sites, own, [&](std::uint32_t a, std::uint32_t b) {
    if (!sites.is_own(b))
      beyond.emplace_back(a, sites.index(b));
    else if (b < a)
      sets.join(a, b);
  });
  std::vector<std::uint32_t> piece(sites.structure.size());
  for (const std::uint32_t place : own) {
    std::uint32_t& of_root = piece[sets.root(place)];  // the lowest place, which comes first
    if (of_root == 0) {
      of_root = pieces_.add();
      lowest_.push_back(sites.index(place));
    }
    piece[place] = of_root;
    lowest_[of_root] = std::min(lowest_[of_root], sites.index(place));
  }
  for (const auto& [place, index] : beyond) join_with_last(index, piece[place]);
  remember(sites, piece);
  return piece;
}

void ClusterFinder::join_with_last(std::uint32_t index, std::uint32_t piece) {
  const auto at = std::ranges::lower_bound(last_, std::pair(index, 0u));
  if (at != last_.end() && at->first == index) pieces_.join(at->second, piece);
}

/// Atoms that the next slab may reach: those of the last layer of cells.
void ClusterFinder::remember(const Sites& sites, const std::vector<std::uint32_t>& piece) {
  last_.clear();
  if (sites.slab.whole()) return;
  for (std::size_t cell = 0; cell < sites.grid.cells(); ++cell) {
    if (cell_along(sites.grid.key[cell], sites.slab.axis) + 1 != sites.slab.end) continue;
    for (std::uint32_t place = sites.grid.start[cell]; place < sites.grid.start[cell + 1]; ++place)
      if (piece[place] != 0) last_.emplace_back(sites.index(place), piece[place]);
  }
  std::ranges::sort(last_);
}

std::vector<std::uint32_t> ClusterFinder::numbers() {
  std::vector<std::uint32_t> lowest(lowest_.size(), ~0u), roots, number(lowest_.size());
  for (std::uint32_t piece = 1; piece < lowest_.size(); ++piece) {
    const std::uint32_t root = pieces_.root(piece);
    if (root == piece) roots.push_back(piece);
    lowest[root] = std::min(lowest[root], lowest_[piece]);
  }
  std::ranges::sort(roots, {}, [&](std::uint32_t root) { return lowest[root]; });
  for (std::size_t k = 0; k < roots.size(); ++k) number[roots[k]] = static_cast<std::uint32_t>(k + 1);
  for (std::uint32_t piece = 1; piece < number.size(); ++piece) number[piece] = number[pieces_.root(piece)];
  return number;
}

}  // namespace mdana::defects
