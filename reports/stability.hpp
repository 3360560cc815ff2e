// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/analysed_run.hpp"

namespace mdana {

/// How many digits of a published number the printed digits of the dump fix.
struct StabilityRow {
  std::string quantity;
  double value = 0;
  double change = 0;  ///< largest over the repetitions, infinite if one does not determine the number
  double digits = 0;  ///< -log10 |change/value|, at most 15
  std::optional<double> error = {};  ///< as it is stated

  bool weak() const { return digits < least_stable_digits; }
  bool told() const { return error && change <= 2 * *error; }  ///< the stated error covers the change
  static constexpr double least_stable_digits = 3;
};

inline constexpr int stability_repetitions = 4;

/// Published numbers of a run as an analysis with these options finds them.
using NumbersOfRun = std::function<std::vector<PublishedValue>(const SweepOptions& options)>;

/// Repeats an analysis that gave `full` with every number of the dump moved at random within its last
/// printed digit, and tells what that does to the published numbers.
std::vector<StabilityRow> stability_rows(const std::vector<PublishedValue>& full, const NumbersOfRun& again,
                                         const SweepOptions& options);

/// The same of the numbers of force, contact radius and fit.
std::vector<StabilityRow> stability_rows(const Run& run, const AnalysedRun& full,
                                         const SweepOptions& options);

}  // namespace mdana
