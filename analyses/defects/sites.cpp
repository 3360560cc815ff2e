// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analyses/defects/labels.hpp"
#include "readers/input_error.hpp"

namespace mdana::defects {
namespace {

/// Unit vectors to the neighbours, the farther ones less, add up to this on one side of an atom: 2.6 and
/// 2.9 on {111} and {100} surfaces, 1 beside a vacancy.
constexpr float one_sided = 1.6f;
constexpr float whole_weight = 1.1f;       ///< [spacings], of neighbours nearer than this; 0 at `reach`
constexpr std::size_t few_neighbours = 6;  ///< of an atom on an edge or loose, whatever their sides

/// What the neighbours tell of an atom.
struct Surroundings {
  bool contact = false, incomplete = false, exposed = false;
};

[[noreturn]] void same_place(const Sites& sites, std::uint32_t a, std::uint32_t b) {
  const auto [first, second] = std::minmax({sites.number(a), sites.number(b)});
  throw InputError(sites.slab.atoms->id.empty()
                       ? fmt::format("atoms {} and {} (by order) are at the same place", first + 1, second + 1)
                       : fmt::format("the atoms of ids {} and {} are at the same place", first, second));
}

Surroundings surroundings(const Sites& sites, std::uint32_t place, const Neighbours& all) {
  Surroundings about;
  std::size_t count = 0;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const Neighbour& n : all) {
    if (n.d2 == 0) same_place(sites, place, n.place);
    if (n.d2 < touching * touching && sites.body[n.place] != sites.body[place])
      about.contact = true;
    count += n.d2 < between_shells * between_shells;
    const float distance = std::sqrt(n.d2), end = static_cast<float>(reach);
    sum += std::min(1.0f, (end - distance) / (end - whole_weight)) / distance * n.offset;
  }
  about.incomplete = count < 12;
  about.exposed = about.incomplete && (sum.norm() >= one_sided || count <= few_neighbours);
  return about;
}

/// An incomplete atom with a neighbour at the surface.
bool beside_surface(const Sites& sites, const Neighbours& all) {
  for (const Neighbour& n : all)
    if (n.d2 < between_shells * between_shells && sites.site[n.place] == Site::surface) return true;
  return false;
}

/// Incomplete atoms beside the surface belong to it.
void spread_surface(Sites& sites, const std::vector<std::uint32_t>& undecided) {
  std::vector<char> beside(undecided.size());
  for_neighbours(sites, undecided, [&](std::size_t k, const Neighbours& found, NeighbourSearch&) {
    beside[k] = beside_surface(sites, found);
  });
  for (std::size_t k = 0; k < undecided.size(); ++k)
    if (beside[k]) sites.site[undecided[k]] = Site::surface;
}

}  // namespace

std::size_t find_sites(Sites& sites) {
  sites.site.assign(sites.structure.size(), Site::crystal);
  const auto places = places_of(sites, Structure::other);
  std::vector<std::uint32_t> undecided;
  std::vector<Surroundings> about(places.size());
  std::vector<Labelled> labelled(places.size());
  for_neighbours(sites, places, [&](std::size_t k, const Neighbours& found, NeighbourSearch& search) {
    about[k] = surroundings(sites, places[k], found);
    labelled[k] = repaired(sites, found, search);
  });
  std::size_t repaired = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (labelled[k].structure != Structure::other) {
      repaired += sites.is_own(places[k]);
      sites.structure[places[k]] = labelled[k].structure;
      if (!sites.margin.empty()) sites.margin[places[k]] = labelled[k].margin;
      continue;
    }
    Site& site = sites.site[places[k]];
    site = about[k].contact ? Site::contact
                            : about[k].exposed ? Site::surface : Site::bulk_defect;
    if (site == Site::bulk_defect && about[k].incomplete) undecided.push_back(places[k]);
  }
  spread_surface(sites, undecided);
  return repaired;
}

}  // namespace mdana::defects
