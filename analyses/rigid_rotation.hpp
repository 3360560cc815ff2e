// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace mdana {

/// The part of a body's motion that is rotation as a rigid body.
struct RigidRotation {
  double energy = 0;  ///< [mass velocity^2]
  int axes = 0;       ///< about which the body can turn: 3, of atoms on a line 2, of one atom 0
};

/// 1/2 L . I^-1 L, from the second moments sum of m dx dx^T and the angular momentum about the centre of mass.
RigidRotation rigid_rotation(const Eigen::Matrix3d& spread, const Eigen::Vector3d& spin);

}  // namespace mdana
