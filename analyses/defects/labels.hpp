// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "analyses/defects.hpp"
#include "analyses/defects/crystal.hpp"
#include "analyses/defects/neighbours.hpp"
#include "analyses/defects/slabs.hpp"

namespace mdana::defects {

/// Atoms of the two bodies, or of one and nothing, up to this distance apart touch [spacings]: between
/// the first shell and the second.
inline constexpr double touching = 1.33;

/// The sorted atoms of a slab, or of the whole frame, with what is known of each. Only that of its own
/// atoms is sure; the others are those that it depends on.
struct Sites {
  Sites(const CellGrid& of_grid, const SearchMaker& maker, std::size_t with_threads, const Slab& of_slab,
        bool margins);

  /// The atom in the frame.
  std::uint32_t index(std::size_t place) const {
    return slab.whole() ? grid.atom[place] : slab.index[grid.atom[place]];
  }
  /// The id, or the index where there are none.
  std::int64_t number(std::size_t place) const {
    return slab.atoms->id.empty() ? index(place) : slab.atoms->id[grid.atom[place]];
  }
  Eigen::Vector3d position(std::size_t place) const {
    const std::uint32_t i = grid.atom[place];
    return {slab.atoms->x[i], slab.atoms->y[i], slab.atoms->z[i]};
  }
  bool is_own(std::size_t place) const { return own.empty() || own[place]; }

  const CellGrid& grid;
  const SearchMaker& search;
  std::size_t threads;
  const Slab& slab;
  std::vector<char> own;  ///< by place: of the slab itself; empty: all
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

/// Repairs atoms of no structure and tells where the others are. Returns how many of its own were repaired.
/// Throws InputError, naming the ids if they are known, if two atoms are at the same place.
std::size_t find_sites(Sites& sites);

/// Of its own bulk defects, how many are bcc and ico; they are labelled so if that is asked for.
struct OtherStructures {
  std::size_t bcc = 0, ico = 0;
};
OtherStructures find_other_structures(Sites& sites, bool label_bcc, bool label_ico);

}  // namespace mdana::defects
