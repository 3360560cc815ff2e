// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fits/contact_fit.hpp"

namespace mdana {

/// Where a fit fails, in words: rms and mean of the residuals by R and by v where they are greater than
/// elsewhere, and the observation with the largest. Empty if there are no points.
std::vector<std::string> describe_residuals(std::span<const ObservedCollision> seen,
                                            std::span<const FittedPoint> points);

}  // namespace mdana
