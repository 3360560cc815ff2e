// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/turning_points.hpp"

namespace mdana {

std::vector<Turn> turning_points(const std::vector<double>& series, double threshold) {
  std::vector<Turn> turns;
  if (series.empty()) return turns;
  std::size_t high = 0, low = 0;  // candidates since the last turn
  bool rising = true, falling = true;  // both while the direction is not known
  for (std::size_t i = 1; i < series.size(); ++i) {
    if (series[i] > series[high]) high = i;
    if (series[i] < series[low]) low = i;
    if (rising && series[high] - series[i] > threshold) {
      if (!falling) turns.push_back({high, true});
      rising = false;
      falling = true;
      low = i;
    } else if (falling && series[i] - series[low] > threshold) {
      if (!rising) turns.push_back({low, false});
      rising = true;
      falling = false;
      high = i;
    }
  }
  return turns;
}

}  // namespace mdana
