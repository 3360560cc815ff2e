// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "fits/collision_law.hpp"
#include "fits/force_law.hpp"

namespace mdana {

/// Motion with a force of delta alone: in along one branch from delta = 0 with v to contact.delta_max,
/// and out along another until its least delta. At `times`, as CollisionSettings has them, or, without,
/// at 100 points each way; times by quadrature.
std::vector<CollisionPoint> branch_motion(const ForceBranch& in, const ForceBranch& out,
                                          const ElasticContact& contact, double mass,
                                          std::span<const double> times = {});

}  // namespace mdana
