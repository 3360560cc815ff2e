// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fits/observed_collision.hpp"

namespace mdana {

/// A collision from rows of delta(t), in the order of time, of any origin: `motion` begins at the last
/// delta <= 0 before the first compression, times count from delta = 0, and `v` is the speed there, both
/// by the cubic through the two rows about it and their velocities, or through four rows without. It
/// ends before delta rises again after the first compression, or where the bodies are farther
/// apart than they were compressed. Throws InputError with the place if times do not rise, delta does not
/// pass 0 or never falls again.
ObservedCollision followed_collision(const std::vector<MotionSample>& rows, const std::string& place);

}  // namespace mdana
