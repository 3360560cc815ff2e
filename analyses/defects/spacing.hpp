// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analyses/frame_store.hpp"

namespace mdana::defects {

/// Distance of nearest neighbours [length], from the atoms themselves: about seven atoms, the mean of
/// the pairs that are nearer than between_shells times that mean, but no less than the median
/// distance to the nearest neighbour; of these seven the median. Bulk or surface, thermal noise and
/// gaps change it little; order of the atoms in the file, place and turn of the frame do not.
/// Throws InputError if there are fewer than two atoms at different places.
double nearest_neighbour_spacing(const FrameStore& frame, std::size_t threads);

}  // namespace mdana::defects
