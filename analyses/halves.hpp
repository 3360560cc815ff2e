// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>

#include "analyses/analysis.hpp"

namespace mdana {

/// Distance and mutual velocity of the two sides of the contact plane, whichever body their atoms
/// belong to (Arakawa et al. 2024, eqs 10-13: means over x < 0 and x > 0). The plane is normal to the
/// centre line of the frame, at (X^2 + R1^2 - R2^2)/(2X) from body 1; for equal bodies that is their
/// centre of mass. Columns: half_distance [length], half_speed [velocity] > 0 while approaching (only
/// if `velocity`), half_atoms1, half_atoms2.
std::unique_ptr<Analysis> make_halves(const std::array<double, 2>& radius, bool velocity);

}  // namespace mdana
