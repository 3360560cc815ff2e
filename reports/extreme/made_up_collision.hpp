// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mdana {

/// Two equal rigid balls that collide head-on along x. While they touch, -dX/dt goes smoothly from v to
/// -e v: -dX/dt = v - (1 + e) v s(t/T), s(u) = u - sin(2 pi u)/(2 pi), so that
/// F = m* (1 + e) v/T (1 - cos(2 pi t/T)) is known, and with it every number of the collision.
struct MadeUpCollision {
  double speed = 0.2;          ///< v [velocity]
  double e = 0.5;
  double duration = 4;         ///< T of contact [time]
  double interval = 0.05;      ///< between frames [time]
  double before = 1.5, after = 1.5;  ///< free flight [time]
  double ball = 2.6;           ///< cut radius of the simple cubic balls, whose atoms are 1 apart [length]
  double length = 1, mass = 1, time = 1;        ///< units of the dump, in those of the above
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(), drift = Eigen::Vector3d::Zero();
  double noise = 0;            ///< of positions [length] and velocities [velocity], at random
  std::int64_t first_id = 1, first_step = 0, step_interval = 10;
  bool shuffled = false;       ///< atoms in another order in each frame
  int digits = 17;             ///< significant, of real numbers
  std::string units = "lj";

  /// Another text for one number or line: called with each atom's columns before they are written.
  std::function<void(std::size_t frame, std::vector<std::string>& words)> change;

  std::size_t frames() const;
  std::size_t atoms() const;        ///< of one ball
  double contact_distance() const { return 2 * ball; }  ///< X where they begin to touch
  double reduced_mass() const { return static_cast<double>(atoms()) / 2; }

  std::string dump() const;         ///< LAMMPS text: id type x y z vx vy vz mass

  // What is known, in the units of the dump.
  double force_max() const;
  double delta_max() const;
  double kinetic_loss(double low) const;  ///< between the two passages of delta = low
  double speed_before() const { return speed * length / time; }
};

}  // namespace mdana
