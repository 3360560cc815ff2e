// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/rigid_rotation.hpp"

#include <Eigen/Eigenvalues>

namespace mdana {
namespace {

/// No rotation about an axis whose moment of inertia is below this part of the body's second moments:
/// atoms on the axis, up to the rounding of their positions (squared, with room).
constexpr double least_inertia = 1e-12;

}  // namespace

/// Over the principal axes. Their moments of inertia are sums of two principal second moments, which do not cancel
/// for atoms on a line as tr(S) - S does.
RigidRotation rigid_rotation(const Eigen::Matrix3d& spread, const Eigen::Vector3d& spin) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(spread);
  const Eigen::Vector3d& s = principal.eigenvalues();
  RigidRotation result;
  for (int k = 0; k < 3; ++k) {
    const double inertia = s[(k + 1) % 3] + s[(k + 2) % 3];
    if (!(inertia > least_inertia * s.sum())) continue;
    const double l = principal.eigenvectors().col(k).dot(spin);
    result.energy += 0.5 * l * (l / inertia);
    ++result.axes;
  }
  return result;
}

}  // namespace mdana
