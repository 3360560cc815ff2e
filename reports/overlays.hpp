// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analyses/force_curve.hpp"
#include "analyses/table.hpp"
#include "fits/force_law.hpp"
#include "reports/document.hpp"

namespace mdana {

/// How much the force of the first unloading is below that of the loading at the same delta, a value
/// a frame [force]; NaN in frames that are not in that unloading, or where loading has no such delta.
struct LoopForce {
  std::vector<double> difference, error;
};
LoopForce loop_force(const ForceCurve& curve);

/// As in Yoshida, Kokubo & Tanaka 2024, Sec. IV A 1-2: columns F_over_F_c and loop_over_F_c, the
/// absolute value of that difference over F_c = 3 pi gamma R*; with E*, delta_over_delta0 and the laws
/// F_hertz and F_jkr besides; numbers F_c, delta_0, loop_over_F_c.max and its delta. `contact` has 0
/// for what is not known.
void add_overlays(Document& document, Table& table, const ForceCurve& curve,
                  const ElasticContact& contact);

}  // namespace mdana
