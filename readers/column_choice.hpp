// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "readers/block.hpp"
#include "readers/columns.hpp"
#include "readers/frame.hpp"
#include "readers/positions.hpp"

namespace mdana {

/// Which columns of a frame are to be read, and the positions that follow from them.
class ColumnChoice {
 public:
  struct Column {
    std::size_t in_file;  ///< 0, 1, ... among the frame's columns
    std::string name;
    ColumnKind kind;
  };

  ColumnChoice() = default;

  /// Throws InputError if the frame lacks a wanted column.
  ColumnChoice(const FrameHeader& frame, const ColumnSet& wanted);

  const std::vector<Column>& columns() const { return columns_; }  ///< in the frame's order

  /// Makes x, y, z of a block that has the columns, if they are wanted.
  void finish(AtomBlock& block) const;

 private:
  void add(const FrameHeader& frame, const std::string& name);
  void add_positions(const FrameHeader& frame);

  std::vector<Column> columns_;
  std::optional<PositionSource> positions_;  ///< of wanted positions
  Box box_;
};

}  // namespace mdana
