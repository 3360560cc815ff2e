// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analyses/value.hpp"

namespace mdana {

/// How far the contact radius after the first greatest delta is from that before it, at the same
/// delta: where the difference is largest.
struct ContactHysteresis {
  Value difference;  ///< unloading minus loading [length]; NaN without a turn in contact
  Value delta;       ///< where [length]
};

/// A row a frame: delta, contact radius and its error [length]. Loading is read between frames by
/// straight lines; the error is that of both radii together.
ContactHysteresis contact_hysteresis(const std::vector<double>& delta,
                                     const std::vector<double>& radius,
                                     const std::vector<double>& error);

}  // namespace mdana
