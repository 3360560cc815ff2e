// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fits/collision_law.hpp"
#include "fits/segment.hpp"

namespace mdana {

/// How one integration of a collision is to be done.
struct MotionSettings {
  double tolerance;  ///< of the embedded error of a step
  IntegrationLimits limits;
  bool trajectory = false, sensitivities = false;
  std::vector<double> times = {};  ///< as CollisionSettings has them, over tau
};

/// A collision in scaled variables, from one integration.
struct ContactMotion {
  static constexpr double unknown = Collision::unknown;
  static constexpr int parameters = 6;  ///< at most, of the scaled equations
  using Gradient = Eigen::Matrix<double, parameters, 1>;

  CollisionOutcome outcome = CollisionOutcome::unresolved;
  std::string reason;
  bool bound = false;          ///< that the spheres stick is proven, whatever e_squared is
  bool adhesive = true;        ///< without adhesion every collision is a bounce
  double e_squared = unknown;  ///< continued below zero if the spheres stick
  double d_max = unknown, t_max = unknown, t_end = unknown;
  double u_max = 0;
  double residual = 0;  ///< of the energy, greatest over all steps, over w_0^2/2
  long evaluations = 0;
  struct Point {
    double t, d, w, u, f;
  };
  std::vector<Point> trajectory;
  Gradient by_e_squared = Gradient::Zero(), by_d_max = Gradient::Zero(),
           by_t_max = Gradient::Zero();
};

/// Krijt's contact with a free contact radius (P1 eqs 10-12, B1, B2), or with T(p_c) of eq. 17, in
/// the scaled variables of fits/jkr.
struct CrackContact {
  double w0 = 0;   ///< impact speed
  double lam = 0;  ///< 2 T_vis/(nu^2 tau)
  double kap = 0;  ///< 2 E* gamma tau/(sigma_0^2 T_crack a_0)
  double b = 0;    ///< B p_c/E* = b (u - 1/(3 sqrt u))
  double zeta = 1;
  bool stress = false;           ///< T(p_c) in the force
  bool stress_in_crack = false;  ///< and in the crack law
  bool start_on_curve = false;   ///< on the JKR curve, else at the least admissible beta
};

/// Gradients by w0, lam, kap, b, zeta.
ContactMotion move(const CrackContact& contact, const MotionSettings& settings);

/// A contact radius on a curve a(delta), with a force of dissipation.
struct CurveContact {
  bool bound = false;    ///< that the spheres stick is proven, whatever e_squared is
  bool adhesive = true;  ///< JKR, in its scaled variables; else Hertz, u = sqrt(d), w0 = 1
  bool power = false;    ///< eq. 19 with D, alpha, beta; else eq. 12, or 17, with lam, b, zeta
  bool stress = false;
  double w0 = 1;
  std::array<double, 3> p{};
};

/// Gradients by w0, then p.
ContactMotion move(const CurveContact& contact, const MotionSettings& settings);

}  // namespace mdana
