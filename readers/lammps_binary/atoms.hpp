// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "readers/block.hpp"
#include "readers/columns.hpp"
#include "readers/frame.hpp"
#include "readers/lammps_binary/header.hpp"
#include "readers/positions.hpp"

namespace mdana::lammps_binary {

/// Which numbers of an atom become which columns of a block.
class AtomLayout {
 public:
  AtomLayout() = default;

  /// Throws InputError if the frame lacks a wanted column.
  AtomLayout(const Header& header, const ColumnSet& wanted);

  std::size_t bytes_of_atom() const { return columns_ * sizeof(double); }

  /// Copies the wanted columns of the chunk's atoms. Throws InputError naming frame, atom and
  /// column at a number that must be whole and is not.
  void convert(const Chunk& chunk, AtomBlock& block) const;

 private:
  struct Slot {
    std::size_t file_column;
    std::string name;
    bool integer;
  };
  void add(const FrameHeader& header, const std::string& name);
  void copy(const Chunk& chunk, const Slot& slot, std::size_t first, std::size_t last,
            AtomBlock& block) const;

  std::vector<Slot> slots_;
  std::size_t columns_ = 0;  ///< in the file
  bool swapped_ = false;
  bool positions_wanted_ = false;
  PositionSource positions_;
  Box box_;
  std::string place_;
};

}  // namespace mdana::lammps_binary
