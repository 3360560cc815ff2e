// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/analysed_run.hpp"

namespace mdana {

/// One setting of a knob: what it gives, how far that is from the reference, what it costs.
struct AccuracyRow {
  std::string setting;   ///< "1 of 2 frames", "all frames, method linear"
  std::string quantity;  ///< "E_star"
  double value = 0;
  double error = 0;      ///< |value / reference - 1|
  double seconds = 0;    ///< reading and analysis; median of three passes
};

/// Error against run time over the frame stride (1, 2, 4, 8) and, for Hertz scenes, the fit method.
/// The reference is every frame with the default method. `full` is that run.
std::vector<AccuracyRow> accuracy_rows(const Run& run, const AnalysedRun& full,
                                       const SweepOptions& options);

/// Passes over the dump that this takes, and how many times the number of its frames are analysed in them.
std::pair<double, double> accuracy_passes();

}  // namespace mdana
