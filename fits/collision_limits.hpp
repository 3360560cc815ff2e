// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fits/collision_law.hpp"

namespace mdana {

/// A velocity found between others.
struct VelocityFound {
  double velocity = Collision::unknown;  ///< [velocity]
  double error = Collision::unknown;     ///< half of what brackets it
  std::string reason;                    ///< why nothing was found
  double e = Collision::unknown;         ///< there
  double e_error = Collision::unknown;
  long collisions = 0;  ///< computed for it

  bool found() const { return reason.empty(); }
};

/// Velocities to look at first if none are stated, ascending: about what JKR needs to bounce, or,
/// without adhesion, about the speed of sound.
std::vector<double> search_velocities(const CollisionLaw& law, const CollisionInput& input);

/// The velocity above which the spheres bounce: the first change from sticking to bouncing along
/// the ascending velocities, by bisection of the outcome.
VelocityFound sticking_velocity(const CollisionLaw& law, CollisionInput input,
                                const std::vector<double>& velocities,
                                const CollisionSettings& settings = {});

/// The velocity of the greatest e: about the greatest of the ascending velocities, where d(e^2)/dv
/// is zero or changes its sign.
VelocityFound peak_velocity(const CollisionLaw& law, CollisionInput input,
                            const std::vector<double>& velocities,
                            const CollisionSettings& settings = {});

}  // namespace mdana
