// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace mdana {

/// Typical numbers of the collisions that a fit looks at, to make its unknowns of order one.
struct CollisionScales {
  double radius = 0;          ///< R* [length]
  double velocity = 0;        ///< [velocity]
  double modulus = 0;         ///< E* [pressure]
  double mass = 0;            ///< m* [mass]
  double time = 0;            ///< elastic contact time [time]
  double contact_radius = 0;  ///< elastic greatest contact radius [length]
  double force = 0;           ///< elastic greatest force [force]
  double pressure = 0;        ///< elastic greatest p_c/E*
};

/// One number that the solver looks for: a parameter, of all observations or of those of one group.
struct Unknown {
  std::string parameter;
  double least = 0, greatest = 0;  ///< where starts are drawn from; of the parameter
  double start = 0;                ///< of the parameter; 0: not given
  bool bounded = false;            ///< the parameter must not leave the range
};

/// The solver's coordinates q of the logarithms of the unknowns. They are these logarithms, but for
/// parameters that form a valley: C, B, zeta become ln C, ln z with z = (B p)^zeta at a pressure p
/// of the data, ln zeta; D, alpha, beta become the logarithm of D v^alpha a^beta, a force over E*, at v
/// and a of the data, alpha, beta.
class FitCoordinates {
 public:
  FitCoordinates(std::vector<Unknown> unknowns, const CollisionScales& scales);

  std::size_t size() const { return unknowns_.size(); }

  /// Where the k-th start is: the given one or the middle for 0, then evenly spread ones (Halton).
  std::vector<double> start(std::size_t k) const;

  /// ln of the unknowns, and their derivatives by q.
  Eigen::VectorXd logarithms(std::span<const double> q) const;
  Eigen::MatrixXd derivatives(std::span<const double> q) const;

  /// How far q and the logarithms of bounded unknowns are out of their ranges, signed; 0 within. What
  /// is not bounded may leave by a factor of about seven, powers by less. First size() values, then size() more.
  Eigen::VectorXd beyond(std::span<const double> q) const;

 private:
  enum class Kind { logarithms, stress, power };
  struct Range {
    double least, greatest, start;
    double margin = 2;
  };
  void stress_ranges();
  void power_ranges();

  std::vector<Unknown> unknowns_;
  CollisionScales scales_;
  Kind kind_ = Kind::logarithms;
  std::vector<Range> ranges_;  ///< of q
};

}  // namespace mdana
