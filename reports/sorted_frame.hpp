// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "readers/block.hpp"

namespace mdana {

/// A whole frame in memory, to be given in another order of its atoms.
class SortedFrame {
 public:
  /// The column of whole numbers to sort by (empty: the order stays), and all columns that are given.
  SortedFrame(std::string key, std::vector<std::string> columns);

  void add(AtomBlock block);

  /// Calls `use` for blocks of the sorted atoms; those of equal value stay in their order.
  void give(const std::function<void(const AtomBlock&)>& use);

 private:
  struct Place {
    std::size_t block, atom;
  };
  void sort();
  void fill(AtomBlock& sorted, std::size_t first) const;

  std::string key_;
  std::vector<std::string> columns_;
  std::vector<AtomBlock> blocks_;
  std::vector<Place> order_;
};

}  // namespace mdana
