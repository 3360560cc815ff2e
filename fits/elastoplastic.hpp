// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "fits/collision_law.hpp"

namespace mdana {

/// Compression of two spheres that are elastic up to yield, where the centre of contact bears a
/// pressure p, and perfectly plastic beyond: F = pi R* p (delta - delta_Y/3). Andrews (p = Y), and
/// Thornton & Ning (p = 1.6 Y) without adhesion.
struct Compression {
  double yield_pressure = 0;  ///< p
  double yield_delta = 0;     ///< delta_Y = (pi^2/4)(p/E*)^2 R*
  double yield_velocity = 0;  ///< v_Y = (pi/(2E*))^2 sqrt(8 pi R*^3/(15 m*)) p^2.5
  double speed = 0;           ///< x = v/v_Y
  double delta_max = 0;
  double t_max = 0;           ///< since delta = 0

  bool yields() const { return speed > 1; }
};

Compression compression_by_pressure(const Impact& impact, double yield_pressure);
Compression compression_by_velocity(const Impact& impact, double yield_velocity);

/// t_max v/delta_max without yield: integral of 1/sqrt(1 - x^2.5), 1.4716...
double elastic_compression_time();

/// A bounce with this compression and e^2, contact_time left to the law; unresolved if the numbers
/// leave the range of doubles.
Collision bounce(const Impact& impact, const Compression& compression, double e_squared);

/// Derivatives by the logarithms of R*, m*, E*, v and the law's parameters: of ln delta_Y and ln v_Y.
struct YieldSlopes {
  Eigen::VectorXd delta, velocity;
};

/// Of delta_max, t_max, and of an e^2 that depends on x alone with de^2/dln x, by the parameters'
/// logarithms.
CollisionSensitivities log_sensitivities(const Compression& compression, const YieldSlopes& slopes,
                                         double e_squared_slope);

/// By the parameters themselves; zero for one that is not given or zero.
CollisionSensitivities by_values(CollisionSensitivities logarithmic, const CollisionInput& input);

}  // namespace mdana
