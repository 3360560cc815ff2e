// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "readers/dimension.hpp"

namespace mdana {

/// Name and dimension of a table's column.
struct ColumnSpec {
  std::string name;
  Dimension dimension;
  std::vector<std::string> labels = {};  ///< if not empty, the value is an index into them
};

/// Rows of numbers under named columns, one row a frame. Missing values are NaN.
class Table {
 public:
  Table() = default;
  explicit Table(std::vector<ColumnSpec> columns);

  std::size_t rows() const { return rows_; }
  const std::vector<ColumnSpec>& columns() const { return specs_; }

  /// Throws std::out_of_range if there is no such column.
  std::span<const double> column(std::string_view name) const;
  std::span<const double> column(std::size_t index) const { return values_[index]; }
  bool has(std::string_view name) const;

  /// Appends a row; as many values as columns.
  void add_row(std::span<const double> values);
  void drop_last_row();  ///< of a table that has one
  /// Appends a column; as many values as rows (any number in an empty table).
  void add_column(ColumnSpec spec, std::vector<double> values);
  /// The same of words: places in the list of those that there are, in the order in which they come first.
  void add_words(std::string name, std::span<const std::string> words);

 private:
  std::vector<ColumnSpec> specs_;
  std::vector<std::vector<double>> values_;
  std::size_t rows_ = 0;
};

}  // namespace mdana
