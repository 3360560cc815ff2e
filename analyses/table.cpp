// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/table.hpp"

#include <algorithm>
#include <stdexcept>

namespace mdana {

Table::Table(std::vector<ColumnSpec> columns) : specs_(std::move(columns)), values_(specs_.size()) {}

std::span<const double> Table::column(std::string_view name) const {
  for (std::size_t i = 0; i < specs_.size(); ++i)
    if (specs_[i].name == name) return values_[i];
  throw std::out_of_range("no column " + std::string(name) + " in the table");
}

bool Table::has(std::string_view name) const {
  return std::any_of(specs_.begin(), specs_.end(), [&](const auto& s) { return s.name == name; });
}

void Table::add_row(std::span<const double> values) {
  if (values.size() != specs_.size()) throw std::logic_error("Table::add_row: wrong length");
  for (std::size_t i = 0; i < values.size(); ++i) values_[i].push_back(values[i]);
  ++rows_;
}

void Table::drop_last_row() {
  for (auto& column : values_) column.pop_back();
  --rows_;
}

void Table::add_column(ColumnSpec spec, std::vector<double> values) {
  if (!specs_.empty() && values.size() != rows_)
    throw std::logic_error("Table::add_column: wrong length");
  rows_ = values.size();
  specs_.push_back(std::move(spec));
  values_.push_back(std::move(values));
}

void Table::add_words(std::string name, std::span<const std::string> words) {
  std::vector<std::string> labels;
  std::vector<double> places;
  for (const std::string& word : words) {
    auto at = std::ranges::find(labels, word);
    if (at == labels.end()) at = labels.insert(at, word);
    places.push_back(static_cast<double>(at - labels.begin()));
  }
  add_column({std::move(name), dimension::none, std::move(labels)}, std::move(places));
}

}  // namespace mdana
