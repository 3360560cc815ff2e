// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/csv.hpp"

#include <cmath>

#include <fmt/format.h>

namespace mdana {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

std::string cell(const ColumnSpec& spec, double value) {
  if (!spec.labels.empty()) return quoted(spec.labels.at(static_cast<std::size_t>(value)));
  if (std::isnan(value)) return {};
  if (value == std::floor(value) && std::abs(value) < 0x1p53) return fmt::format("{:.0f}", value);
  return fmt::format("{}", value);
}

}  // namespace

std::string to_csv(const Table& table) {
  std::string text;
  const auto& columns = table.columns();
  for (std::size_t k = 0; k < columns.size(); ++k)
    text += (k ? "," : "") + quoted(columns[k].name);
  text += '\n';
  for (std::size_t i = 0; i < table.rows(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k)
      text += (k ? "," : "") + cell(columns[k], table.column(k)[i]);
    text += '\n';
  }
  return text;
}

}  // namespace mdana
