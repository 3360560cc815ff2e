// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "readers/block.hpp"
#include "readers/columns.hpp"

namespace mdana {

/// Where the atoms' masses come from: the dump's column `mass`, a table by type, or 1 for all.
class Masses {
 public:
  static Masses from_column(std::string source);
  static Masses by_type(std::map<std::int64_t, double> masses, std::string source);
  static Masses uniform(std::string source);

  const ColumnSet& columns() const { return columns_; }
  const std::string& source() const { return source_; }  ///< in words, for the output

  /// Mass of each atom of the block. Throws InputError at a type without mass and at a mass that
  /// is not positive and finite.
  void fill(const AtomBlock& block, std::vector<double>& mass) const;

 private:
  Masses(ColumnSet columns, std::string source)
      : columns_(std::move(columns)), source_(std::move(source)) {}
  ColumnSet columns_;
  std::string source_;
  std::map<std::int64_t, double> by_type_;
};

/// "1=39.95,2=107.87": mass by atom type. Throws InputError.
std::map<std::int64_t, double> parse_masses(const std::string& text);

}  // namespace mdana
