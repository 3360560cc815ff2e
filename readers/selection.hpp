// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "readers/block.hpp"
#include "readers/columns.hpp"

namespace mdana {

/// Which atoms are looked at: those whose whole number in one column is in one of some ranges.
class Selection {
 public:
  /// "type:1-2", "id:1-5000,7001-12000", "mol:3". Throws InputError.
  explicit Selection(const std::string& text);

  const std::string& column() const { return column_; }
  bool holds(std::int64_t value) const;
  const std::string& text() const { return text_; }

  /// Takes the other atoms out of the block; the order stays.
  void apply(AtomBlock& block) const;

 private:
  struct Range {
    std::int64_t first, last;  ///< inclusive
  };

  std::string text_;
  std::string column_;
  std::vector<Range> ranges_;
};

}  // namespace mdana
