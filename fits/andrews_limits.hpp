// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "fits/collision_law.hpp"

namespace mdana {

/// delta_max and t_max of one collision.
struct Compressed {
  double delta_max = 0;  ///< [length]
  double t_max = 0;      ///< [time]
};

/// Elastic limit of Andrews' law, Y infinite (Arakawa et al. 2024, eqs 30, 32).
Compressed elastic_limit(const Impact& impact);

/// Rigid plastic limit, E* infinite (eqs 31, 33). Of the impact, R*, m* and v count.
Compressed rigid_plastic_limit(const Impact& impact, double yield_strength);

/// A pair E*, Y that gives one delta_max, and delta_Y/delta_max with it.
struct DegeneratePair {
  double yield_share;     ///< 1: elastic, to 0: rigid plastic
  double modulus;         ///< E* [pressure]; infinite at 0
  double yield_strength;  ///< Y [pressure]
};

/// Pairs E*, Y that give this delta_max (eqs 24, 27, 28; Fig. 10), from elastic to rigid plastic, the
/// shares falling by powers from 1 to 1e-4 and 0 at last. Of the impact, R*, m* and v count. At least
/// three.
std::vector<DegeneratePair> degenerate_pairs(const Impact& impact, double delta_max, std::size_t count);

}  // namespace mdana
