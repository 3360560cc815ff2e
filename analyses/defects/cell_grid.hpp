// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "analyses/frame_atoms.hpp"

namespace mdana::defects {

/// Neighbours are looked for up to this distance, in spacings: beyond the first shell of crystals,
/// up to the second one of fcc (sqrt 2); also the edge of a cell.
inline constexpr double reach = 1.45;
/// Between the first shell of fcc and hcp and the second: (1 + sqrt 2)/2 of the mean distance to the
/// 12 nearest (Stukowski 2012).
inline constexpr double between_shells = 1.2071067811865475;
/// Positions are whole numbers of this part of a spacing; differences of neighbours are then exact
/// floats of 24 bits.
inline constexpr double units_a_spacing = 0x1p22;

/// Where the cubic cells of a frame are, the same for all its slabs.
struct CellSpace {
  /// Of atoms in this box; `of_spacing` [length]. Throws InputError if they are spread so far that cells
  /// cannot be numbered.
  CellSpace(const Eigen::AlignedBox3d& box, double of_spacing);

  std::uint64_t cell(double at, std::size_t axis) const;  ///< from 0, along an axis
  std::int32_t position(double at, std::size_t axis) const;

  double spacing;
  Eigen::Vector3d origin;
  std::array<std::uint64_t, 3> count;  ///< along the axes

 private:
  double scale_, cells_;  ///< spacings, cells a length
};

/// Atoms sorted by the cubic cell that holds them, those of a cell in their order in the frame. Only
/// occupied cells are kept. 16 bytes an atom and 12 a cell.
struct CellGrid {
  CellGrid(const FrameAtoms& atoms, const CellSpace& space, std::size_t threads = 1);
  /// Of all atoms of a frame. Throws InputError at positions that are not finite, or as CellSpace.
  CellGrid(const FrameAtoms& atoms, double of_spacing);

  static constexpr std::size_t padding = 32;  ///< readable atoms behind the last

  std::size_t cells() const { return key.size(); }
  std::size_t cell_of(std::size_t sorted) const;  ///< of an atom
  /// Cell that a key beyond all others, or the first one not before it, would be.
  std::size_t at_or_after(std::uint64_t wanted) const;

  double spacing;
  std::vector<std::int32_t> x, y, z;  ///< modulo 2^32, of the sorted atoms
  std::vector<std::uint32_t> atom;    ///< their index among the atoms of the slab
  std::vector<std::uint64_t> key;     ///< z, y, x of each cell from 1, 21 bits each; ascending
  std::vector<std::uint32_t> start;   ///< first atom of each cell, and the end
};

/// Key of the neighbouring cell.
constexpr std::uint64_t key_beside(std::uint64_t key, int dx, int dy, int dz) {
  return key + static_cast<std::uint64_t>(static_cast<std::int64_t>(dx) +
                                          static_cast<std::int64_t>(dy) * (1 << 21) +
                                          static_cast<std::int64_t>(dz) * (std::int64_t{1} << 42));
}

/// Number of a cell along an axis, from 0.
std::uint64_t cell_along(std::uint64_t key, std::size_t axis);

/// Box of the atoms. Throws InputError if a position is not finite, naming the id or the index of the atom;
/// that of the first of them is `first`.
Eigen::AlignedBox3d box_of(const FrameAtoms& atoms, std::size_t first = 0);

/// The middle of a cell along x, y, z, as positions are told.
std::array<std::int32_t, 3> middle_of(std::uint64_t key);

}  // namespace mdana::defects
