// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/analysed_run.hpp"

namespace mdana {

/// How many digits of a published number the printed digits of the dump fix.
struct StabilityRow {
  std::string quantity;
  double value = 0;
  double change = 0;  ///< largest over the repetitions
  double digits = 0;  ///< -log10 |change/value|, at most 15

  bool weak() const { return digits < least_stable_digits; }
  static constexpr double least_stable_digits = 3;
};

inline constexpr int stability_repetitions = 4;

/// Repeats the analysis with every number of the dump moved at random within its last printed
/// digit, and tells what that does to the published numbers.
std::vector<StabilityRow> stability_rows(const Run& run, const AnalysedRun& full,
                                         const SweepOptions& options);

}  // namespace mdana
