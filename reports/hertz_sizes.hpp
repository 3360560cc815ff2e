// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "analyses/table.hpp"
#include "analyses/value.hpp"
#include "reports/document.hpp"
#include "reports/pooled.hpp"

namespace mdana {

/// What a Hertz fit of one run found.
struct HertzRun {
  double atoms = 0;       ///< of the first body
  Value modulus, radius;  ///< E* [pressure], R [length], with errors
};

/// What runs of bodies of one size say together.
struct HertzSize {
  double atoms = 0;  ///< mean
  std::size_t runs = 0;
  Pooled modulus, radius;
};

/// By size, smallest first; atoms within 1 % of the smallest of a size are of that size.
std::vector<HertzSize> pool_by_size(std::span<const HertzRun> runs);

/// `sizes`, and for one size E_star and R besides.
void add_sizes(Document& document, std::span<const HertzSize> sizes);

/// Columns N, runs, R and E_star with error and deviation between runs: a row a size.
Table size_table(std::span<const HertzSize> sizes);

}  // namespace mdana
