// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "analyses/defects.hpp"
#include "analyses/defects/crystal.hpp"
#include "analyses/defects/neighbours.hpp"

namespace mdana::defects {

/// Atoms of the two bodies, or of one and nothing, up to this distance apart touch [spacings]: between
/// the first shell and the second.
inline constexpr double touching = 1.33;

/// The sorted atoms of a frame with what is known of each.
struct Sites {
  const CellGrid& grid;
  const SearchMaker& search;
  std::size_t threads;
  std::vector<BodyIndex> body;
  std::vector<Structure> structure;
  std::vector<float> margin;  ///< empty if it is not asked for
  std::vector<Site> site;
};

/// Places of the atoms of a structure.
std::vector<std::uint32_t> places_of(const Sites& sites, Structure structure);

/// Calls use(k, neighbours, search) for each of the places k = 0, 1, ... in several threads; the search
/// may be used for more.
void for_neighbours(
    const Sites& sites, const std::vector<std::uint32_t>& places,
    const std::function<void(std::size_t k, const Neighbours& found, NeighbourSearch& search)>& use);

/// Gives structure (and margin) to the atoms, by the kernel or, if `by_search`, from their neighbours.
void label_structures(Sites& sites, bool by_search);

/// What an atom of no structure is in the deformed lattice of a fcc neighbour; other if it does not stand
/// in one. `found` are its neighbours.
Labelled repaired(const Sites& sites, const Neighbours& found, NeighbourSearch& search);

/// Repairs atoms of no structure and tells where the others are. Returns how many were repaired. Throws
/// InputError, naming the ids if they are known, if two atoms are at the same place.
std::size_t find_sites(Sites& sites, const FrameAtoms& atoms);

/// Of the bulk defects, how many are bcc and ico; they are labelled so if that is asked for.
struct OtherStructures {
  std::size_t bcc = 0, ico = 0;
};
OtherStructures find_other_structures(Sites& sites, bool label_bcc, bool label_ico);

}  // namespace mdana::defects
