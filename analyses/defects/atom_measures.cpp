// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/atom_measures.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace mdana::defects {
namespace {

std::vector<std::uint32_t> all_places(const Sites& sites) {
  std::vector<std::uint32_t> places(sites.structure.size());
  std::iota(places.begin(), places.end(), 0u);
  return places;
}

double least_pairs(const std::array<Neighbour, 12>& all) {
  std::vector<double> pairs;
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t k = 0; k < i; ++k)
      pairs.push_back((all[i].offset + all[k].offset).cast<double>().squaredNorm());
  std::nth_element(pairs.begin(), pairs.begin() + 6, pairs.end());
  std::sort(pairs.begin(), pairs.begin() + 6);
  return std::accumulate(pairs.begin(), pairs.begin() + 6, 0.0);
}

}  // namespace

std::vector<float> centro_symmetry(const Sites& sites) {
  std::vector<float> values(sites.structure.size(), std::numeric_limits<float>::quiet_NaN());
  const double unit = sites.grid.spacing * sites.grid.spacing;
  for_neighbours(sites, all_places(sites), [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
    if (const auto twelve = nearest_twelve(found))
      values[k] = static_cast<float>(least_pairs(*twelve) * unit);
  });
  return values;
}

std::vector<std::uint8_t> coordination(const Sites& sites) {
  std::vector<std::uint8_t> values(sites.structure.size());
  for_neighbours(sites, all_places(sites), [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
    const auto count = std::count_if(found.begin(), found.end(), [](const Neighbour& n) {
      return n.d2 < between_shells * between_shells;
    });
    values[k] = static_cast<std::uint8_t>(std::min<std::ptrdiff_t>(count, 255));
  });
  return values;
}

}  // namespace mdana::defects
