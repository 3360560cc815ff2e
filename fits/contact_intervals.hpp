// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fits/contact_problem.hpp"

namespace mdana {

/// Fills the intervals of a usable fit's parameters; `best` is its optimum.
void add_intervals(ContactFit& fit, ContactProblem& problem, const ContactOptimum& best,
                   const IntervalSettings& settings);

/// x with P(|normal| < x) = level, 0 < level < 1.
double normal_quantile(double level);

}  // namespace mdana
