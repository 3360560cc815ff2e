// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include <Eigen/Core>

namespace mdana {

/// What data determine least, of parameters p with d residual/d ln p = U S V^T: the product of their
/// powers that is known worst, with its relative error in units of the best known one; and, if it is
/// not known at all, those that are ("only gamma^5/E^2 is determined").
std::string describe_weak_direction(std::span<const std::string> names, const Eigen::MatrixXd& v,
                                    const Eigen::VectorXd& singular_values);

}  // namespace mdana
