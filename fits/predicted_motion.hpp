// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "fits/collision_law.hpp"

namespace mdana {

/// Where a collision is at given times since delta = 0, which rise: in free flight before the contact and
/// after it, and where it was computed last if the spheres were found bound then. `collision` is computed
/// with those of the times that are not negative (CollisionSettings::times), v is its impact velocity.
/// NaN if it has no trajectory.
std::vector<CollisionPoint> predicted_motion(const Collision& collision, double velocity,
                                             std::span<const double> times);

}  // namespace mdana
