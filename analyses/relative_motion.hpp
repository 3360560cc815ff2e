// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "analyses/derivative.hpp"
#include "analyses/table.hpp"
#include "readers/units.hpp"

namespace mdana {

/// Where the interparticle force comes from, best first.
enum class ForceSource {
  forces,      ///< summed forces of the atoms: exact at every frame
  velocities,  ///< reduced mass times d/dt of the relative velocity
  positions    ///< reduced mass times d2/dt2 of the relative position
};

std::string_view name(ForceSource source);         ///< "forces", ...
std::string_view description(ForceSource source);  ///< in words with its formula

/// Motion of body 2 seen from body 1, one column a frame.
struct RelativeMotion {
  std::vector<std::int64_t> steps;
  std::vector<double> times;      ///< [time]; empty if unknown
  double reduced_mass = 0;        ///< m* = m1 m2 / (m1 + m2) of the first frame [mass]
  Eigen::Matrix3Xd position;      ///< X2 - X1 [length]
  Eigen::Matrix3Xd velocity;      ///< [velocity]; no columns if not measured
  Eigen::Matrix3Xd acceleration;  ///< F2/m2 - F1/m1 [force/mass]; no columns without forces
  /// Atoms of the bodies that are missing since the first frame, in each frame (less than zero: there
  /// are more).
  std::vector<double> lost;
  std::size_t first_lost = 0;     ///< first frame in which a body has other atoms; 0 if there is none
  double greatest_loss = 0;       ///< greatest change of a body's atoms or mass over that of frame 0
  /// Standard deviation of a component by the printed digits; 0 if they are exact or not known.
  double position_noise = 0, velocity_noise = 0;

  Eigen::Index frames() const { return position.cols(); }
  bool can_give(ForceSource source) const;
  std::vector<double> distance() const;  ///< X = |X2 - X1| [length]

  /// Every `stride`-th frame from `first` on.
  RelativeMotion subset(std::size_t first, std::size_t stride) const;
};

/// Beyond this part of its atoms or its mass a body that loses or gains atoms is no longer the same.
inline constexpr double most_lost = 0.01;

/// From a motion table. `times` may be empty. The reduced mass stays that of the first frame; the
/// bodies' centres and their velocities are those of the atoms that are there. Throws InputError if a
/// body loses or gains more than most_lost, or times do not grow.
RelativeMotion relative_motion(const Table& motion, const std::vector<std::int64_t>& steps,
                               const std::vector<double>& times);

/// Measured velocities, else the derivative of the positions, else no columns [velocity].
Eigen::Matrix3Xd relative_velocity(const RelativeMotion& motion);

/// Approach speed -dX/dt > 0 while approaching, from velocities or else from positions [velocity];
/// empty if neither velocities nor times are known, or if frames are too few to differentiate.
std::vector<double> approach_speed(const RelativeMotion& motion);

/// Squared relative speed [velocity^2] of every frame; empty as approach_speed.
std::vector<double> squared_speed(const RelativeMotion& motion);

/// How a force is differentiated from speeds or positions.
struct ForceDerivative {
  int window = 0;  ///< frames, odd, more than the degree; 0: as many as the noise justifies, here degree + 1
  int degree = 4;  ///< of the polynomials: even, 2 to 8; in the middle of a window truncation is of this order
};

/// Force between the bodies along their centre line, positive if repulsive, in the unit system's
/// force unit: m* times relative acceleration (Yoshida, Kokubo & Tanaka 2024, Sec. IV A 1).
/// Throws InputError if the source is not there, frames are too few to differentiate, or the centres
/// coincide.
std::vector<double> interparticle_force(const RelativeMotion& motion, ForceSource source,
                                        Units units, ForceDerivative by = {});

/// Five-point formulas, exact for polynomials of degree 4.
inline constexpr DerivativeRule first_derivative{1, 4, 5};
inline constexpr DerivativeRule second_derivative{2, 4, 5};

}  // namespace mdana
