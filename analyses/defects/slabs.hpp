// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "analyses/defects/cell_grid.hpp"
#include "analyses/frame_store.hpp"

namespace mdana::defects {

/// The atoms between two planes of cells across an axis, and those that they depend on.
struct Slab {
  std::shared_ptr<const FrameAtoms> atoms;  ///< in the order of the frame
  std::vector<std::uint32_t> index;         ///< of each in the frame; empty: the slab is the frame
  std::size_t axis = 0;
  std::uint64_t first = 0, end = std::numeric_limits<std::uint64_t>::max();  ///< cells of its own along it

  bool whole() const { return index.empty(); }
};

/// A frame cut into slabs across its longest side: one if its atoms are in memory, else as few as hold no
/// more atoms than are allowed there, if slabs of one layer of cells and the halo do not hold more. The
/// atoms are then in a second temporary file.
class Slabs {
 public:
  Slabs(const FrameStore& frame, const CellSpace& space);
  ~Slabs();

  std::size_t count() const;
  Slab slab(std::size_t k) const;

 private:
  struct Layers;
  const FrameStore& frame_;
  std::unique_ptr<Layers> layers_;  ///< null if the atoms are in memory
};

}  // namespace mdana::defects
