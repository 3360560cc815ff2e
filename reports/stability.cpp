// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mdana {
namespace {

/// Infinite if the number is not determined there.
double change_of(const StabilityRow& row, const std::vector<PublishedValue>& numbers) {
  const auto n = std::ranges::find(numbers, row.quantity, &PublishedValue::name);
  const bool determined = n != numbers.end() && !std::isnan(n->value.value);
  return determined ? std::abs(n->value.value - row.value) : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<StabilityRow> stability_rows(const std::vector<PublishedValue>& full, const NumbersOfRun& again,
                                         const SweepOptions& options) {
  std::vector<StabilityRow> rows;
  for (const PublishedValue& number : full)
    if (!std::isnan(number.value.value)) rows.push_back({number.name, number.value.value, 0, 0, number.value.error});
  for (int seed = 1; seed <= stability_repetitions; ++seed) {
    SweepOptions moved = options;
    moved.last_digit_seed = static_cast<std::uint64_t>(seed);
    const std::vector<PublishedValue> numbers = again(moved);
    for (StabilityRow& row : rows) row.change = std::max(row.change, change_of(row, numbers));
  }
  for (StabilityRow& row : rows)
    row.digits = row.change == 0
                     ? 15.0
                     : std::clamp(-std::log10(row.change / std::abs(row.value)), 0.0, 15.0);
  return rows;
}

std::vector<StabilityRow> stability_rows(const Run& run, const AnalysedRun& full,
                                         const SweepOptions& options) {
  const auto again = [&](const SweepOptions& moved) { return analyse_run(run, same_numbers(full), moved).numbers(); };
  return stability_rows(full.numbers(), again, options);
}

}  // namespace mdana
