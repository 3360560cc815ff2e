// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/labels.hpp"

#include <algorithm>

#include "analyses/ranges.hpp"

namespace mdana::defects {
namespace {

constexpr std::size_t cells_at_once = 512;
constexpr std::size_t places_at_once = 256;

void label_by_kernel(Sites& sites) {
  const StructureKernel& kernel = best_structure_kernel();
  auto* const labels = reinterpret_cast<std::uint8_t*>(sites.structure.data());
  for_ranges(sites.grid.cells(), cells_at_once, sites.threads, [&](std::size_t first, std::size_t end) {
    float* margins = sites.margin.empty() ? nullptr : sites.margin.data();
    if (kernel.label(sites.grid, first, end, labels, margins) != end) too_many_neighbours();
  });
}

void label_by_search(Sites& sites) {
  std::vector<std::uint32_t> all(sites.structure.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
  for_neighbours(sites, all, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
    const Labelled labelled = common_neighbour_structure(found);
    sites.structure[k] = labelled.structure;
    if (!sites.margin.empty()) sites.margin[k] = labelled.margin;
  });
}

}  // namespace

Sites::Sites(const CellGrid& of_grid, const SearchMaker& maker, std::size_t with_threads, const Slab& of_slab,
             bool margins)
    : grid(of_grid), search(maker), threads(with_threads), slab(of_slab), structure(slab.atoms->size()) {
  body.reserve(structure.size());
  for (const std::uint32_t i : grid.atom) body.push_back(slab.atoms->body[i]);
  if (margins) margin.resize(structure.size());
  if (slab.whole()) return;
  own.reserve(structure.size());
  for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
    const std::uint64_t along = cell_along(grid.key[cell], slab.axis);
    own.insert(own.end(), grid.start[cell + 1] - grid.start[cell], along >= slab.first && along < slab.end);
  }
}

std::vector<std::uint32_t> places_of(const Sites& sites, Structure structure) {
  std::vector<std::uint32_t> places;
  for (std::size_t i = 0; i < sites.structure.size(); ++i)
    if (sites.structure[i] == structure) places.push_back(static_cast<std::uint32_t>(i));
  return places;
}

void for_neighbours(const Sites& sites, const std::vector<std::uint32_t>& places,
                    const std::function<void(std::size_t k, const Neighbours& found,
                                             NeighbourSearch& search)>& use) {
  for_ranges(places.size(), places_at_once, sites.threads, [&](std::size_t first, std::size_t end) {
    const auto search = sites.search();
    Neighbours found;
    for (std::size_t k = first; k < end; ++k) {
      search->about(places[k], found);
      use(k, found, *search);
    }
  });
}

void label_structures(Sites& sites, bool by_search) {
  by_search ? label_by_search(sites) : label_by_kernel(sites);
}

OtherStructures find_other_structures(Sites& sites, bool label_bcc, bool label_ico) {
  std::vector<std::uint32_t> places;
  for (std::size_t i = 0; i < sites.site.size(); ++i)
    if (sites.site[i] == Site::bulk_defect) places.push_back(static_cast<std::uint32_t>(i));
  std::vector<Structure> found(places.size());
  for_neighbours(sites, places, [&](std::size_t k, const Neighbours& neighbours, NeighbourSearch&) {
    found[k] = bcc_or_ico(neighbours);
  });
  OtherStructures count;
  for (std::size_t k = 0; k < places.size(); ++k) {
    count.bcc += found[k] == Structure::bcc && sites.is_own(places[k]);
    count.ico += found[k] == Structure::ico && sites.is_own(places[k]);
    if (!(found[k] == Structure::bcc && label_bcc) && !(found[k] == Structure::ico && label_ico))
      continue;
    sites.structure[places[k]] = found[k];
    sites.site[places[k]] = Site::crystal;
  }
  return count;
}

}  // namespace mdana::defects
