// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "reports/accuracy.hpp"

namespace mdana {

/// Forgets the greatest resident size of the program so far; false if the system does not let it.
bool reset_peak_memory();

/// Greatest resident size of the program since then [bytes]; NaN if the system does not tell.
double peak_memory();

/// What repeated work costs; the work may throw.
Cost price_of(std::size_t repetitions, const std::function<void()>& work);

}  // namespace mdana
