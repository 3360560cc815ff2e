// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "readers/thermo_log.hpp"

namespace mdana {
namespace {

/// Columns that start anew with each run, or tell how fast it goes.
bool counts_anew(std::string_view name) {
  constexpr std::string_view names[] = {"CPU", "T/CPU", "S/CPU", "CPULeft", "Elapsed", "Dt"};
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

double largest(const ThermoTable::Column& column) {
  double size = 0;
  for (const double value : column.values)
    if (std::isfinite(value)) size = std::max(size, std::abs(value));
  return size;
}

/// The first row of a run, in b, against the last of the run before. A run sets up the forces anew
/// and adds them in another order: to eight digits of the column, or the last one printed of
/// fractions, nothing may change.
bool agree(const ThermoTable::Column& a, const ThermoTable::Column& b) {
  const double last = a.values.back(), first = b.values.front();
  if (std::isnan(last) || std::isnan(first)) return std::isnan(last) && std::isnan(first);
  const double digit = std::min(a.last_digit, b.last_digit);
  const double tolerance = (digit < 1 ? digit : 0) + 1e-8 * largest(b);
  return last == first || std::abs(last - first) <= tolerance;
}

[[noreturn]] void fail(const ThermoLog& log, const ThermoSection& section,
                       const std::string& what) {
  throw InputError(fmt::format("{}:{}: {}", log.path, section.first_line, what));
}

void expect_same_names(const ThermoLog& log, const ThermoTable& joined,
                       const ThermoSection& section) {
  const auto& columns = section.table.columns;
  bool same = columns.size() == joined.columns.size();
  for (std::size_t k = 0; same && k < columns.size(); ++k)
    same = columns[k].name == joined.columns[k].name;
  if (!same) fail(log, section, "other columns than in the runs before; use each run by itself");
}

/// 1 if the section begins with the last row so far, else 0.
std::size_t repeated_rows(const ThermoLog& log, const ThermoTable& joined,
                          const ThermoSection& section) {
  const auto *before = joined.find("Step"), *after = section.table.find("Step");
  if (!before || !after) fail(log, section, "the runs cannot be joined without a column Step");
  if (joined.rows() == 0 || section.table.rows() == 0) return 0;
  const double last = before->values.back(), first = after->values.front();
  if (first < last)
    fail(log, section,
         fmt::format("the steps go back from {} to {}; use each run by itself", last, first));
  if (first > last) return 0;
  for (std::size_t k = 0; k < joined.columns.size(); ++k) {
    const auto &a = joined.columns[k], &b = section.table.columns[k];
    if (!counts_anew(a.name) && !agree(a, b))
      fail(log, section,
           fmt::format("{} at step {} is {}, but {} in the run before; use each run by itself",
                       a.name, first, b.values.front(), a.values.back()));
  }
  return 1;
}

}  // namespace

ThermoTable join_sections(const ThermoLog& log) {
  ThermoTable joined;
  for (const ThermoSection& section : log.sections) {
    if (joined.columns.empty())
      for (const auto& column : section.table.columns)
        joined.columns.push_back({column.name, {}, 0});
    expect_same_names(log, joined, section);
    const auto repeated = static_cast<std::ptrdiff_t>(repeated_rows(log, joined, section));
    for (std::size_t k = 0; k < joined.columns.size(); ++k) {
      ThermoTable::Column& into = joined.columns[k];
      const ThermoTable::Column& from = section.table.columns[k];
      into.last_digit = std::max(into.last_digit, from.last_digit);
      into.values.insert(into.values.end(), from.values.begin() + repeated, from.values.end());
    }
  }
  return joined;
}

}  // namespace mdana
