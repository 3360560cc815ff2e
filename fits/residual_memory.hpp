// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "fits/contact_fit.hpp"

namespace mdana {

/// By how many times the residuals say less than as many independent ones: those of neighbouring times
/// of a motion are alike, and so are those of its delta, v and F. The mean over the series of
/// 1 + 2 sum of their autocorrelations, up to the first that is no greater than its noise (2/sqrt(n)), times,
/// if the series of a motion are alike beyond that noise, how many are. At least 1; 1 without motions.
double residual_memory(std::span<const FittedPoint> points);

}  // namespace mdana
