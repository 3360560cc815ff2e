// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fits/collision_law.hpp"
#include "fits/force_law.hpp"

namespace mdana {

/// Motion with a force of delta alone: in along one branch from delta = 0 with v to contact.delta_max,
/// and out along another until its least delta. Times by quadrature between the points, `points` each
/// way.
std::vector<CollisionPoint> branch_motion(const ForceBranch& in, const ForceBranch& out,
                                          const ElasticContact& contact, double mass, int points = 100);

}  // namespace mdana
