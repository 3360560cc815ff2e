// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "analyses/value.hpp"

namespace mdana {

/// One number out of several runs that need not agree within their errors.
struct Pooled {
  Value value;         ///< mean weighted by 1/(within^2 + between^2), and its standard error
  double within = 0;   ///< root mean square of the runs' own errors
  double between = 0;  ///< standard deviation between runs beyond their errors; NaN for one run
  double spread = 0;   ///< sample standard deviation of the runs' values; NaN for one run
};

/// Random-effects mean (DerSimonian & Laird, Control. Clin. Trials 7 (1986) 177). The values have errors
/// > 0 and one dimension; there is at least one.
Pooled pool(std::span<const Value> runs);

}  // namespace mdana
