// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analyses/value.hpp"

namespace mdana {

/// Distance of two bodies and how fast it shrinks, a value a frame.
struct ApproachSeries {
  std::vector<double> times;     ///< [time], ascending
  std::vector<double> distance;  ///< X [length]
  std::vector<double> speed;     ///< v_rel = -dX/dt [velocity]
  /// Standard deviations by printed digits; 0 if they are exact or not known.
  double distance_noise = 0, speed_noise = 0;

  bool known() const { return !times.empty() && speed.size() == times.size(); }
};

/// Where the mutual approach delta = R1 + R2 - X has its first maximum. A Value of NaN is not
/// determined, and the reason says why.
struct MaximumCompression {
  Value delta;                ///< delta_max [length]
  Value time;                 ///< t_max, since X = R1 + R2 [time]
  double contact_time = 0;    ///< when X = R1 + R2 by the clock of the dump; NaN if not determined
  double turn_time = 0;       ///< the same of the maximum
  std::string delta_reason, time_reason;
};

/// The turn is the zero of v_rel, by a straight line between frames, next to the greatest delta from
/// which delta falls back by turning_point_fraction of its rise; delta there and the contact are by the
/// cubic that has X and v_rel of both frames. Errors: the largest difference to the same from every second
/// frame (even, odd), and with it the noise of X and, over the deceleration, of v_rel.
MaximumCompression maximum_compression(const ApproachSeries& series, double radius_sum);

}  // namespace mdana
