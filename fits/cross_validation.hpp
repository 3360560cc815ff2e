// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "fits/contact_problem.hpp"

namespace mdana {

/// Root mean square of the residuals of observations that the fit did not see: those with one value of
/// R or v (or, of many values, with neighbouring ones) at a time. `best` is the optimum of all, null if
/// nothing is free. NaN if there are fewer than two values, or a fit fails.
double cross_validated(ContactProblem& problem, const ContactOptimum* best,
                       std::span<const ObservedCollision> seen, std::string_view name);

}  // namespace mdana
