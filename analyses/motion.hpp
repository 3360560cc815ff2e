// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "analyses/analysis.hpp"

namespace mdana {

/// Motion of one body as a whole in one frame.
struct BodyMotion {
  double atoms = 0;
  double mass = 0;                                     ///< [mass]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< centre of mass [length]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< of the centre of mass [velocity]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();     ///< sum over the atoms [force]
};

/// What is measured of the motion besides atoms, mass and position.
struct MotionParts {
  bool velocity = false;
  bool force = false;
};

/// Centre of mass of bodies 1 and 2, its velocity, and the summed force on each body.
/// Columns: atoms_none, then for b = 1, 2: atoms<b> mass<b> x<b> y<b> z<b> [vx<b> vy<b> vz<b>]
/// [fx<b> fy<b> fz<b>]. Throws InputError if a body has no atoms or a value is not finite.
std::unique_ptr<Analysis> make_motion(MotionParts parts);

/// Bodies 1 and 2 from row `row` of a motion table.
std::array<BodyMotion, 2> body_motion(const Table& motion, std::size_t row);

}  // namespace mdana
