// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/stability.hpp"

#include <algorithm>
#include <cmath>

namespace mdana {

std::vector<StabilityRow> stability_rows(const Run& run, const AnalysedRun& full,
                                         const SweepOptions& options) {
  std::vector<StabilityRow> rows;
  for (const PublishedValue& number : full.numbers()) rows.push_back({number.name, number.value.value});
  for (int seed = 1; seed <= stability_repetitions; ++seed) {
    SweepOptions moved = options;
    moved.last_digit_seed = static_cast<std::uint64_t>(seed);
    const std::vector<PublishedValue> numbers = analyse_run(run, same_numbers(full), moved).numbers();
    for (StabilityRow& row : rows)
      if (const auto n = std::ranges::find(numbers, row.quantity, &PublishedValue::name); n != numbers.end())
        row.change = std::max(row.change, std::abs(n->value.value - row.value));
  }
  for (StabilityRow& row : rows)
    row.digits = row.change == 0
                     ? 15.0
                     : std::clamp(-std::log10(row.change / std::abs(row.value)), 0.0, 15.0);
  return rows;
}

}  // namespace mdana
