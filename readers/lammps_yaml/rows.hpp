// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "readers/columns.hpp"
#include "readers/frame_layout.hpp"

namespace mdana::lammps_yaml {

/// Rows `- [ 1, 2, 0.5, ]`: read as lines of words, with blanks in place of what is between them.
class Rows final : public FrameLayout {
 public:
  Rows(const FrameHeader& header, const ColumnSet& wanted, std::string path);

  /// Besides what lines of words throw: InputError naming the line of what is no such row, or one
  /// of another number of values than the header has columns.
  void convert(const Chunk& chunk, AtomBlock& block) const override;

  PrintedPrecision printed_precision(const Chunk& chunk, std::string_view column) const override;

 private:
  std::string copy_row(std::string_view row, char* out) const;
  Chunk word_lines(const Chunk& chunk) const;

  std::size_t columns_;
  std::string path_;
  std::shared_ptr<const FrameLayout> words_;
};

}  // namespace mdana::lammps_yaml
