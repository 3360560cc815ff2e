// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "readers/block.hpp"
#include "readers/columns.hpp"
#include "readers/frame.hpp"
#include "readers/positions.hpp"
#include "readers/selection.hpp"

namespace mdana {

/// Which columns and atoms of a frame are to be read, and the positions that follow from them.
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

  const Selection* selection() const { return selection_ ? &*selection_ : nullptr; }  ///< null: all

  /// Of a block that has the columns: takes the atoms out that are not selected, and makes x, y, z
  /// if they are wanted.
  void finish(AtomBlock& block) const;

 private:
  void add(const FrameHeader& frame, const std::string& name);
  void add_positions(const FrameHeader& frame);

  std::vector<Column> columns_;
  std::optional<Selection> selection_;
  std::optional<PositionSource> positions_;  ///< of wanted positions
  Box box_;
};

}  // namespace mdana
