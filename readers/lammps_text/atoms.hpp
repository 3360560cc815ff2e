// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "readers/block.hpp"
#include "readers/columns.hpp"
#include "readers/format.hpp"
#include "readers/frame.hpp"
#include "readers/lammps_text/line_kernel.hpp"
#include "readers/positions.hpp"

namespace mdana::lammps_text {

/// Which numbers of an atom line become which columns of a block.
class AtomLayout {
 public:
  AtomLayout() = default;

  /// Throws InputError if the frame lacks a wanted column.
  AtomLayout(const FrameHeader& header, const ColumnSet& wanted);

  /// Converts the wanted columns of the chunk's lines, correctly rounded. Throws InputError naming
  /// `path`, line and column at a token that is no number, and at a line whose number of columns is
  /// not that of the header.
  void convert(const Chunk& chunk, const std::string& path, AtomBlock& block,
               const LineKernel& kernel = best_line_kernel()) const;

 private:
  class Conversion;
  struct Slot {
    std::size_t file_column;
    std::string name;
    bool integer;
  };
  void add(const FrameHeader& header, const std::string& name);

  std::vector<Slot> slots_;  ///< in file order
  std::size_t columns_ = 0;  ///< in the file
  bool positions_wanted_ = false;
  PositionSource positions_;
  Box box_;
};

/// How the values of a column are printed, from the whole chunk. A column of whole numbers only
/// counts as exact (no digits).
PrintedPrecision printed_precision(const Chunk& chunk, std::size_t file_column);

}  // namespace mdana::lammps_text
