// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

namespace mdana {

/// The fewest points of a curve that Douglas & Peucker (1973) keep so that none of the others is farther
/// than `tolerance` [of the points] from the straight lines between them; the ends always.
std::vector<Eigen::Vector2d> thinned_curve(const std::vector<Eigen::Vector2d>& points, double tolerance);

}  // namespace mdana
