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
  Value speed_before, speed_after;  ///< relative, along the centre line [velocity]
  Value e;                          ///< normal: ratio of those; 0 if the bodies stick
  Value e_total;                    ///< ratio of the whole relative speeds; 0 if they stick
  std::string reason;               ///< empty if e is determined
};

/// From the frames of the phases `approach` and `separated`. Speeds are means over those frames; the
/// error is the standard error of the mean and half of what the speed drifts over them (the force
/// reaches farther than the contact), together.
Restitution restitution(const RelativeMotion& motion, const ForceCurve& curve);

}  // namespace mdana
