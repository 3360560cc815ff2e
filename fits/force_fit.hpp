// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fits/fit.hpp"
#include "fits/force_law.hpp"

namespace mdana {

/// Force between two bodies against the distance of their centres, frame by frame.
struct ForceData {
  std::vector<double> distance;  ///< X [length]
  std::vector<double> force;     ///< repulsive > 0 [force]
  std::vector<double> error;     ///< standard error of each [force]; NaN if unknown
  std::size_t turn = 0;          ///< frame of greatest compression
  double radius_sum = 0;         ///< R1 + R2 [length]
  double reduced_radius = 0;     ///< R* [length]
};

/// Frames up to the first turning point, or those of contact after it too.
enum class ForcePart { loading, loop };
std::string_view name(ForcePart part);

/// All parameters of the law but R*, and R.
std::vector<std::string> usual_free_parameters(const ForceLaw& law);

struct ForceFitSettings {
  /// Names of the law's parameters; besides, `R` = (R1 + R2)/2 at a given R1/R2, or `offset`, which is
  /// added to delta at given radii. Not both: they are nearly the same.
  std::vector<std::string> free;
  ElasticContact constants;       ///< what is not free; its radius is not read
  ForcePart part = ForcePart::loading;
  /// Leave out points with delta below this part of the greatest; 0: none of contact, by delta > 0 at the
  /// given radii or by 2 % of the greatest force.
  double min_delta_fraction = 0;
  Loss loss = Loss::none;         ///< scale: one standard error, or 1 % of the greatest force without
};

/// One parameter that was found.
struct ForceEstimate {
  std::string name;
  double value = 0, error = 0;  ///< standard error
  Dimension dimension;
};

struct ForceFit {
  std::vector<ForceEstimate> parameters;
  ElasticContact contact;              ///< all of the law's parameters
  double radius_sum = 0, offset = 0;   ///< delta = radius_sum - X + offset
  Eigen::MatrixXd correlation;
  std::vector<double> singular_values; ///< of the Jacobian by the solver's parameters, of order one
  std::string weak_direction;
  std::vector<std::size_t> points;     ///< frames that were fitted
  std::vector<double> model;           ///< force at each [force]
  bool known_errors = false;
  double chi2 = 0;                     ///< in units of the errors; without, of the greatest force
  double rms_residual = 0;             ///< as a part of the greatest force
  Fit fit;                             ///< usable, reason, digits, seconds
};

/// Least squares of F(delta). On a loop, frames after the turn follow the law's unloading.
/// Throws InputError at a free parameter that the law does not have, at R with offset, at a constant
/// that is missing, and at fewer points than parameters + 1.
ForceFit fit_force(const ForceLaw& law, const ForceData& data, const ForceFitSettings& settings);

}  // namespace mdana
