// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "readers/amber_netcdf/convention.hpp"
#include "readers/column_choice.hpp"
#include "readers/frame_layout.hpp"

namespace mdana::amber_netcdf {

/// Which numbers of a chunk become which columns of a block. A chunk holds the wanted variables one
/// after another, each as the library gives it: all numbers of an atom together.
class AtomLayout final : public FrameLayout {
 public:
  /// Throws InputError if the frame lacks a wanted column.
  AtomLayout(const FrameHeader& header, std::shared_ptr<const Content> content,
             const ColumnSet& wanted);

  /// A variable that is to be read, and where its numbers begin in a chunk of so many atoms.
  struct Part {
    const AtomVariable* variable;
    std::size_t offset;
  };
  std::vector<Part> parts(std::size_t atoms) const;
  std::size_t bytes(std::size_t atoms) const;  ///< of a chunk

  /// Throws InputError naming frame, atom and column at a number that was never written, or that
  /// must be whole and is not.
  void convert(const Chunk& chunk, AtomBlock& block) const override;

 private:
  void copy(const Chunk& chunk, const ColumnChoice::Column& column, const std::vector<Part>& parts,
            AtomBlock& block) const;
  [[noreturn]] void fail(const Chunk& chunk, std::size_t atom, const std::string& column,
                         const std::string& what) const;

  std::shared_ptr<const Content> content_;
  ColumnChoice choice_;
  std::vector<const AtomVariable*> variables_;  ///< that the choice needs, in the file's order
  std::string place_;
};

}  // namespace mdana::amber_netcdf
