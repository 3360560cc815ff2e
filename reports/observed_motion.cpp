// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "fits/followed_collision.hpp"
#include "readers/input_error.hpp"
#include "reports/observations.hpp"

namespace mdana {
namespace {

constexpr std::string_view parameters[] = {"R", "R1", "R2", "m", "m1", "m2", "rho", "E", "gamma", "nu", "spacing"};

std::string_view time_name(const CsvText& table) { return table.has("time") ? "time" : "t"; }

/// A number of a row; unknown if the cell is empty or there is no such column.
double number(const CsvText& table, const CsvText::Row& row, std::string_view name) {
  const std::string_view text = table.cell(row, name);
  return text.empty() ? Measured().value : csv_number(text, name, row.place);
}

Measured measured(const CsvText& table, const CsvText::Row& row, const std::string& name) {
  const Measured m{number(table, row, name), number(table, row, name + "_error")};
  if (std::isinf(m.value)) throw InputError(fmt::format("{}: {} is not finite", row.place, name));
  if (m.error <= 0) throw InputError(fmt::format("{}: {}_error is {:g}: a standard error is greater than 0", row.place, name, m.error));
  return m;
}

/// Of force tables only the force has an error: then none is known.
MotionSample sample_of(const CsvText& table, const CsvText::Row& row) {
  MotionSample sample{number(table, row, time_name(table)), measured(table, row, "delta"), measured(table, row, "v"),
                      measured(table, row, "F")};
  if (!std::isfinite(sample.time)) throw InputError(fmt::format("{}: {} is missing", row.place, time_name(table)));
  if (!(sample.delta.error > 0)) sample.velocity.error = sample.force.error = Measured().error;
  return sample;
}

void give_parameters(const CsvText& table, ObservedCollision& c) {
  for (const std::string_view name : parameters) {
    if (!table.has(name)) continue;
    const double value = number(table, table.rows.front(), name);
    for (const CsvText::Row& row : table.rows)
      if (number(table, row, name) != value)
        throw InputError(fmt::format("{}: {} is another than in the rows before", row.place, name));
    c.given.push_back({std::string(name), value});
  }
}

}  // namespace

bool is_motion(const CsvText& table) { return (table.has("time") || table.has("t")) && table.has("delta"); }

ObservedCollision observed_motion(const CsvText& table, const std::string& place) {
  std::vector<MotionSample> rows;
  for (const CsvText::Row& row : table.rows) rows.push_back(sample_of(table, row));
  ObservedCollision c = followed_collision(rows, place);
  give_parameters(table, c);
  return c;
}

}  // namespace mdana
