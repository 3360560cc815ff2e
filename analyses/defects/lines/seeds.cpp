// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lines/seeds.hpp"

#include "analyses/defects/planes.hpp"

namespace mdana::defects {
namespace {

/// Atoms at the surface that touch a seed become seeds.
void add_surface_beside(std::vector<char>& seeds, const Sites& sites) {
  std::vector<std::uint32_t> places;
  for (std::uint32_t p = 0; p < seeds.size(); ++p)
    if (seeds[p]) places.push_back(p);
  std::vector<std::vector<std::uint32_t>> beside(places.size());
  for_neighbours(sites, places, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
    for (const Neighbour& n : found)
      if (n.d2 < touching * touching && at_surface(sites.site[n.place])) beside[k].push_back(n.place);
  });
  for (const auto& some : beside)
    for (const std::uint32_t place : some) seeds[place] = 1;
}

}  // namespace

std::vector<char> line_seeds(const Sites& sites) {
  std::vector<char> seeds(sites.site.size());
  const auto hcp = places_of(sites, Structure::hcp);
  for_neighbours(sites, hcp, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
    const auto twelve = nearest_twelve(found);
    if (!twelve) return;
    const HcpLayer layer = hcp_layer(*twelve);
    for (std::size_t n = 0; n < 12; ++n)
      if (layer.in_plane[n] && sites.structure[(*twelve)[n].place] != Structure::hcp) seeds[hcp[k]] = 1;
  });
  for (std::uint32_t p = 0; p < seeds.size(); ++p)
    if (sites.site[p] == Site::bulk_defect || sites.site[p] == Site::contact) seeds[p] = 1;
  add_surface_beside(seeds, sites);
  return seeds;
}

}  // namespace mdana::defects
