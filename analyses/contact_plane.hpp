// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include <Eigen/Core>

#include "analyses/motion.hpp"

namespace mdana {

/// The plane in which two spheres meet, with two axes in it. It is normal to the centre line, at
/// (X^2 + R1^2 - R2^2)/(2X) from the centre of body 1.
struct ContactPlane {
  Eigen::Vector3d point, normal, u, v;

  /// `radius` of body 1, 2 [length]. Throws InputError naming `place` if the centres coincide.
  ContactPlane(const BodyMotion& body1, const BodyMotion& body2,
               const std::array<double, 2>& radius, const std::string& place);
};

}  // namespace mdana
