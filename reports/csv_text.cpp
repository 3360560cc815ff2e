// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/csv_text.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "readers/column_names.hpp"
#include "readers/input_error.hpp"
#include "readers/shown.hpp"

namespace mdana {
namespace {

constexpr std::size_t most_rows = std::size_t{1} << 21;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t comma = std::min(line.find(',', from), line.size());
    cells.push_back(trimmed(line.substr(from, comma - from)));
    from = comma + 1;
  }
  return cells;
}

/// A line without its comment; `first` may begin with the mark of UTF-8.
std::string_view content_of(std::string_view line, bool first) {
  if (first && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
  return trimmed(line.substr(0, line.find('#')));
}

void take_names(CsvText& table, std::string_view line, std::string place) {
  table.names_place = std::move(place);
  const std::vector<std::string_view> names = cells_of(line);
  const std::string wrong = wrong_names(std::vector<std::string>(names.begin(), names.end()));
  if (!wrong.empty()) throw InputError(fmt::format("{}: {}", table.names_place, wrong));
  table.names = names;
}

void take_row(CsvText& table, std::string_view line, std::string place) {
  if (table.rows.size() == most_rows)
    throw InputError(fmt::format("{}: more than {} rows", place, most_rows));
  table.rows.push_back({std::move(place), cells_of(line)});
  const CsvText::Row& row = table.rows.back();
  if (row.cells.size() != table.names.size())
    throw InputError(fmt::format("{}: {} cells (the line of names has {})", row.place, row.cells.size(),
                                 table.names.size()));
}

}  // namespace

bool CsvText::has(std::string_view name) const { return std::ranges::find(names, name) != names.end(); }

std::string_view CsvText::cell(const Row& row, std::string_view name) const {
  const auto at = std::ranges::find(names, name);
  return at == names.end() ? std::string_view() : row.cells[static_cast<std::size_t>(at - names.begin())];
}

CsvText read_csv(std::string_view text, const std::string& place) {
  CsvText table;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view content = content_of(text.substr(0, end), line == 1);
    if (!content.empty())
      (table.names.empty() ? take_names : take_row)(table, content, fmt::format("{}:{}", place, line));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (table.names.empty())
    throw InputError(place + ": empty: a line with the names of the columns is expected");
  if (table.rows.empty()) throw InputError(place + ": no rows below the line with the names of the columns");
  return table;
}

double csv_number(std::string_view cell, std::string_view name, const std::string& place) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size())
    throw InputError(fmt::format("{}: {} is '{}': a number is expected", place, name, shown(cell)));
  return value;
}

}  // namespace mdana
