// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analyses/defects/labels.hpp"

namespace mdana::defects {

/// A tetrahedron between atoms is filled if its circumradius is less [spacings]: the holes of fcc and
/// hcp have 0.61 and 0.71, a vacancy 1, the outside more.
inline constexpr double filled_below = 0.9;
/// The same with narrower and wider limits that still lie between those: what changes is doubtful.
inline constexpr std::array<double, 3> filled_limits{filled_below, 0.8, 0.97};
inline constexpr double widest_limit = 0.97;

/// Atoms of which some, the seeds, are of interest, and all others that decide how the seeds are
/// connected: all within 2 widest_limit of a seed. A tetrahedron with a seed and a circumradius below
/// that is Delaunay among these atoms if and only if it is among all: its circumsphere holds
/// no others.
struct Zone {
  std::vector<std::uint32_t> atom;   ///< index in the frame, ascending
  std::vector<Eigen::Vector3d> at;   ///< [spacings], from the origin
  std::vector<std::int64_t> number;  ///< of the atom wherever it is: its id, else its index
  std::vector<BodyIndex> body;
  std::vector<char> seed;            ///< 0: none; else what the caller calls it
  Eigen::Vector3d origin;            ///< [length]
  double spacing = 1;                ///< [length]

  std::size_t size() const { return atom.size(); }
  Eigen::Vector3d position(std::size_t i) const { return origin + spacing * at[i]; }  ///< [length]
};

/// A zone as it is collected from slab after slab, each of which knows its own atoms.
class ZoneParts {
 public:
  /// What is about the seeds, by place, among the atoms of one body (0: of all); its places.
  std::vector<std::uint32_t> add(const Sites& sites, const std::vector<char>& seeds, BodyIndex body);
  /// All of them. Zones of one frame have one origin [length], so that sums over their atoms are the same bits.
  Zone zone(const Eigen::Vector3d& origin, double spacing) &&;

 private:
  struct Atom {
    Eigen::Vector3d at;  ///< [length]
    std::int64_t number;
    std::uint32_t index;
    BodyIndex body;
    char seed;
  };
  std::vector<Atom> atoms_;
};

using Corners = std::array<std::uint32_t, 3>;      ///< atoms of the zone
using Tetrahedron = std::array<std::uint32_t, 4>;  ///< likewise

/// The corners of the sides of a tetrahedron with a positive volume, against the clock seen from outside; the
/// k-th is opposite to corner k.
inline constexpr std::size_t outward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

inline Corners side_of(const Tetrahedron& t, std::size_t side) {
  return {t[outward[side][0]], t[outward[side][1]], t[outward[side][2]]};
}

inline Corners ascending(Corners facet) {
  std::sort(facet.begin(), facet.end());
  return facet;
}

/// The filled tetrahedra with a seed, by one of the limits.
struct ZoneCells {
  /// Corners ascending, but the last two in the order that makes the volume positive; in order; if wanted.
  std::vector<Tetrahedron> cells;
  /// Sides with a seed that no two of them share, against the clock seen from outside, the lowest corner
  /// first; in order.
  std::vector<Corners> open;
};

/// Triangulates in slabs of at most some 30000 atoms, which threads share; the result does not depend on slabs
/// or threads. Points are moved by up to 1e-9 spacings, by their number, so that no four neighbours of a
/// perfect lattice lie on a sphere by chance. zone_cells.cpp, the only source with CGAL's triangulation.
/// The limits are at most widest_limit; what is filled by each of them.
std::vector<ZoneCells> triangulate(const Zone& zone, bool cells, std::size_t threads, std::span<const double> limits);
ZoneCells triangulate(const Zone& zone, bool cells, std::size_t threads);  ///< by filled_below

}  // namespace mdana::defects
