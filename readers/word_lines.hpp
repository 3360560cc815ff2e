// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "readers/column_choice.hpp"
#include "readers/frame_layout.hpp"
#include "readers/line_kernel.hpp"

namespace mdana {

/// Atoms of one line each: words with blanks between them, a word a column of the frame.
class WordLines final : public FrameLayout {
 public:
  /// `path` is that of the file, for messages. Throws InputError if the frame lacks a wanted column.
  WordLines(const FrameHeader& header, const ColumnSet& wanted, std::string path,
             const LineKernel& kernel = best_line_kernel());

  /// Numbers are correctly rounded. Throws InputError naming line and column at a word that is no
  /// number, and at a line whose number of columns is not that of the header.
  void convert(const Chunk& chunk, AtomBlock& block) const override;

  /// Tells every word and line that is wrong; the atoms of such lines are unusable.
  void check(const Chunk& chunk, AtomBlock& block, BlockFaults& faults) const override;

  AtomPlace first_place(const Chunk& chunk) const override { return {path_, chunk.first_line, 0}; }

  /// From the whole chunk. A column of whole numbers only counts as exact (no digits).
  PrintedPrecision printed_precision(const Chunk& chunk, std::string_view column) const override;

 private:
  class Conversion;

  ColumnChoice choice_;
  std::vector<std::string> names_;  ///< of all columns in the file
  std::string path_;
  const LineKernel& kernel_;
};

}  // namespace mdana
