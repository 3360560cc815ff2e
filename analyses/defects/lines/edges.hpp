// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "analyses/defects/lines/frames.hpp"
#include "analyses/defects/zone.hpp"

namespace mdana::defects {

/// How sure the ideal vector of an edge is.
enum class EdgeKind : std::uint8_t {
  sure,     ///< a crystalline atom has it, or all ways over a third atom agree
  guessed,  ///< atoms disagree, or none has it: any lattice vector may be taken
  foreign   ///< between two lattices that are not known against each other: there is none
};

/// The edges of tetrahedra with their ideal vectors, from the lower to the higher atom.
struct Edges {
  std::vector<std::uint32_t> first;  ///< of each atom, and the end
  std::vector<std::uint32_t> high;   ///< ascending for each lower atom
  std::vector<Ideal> vector;
  std::vector<EdgeKind> kind;

  std::size_t size() const { return high.size(); }
  std::uint32_t index(std::uint32_t low, std::uint32_t high) const;
  /// From one atom of an edge to the other.
  Ideal along(std::uint32_t from, std::uint32_t to) const;
};

/// Without vectors.
Edges edges_of(std::size_t atoms, std::span<const Tetrahedron> cells);

/// Atoms without a grain get it, with map and turn, from the nearest of their body along an edge, again and again.
void spread_grains(ZoneCrystal& crystal, const Zone& zone, const Edges& edges);

void find_vectors(Edges& edges, const Zone& zone, const ZoneCrystal& crystal, std::size_t threads);

/// Takes out the tetrahedra with foreign edges; their facets, corners ascending, in order.
std::vector<Corners> remove_foreign(std::vector<Tetrahedron>& cells, const Edges& edges);

/// The circulation of the ideal vectors about a facet: less the Burgers vector of what pierces it.
Ideal circulation(const Edges& edges, const Corners& facet);

/// Changes guessed vectors as long as that makes the sum of the squared Burgers vectors of all facets less.
void tighten(Edges& edges, std::span<const Tetrahedron> cells, const Zone& zone);

}  // namespace mdana::defects
