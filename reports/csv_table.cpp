// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/csv_table.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "readers/input_error.hpp"
#include "reports/csv_text.hpp"
#include "reports/whole_file.hpp"

namespace mdana {
namespace {

/// Nothing if the cell is no number; NaN if it is empty.
std::optional<double> number_of(std::string_view cell, std::string_view name, const std::string& place) {
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  try {
    return csv_number(cell, name, place);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void add_labels(Table& table, const CsvText& text, std::size_t k) {
  std::vector<std::string> words;
  for (const CsvText::Row& row : text.rows) words.emplace_back(row.cells[k]);
  table.add_words(std::string(text.names[k]), words);
}

void add_column(Table& table, const CsvText& text, std::size_t k) {
  std::vector<double> values;
  for (const CsvText::Row& row : text.rows) {
    const auto number = number_of(row.cells[k], text.names[k], row.place);
    if (!number) return add_labels(table, text, k);
    values.push_back(*number);
  }
  table.add_column({std::string(text.names[k]), dimension::none}, std::move(values));
}

}  // namespace

Table read_csv_table(const std::filesystem::path& file) {
  const WholeFile whole = read_whole(file);
  const CsvText text = read_csv(whole.text, file.string());
  Table table;
  for (std::size_t k = 0; k < text.names.size(); ++k) add_column(table, text, k);
  return table;
}

}  // namespace mdana
