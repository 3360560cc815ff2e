// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mdana {

/// A table that is read: a line of names, then one line a row; # begins a comment, empty lines count for
/// nothing. Views of the text.
struct CsvText {
  struct Row {
    std::string place;                    ///< "runs.csv:7"
    std::vector<std::string_view> cells;  ///< as many as names, without blanks about them
  };
  std::string names_place;
  std::vector<std::string_view> names;
  std::vector<Row> rows;

  bool has(std::string_view name) const;
  /// A row's text of that column; empty if there is no such column.
  std::string_view cell(const Row& row, std::string_view name) const;
};

/// `place` is the name of the table in messages. Throws InputError if it is empty, has no rows, a name
/// stands twice, or a row has another number of cells.
CsvText read_csv(std::string_view text, const std::string& place);

/// The number that a cell holds, NaN and infinities included. Throws InputError.
double csv_number(std::string_view cell, std::string_view name, const std::string& place);

}  // namespace mdana
