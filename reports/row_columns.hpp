// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analyses/table.hpp"

namespace mdana {

/// Appends to a table what `text` tells of each row of a report.
template <class Rows, class Text>
void add_words(Table& table, std::string name, const Rows& rows, Text&& text) {
  std::vector<std::string> words;
  for (const auto& row : rows) words.emplace_back(text(row));
  table.add_words(std::move(name), words);
}

/// The same of a number.
template <class Rows, class Number>
void add_numbers(Table& table, std::string name, const Rows& rows, Number&& number, Dimension dimension = dimension::none) {
  std::vector<double> column;
  for (const auto& row : rows) column.push_back(static_cast<double>(number(row)));
  table.add_column({std::move(name), dimension}, std::move(column));
}

}  // namespace mdana
