// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fits/observed_collision.hpp"

namespace mdana {

/// R and v that differ by less (relative) are those of repeated runs: of equal aggregates made anew.
inline constexpr double same_radius_of_runs = 0.005, same_velocity_of_runs = 0.01;

/// Indices of the collisions of each R and v, in the order in which these come. R and v are known.
std::vector<std::vector<std::size_t>> repeats_of(std::span<const ObservedCollision> seen);

/// Mean and sample standard deviation (NaN of less than two) of what is known.
struct Scatter {
  double mean = 0, deviation = 0;
  std::size_t count = 0;
};
Scatter scatter_of(std::span<const double> values);

/// Sets the errors of delta_max and t_max to how repeated runs scatter, with the runs' own errors: of
/// five repeats and more by themselves, else by the scatter, relative to the means, of all repeats
/// together. Without any repeats nothing tells how runs scatter: none of the errors is known then.
/// Returns whether they are.
bool set_errors_by_repeats(std::span<ObservedCollision> seen);

}  // namespace mdana
