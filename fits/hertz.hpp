// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "analyses/value.hpp"
#include "fits/fit.hpp"

namespace mdana {

/// Least squares in F, or in F^(2/3), which is linear in X.
enum class HertzMethod { force, linear };
/// Frames up to the first turning point, or all.
enum class HertzPhase { loading, all };

/// All points alike, or by their standard errors.
enum class HertzWeights { equal, errors };

std::string_view name(HertzMethod method);
std::string_view name(HertzPhase phase);

/// Force between two bodies against the distance of their centres.
struct HertzData {
  std::vector<double> distance;  ///< X [length], one a frame
  std::vector<double> force;     ///< repulsive > 0 [force]
  std::size_t turn = 0;          ///< frame of greatest compression
  std::vector<double> error = {};  ///< standard errors [force]; needed for weights by errors only
  double radius_ratio = 1;       ///< R1/R2, which F(X) does not tell
};

/// Which points are fitted and how. Fractions are of the greatest force.
struct HertzSettings {
  HertzMethod method = HertzMethod::force;
  HertzPhase phase = HertzPhase::loading;
  double min_force_fraction = 0.05;
  double max_force_fraction = 1.0;
  Loss loss = Loss::none;
  HertzWeights weights = HertzWeights::equal;
};

/// F(X) = 4/3 E* sqrt(R*) (R1 + R2 - X)^1.5 determines E* sqrt(R*) and R1 + R2; with the given R1/R2 they
/// are E* and R = (R1 + R2)/2, of equal spheres F(X) = 4/3 E* sqrt(R/2) (2R - X)^1.5 (Yoshida, Kokubo
/// & Tanaka 2024, eq. 2 and appendix A).
struct HertzFit {
  HertzSettings settings;
  Value modulus;  ///< E* [pressure]; error: standard error from the covariance
  Value radius;   ///< R [length]; likewise
  /// E* sqrt(R*) and its standard error [pressure length^(1/2)].
  double strength = 0, strength_error = 0;
  double correlation = 0;
  std::vector<std::size_t> points;  ///< frames that were fitted
  double rms_residual = 0;          ///< of the force, as a part of the greatest force
  Fit fit;
};

/// Throws InputError if fewer than three frames lie within the settings' range, at NaN and inf, and, with
/// weights by errors, if a point has none.
HertzFit fit_hertz(const HertzData& data, const HertzSettings& settings = {});

/// What the choices of method, thresholds and phase do to one parameter.
struct Spread {
  double least = 0, greatest = 0;
  double deviation = 0;  ///< root mean square difference from the value in question
};

/// The same data fitted in many defensible ways: methods force and linear, least force fractions
/// 0.02 0.05 0.1 0.2, greatest 0.5 0.75 1, phases loading and all. The spread between them is the
/// real uncertainty of E*; a covariance knows nothing of it.
struct HertzSpread {
  std::vector<HertzFit> variants;  ///< the usable ones
  Spread modulus, radius;          ///< about `chosen`
};

HertzSpread hertz_spread(const HertzData& data, const HertzFit& chosen);

}  // namespace mdana
