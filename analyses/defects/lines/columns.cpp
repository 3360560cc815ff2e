// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lines/columns.hpp"

#include <string>

namespace mdana::defects {
namespace {

constexpr Dimension per_area{0, -2, 0};
constexpr double shortest = 2;  ///< [spacings]

/// A value and its error.
std::span<double> put(std::span<double> row, const Value& value) {
  row[0] = value.value;
  row[1] = *value.error;
  return row.subspan(2);
}

}  // namespace

void add_line_columns(std::vector<ColumnSpec>& columns) {
  columns.push_back({"line_segments", dimension::none});
  columns.push_back({"line_length", dimension::length});
  columns.push_back({"line_length_error", dimension::length});
  for (const char* body : {"", "1", "2"})
    for (std::size_t f = 0; f < line_families; ++f)
      for (const char* part : {"_length", "_length_error"})
        columns.push_back({std::string(name(static_cast<LineFamily>(f))) + part + body, dimension::length});
  columns.push_back({"line_density1", per_area});
  columns.push_back({"line_density2", per_area});
  columns.push_back({"short_line_length", dimension::length});
  columns.push_back({"unresolved_length", dimension::length});
  columns.push_back({"unresolved_length_error", dimension::length});
  columns.push_back({"burgers_residual", dimension::none});
}

std::span<double> fill_lines(const DislocationLines& lines, const std::array<double, 2>& volume, double spacing,
                             std::span<double> row) {
  row[0] = static_cast<double>(lines.segments.size());
  row = put(row.subspan(1), lines.length(0));
  for (const BodyIndex body : {BodyIndex{0}, BodyIndex{1}, BodyIndex{2}})
    for (std::size_t f = 0; f < line_families; ++f) row = put(row, lines.length(body, static_cast<LineFamily>(f)));
  for (const std::size_t b : {0u, 1u})
    row[b] = volume[b] > 0 ? lines.length(static_cast<BodyIndex>(b + 1)).value / volume[b] : 0;
  row[2] = lines.length_below(shortest * spacing);
  row = put(row.subspan(3), lines.absorbed);
  row[0] = lines.residual;
  return row.subspan(1);
}

}  // namespace mdana::defects
