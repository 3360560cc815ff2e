// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analyses/force_curve.hpp"

namespace mdana {

/// What one loop of F over delta costs, between its passages of the delta `low` [energy]. NaN where it cannot be had.
struct LoopLoss {
  double area = 0;           ///< integral of F d delta, by trapezoids over delta
  double area_by_time = 0;   ///< the same as the integral of F v dt, of higher order
  double area_error = 0;     ///< of what changes from frame to frame without rule; see `sampling`
  double kinetic = 0;        ///< kinetic energy that the motion along the centre line lost to F
  double kinetic_total = 0;  ///< kinetic energy that the relative motion lost, across the line too
};

/// The area is that of trapezoids over delta, exact for a force that is linear in it between frames, and
/// once more by time by the corrected trapezoidal rule. Work, energies and delta are cubic Hermite between
/// frames, with slopes by five-point derivatives; they are not known without times or speeds, or of fewer frames than
/// a derivative needs. Kinetic energy along the line is m*/2 v_r^2 less the integral of m* u^2/X dX, by which the
/// motion across it, u, drives the distance: it changes by F alone.
class PathEnergies {
 public:
  PathEnergies(const RelativeMotion& motion, Units units, const ForceCurve& curve);

  LoopLoss of(const Cycle& cycle, double low) const;
  LoopLoss between(std::size_t first, std::size_t last) const;  ///< from frame to frame

 private:
  /// Values and slopes by time.
  struct Smooth {
    std::vector<double> value, slope;
    double at(std::size_t i, double part, double step) const;
  };
  struct Passage {
    std::size_t frame;  ///< before it
    double part;        ///< of the step to the next one
  };

  /// Standard error of the work between two frames where sampling does not resolve the force: each
  /// frame's F v is then off at random by its fourth difference over sqrt(70), which is the standard
  /// deviation of numbers without rule and nearly nothing for smooth ones.
  double sampling(std::size_t first, std::size_t last) const;
  Passage passage(std::size_t before, double low) const;
  double at(const Smooth& series, const Passage& place) const;
  void find_work();
  double area(std::size_t first, std::size_t last, double low) const;
  void find_kinetic(const RelativeMotion& motion, double mass);

  const ForceCurve& curve_;
  std::vector<double> times_;
  bool smooth_;
  Smooth delta_, work_, along_, total_;
};

}  // namespace mdana
