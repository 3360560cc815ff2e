// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/table.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

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
  std::unordered_map<std::string_view, std::size_t> known;
  for (const std::string& word : words) {
    const auto [at, first] = known.try_emplace(word, labels.size());
    if (first) labels.push_back(word);
    places.push_back(static_cast<double>(at->second));
  }
  add_column({std::move(name), dimension::none, std::move(labels)}, std::move(places));
}

}  // namespace mdana
