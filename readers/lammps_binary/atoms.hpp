// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "readers/column_choice.hpp"
#include "readers/frame_layout.hpp"
#include "readers/lammps_binary/header.hpp"

namespace mdana::lammps_binary {

/// Which numbers of an atom become which columns of a block.
class AtomLayout final : public FrameLayout {
 public:
  /// `path` is that of the file. Throws InputError if the frame lacks a wanted column.
  AtomLayout(const Header& header, const ColumnSet& wanted, std::string path);

  /// Throws InputError naming frame, atom and column at a number that must be whole and is not.
  void convert(const Chunk& chunk, AtomBlock& block) const override;

  AtomPlace first_place(const Chunk& chunk) const override {
    return {path_, 0, chunk.first_line};
  }

 private:
  std::size_t bytes_of_atom() const { return columns_in_file_ * sizeof(double); }
  void copy(const Chunk& chunk, const ColumnChoice::Column& column, std::size_t first,
            std::size_t last, AtomBlock& block) const;

  ColumnChoice choice_;
  std::size_t columns_in_file_;
  bool swapped_;
  std::string place_;
  std::string path_;
};

}  // namespace mdana::lammps_binary
