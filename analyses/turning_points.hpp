// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace mdana {

/// A local extreme of a series.
struct Turn {
  std::size_t index;
  bool maximum;
};

/// Extremes from which the series goes back by more than `threshold` before it goes beyond them
/// again; maxima and minima alternate.
std::vector<Turn> turning_points(const std::vector<double>& series, double threshold);

}  // namespace mdana
