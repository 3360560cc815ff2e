// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analyses/force_curve.hpp"
#include "analyses/relative_motion.hpp"
#include "analyses/value.hpp"

namespace mdana {

/// Speeds of straight flight before and after a collision, and their ratios. A Value without a number
/// (NaN) is not determined, and `reason` says why.
struct Restitution {
  /// Relative, along the centre line at the first turn, from which free flight does not deviate
  /// [velocity].
  Value speed_before, speed_after;
  Value speed_before_total, speed_after_total;  ///< of the whole relative motion [velocity]
  Value e;                          ///< normal: ratio of those; 0 if the bodies stick
  Value e_total;                    ///< ratio of the whole relative speeds; 0 if they stick
  /// Across that line; and the impact parameter |X x V|/|V| before [length].
  Value tangential_before, tangential_after, impact_parameter;
  std::string reason;               ///< empty if e is determined
};

/// The centre line, from body 1 to body 2, at the first turn; without one at the greatest delta.
Eigen::Vector3d impact_normal(const RelativeMotion& motion, const ForceCurve& curve);

/// From the first half of the frames of the phase `approach` and the last half of `separated`, those
/// farthest from the contact. Speeds are means over them; the error is the standard error of the mean
/// and half of what the speed drifts over them (the force reaches farther than the contact), together;
/// of one frame, the change to its neighbour.
Restitution restitution(const RelativeMotion& motion, const ForceCurve& curve);

}  // namespace mdana
