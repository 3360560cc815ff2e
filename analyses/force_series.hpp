// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analyses/relative_motion.hpp"

namespace mdana {

/// The force between the bodies at every frame, with what is known of its error.
struct ForceSeries {
  std::vector<double> value;       ///< repulsive > 0 [force]
  std::vector<double> truncation;  ///< of the derivative [force]; empty if frames are too few to tell
  double noise = 0;                ///< standard deviation from frame to frame [force]
  double scatter = 0;              ///< of a derivative, by its own differences: noise that no printed digits tell [force]
  std::vector<double> edges;       ///< noise by the place in the window, over that of its middle; empty for summed forces
  int window = 0;                  ///< frames that a derivative is made from; 0 for summed forces
  double order = 0;                ///< observed order of convergence under halved sampling, 0 to the degree

  /// Truncation and noise together, of frame i; not finite if unknown.
  double error(std::size_t i) const;
  /// Of frame i [force]; the first and the last frames of a derivative are seen from one side.
  double noise_at(std::size_t i) const;
};

/// Windows that are tried for derivatives, after the shortest, degree + 1.
inline constexpr int derivative_windows[] = {5, 7, 9, 13, 17, 25};

/// Force along the centre line as by interparticle_force. For derivatives the window is the longest
/// one whose force differs from those of all shorter ones by no more than the noise of printed digits
/// explains (Lepski 1990; without such noise it is the shortest); its truncation error is the difference to every second frame, divided by 2^p - 1,
/// where p is the order of convergence that halving the sampling twice shows (between 1 and the degree).
/// A window that is not 0 is taken as it is.
ForceSeries force_series(const RelativeMotion& motion, ForceSource source, Units units, ForceDerivative by = {});

/// Standard deviation of what changes from sample to sample without rule: by the median of the 4th,
/// 8th and 12th differences, whichever is least, since what is resolved leaves the higher ones small; as n
/// samples know it only to 1.5/sqrt(n) of itself, by so much more. An upper bound where sampling resolves a
/// series badly. 0 for fewer than 32 samples.
double noise_of(const std::vector<double>& series);

}  // namespace mdana
