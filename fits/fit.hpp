// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace mdana {

/// How residuals beyond a scale are damped, so that outliers do not rule the fit.
enum class Loss { none, huber, cauchy };

std::string_view name(Loss loss);

/// Outcome of a least-squares fit as data. `usable` is computed from the optimum itself, never from
/// the solver's status.
struct Fit {
  std::vector<double> values;        ///< the parameters, as they were given to the solver
  Eigen::MatrixXd covariance;        ///< of the values, from the residuals' variance
  std::vector<double> residuals;     ///< one a point, before the loss
  std::vector<double> singular_values;  ///< of the Jacobian at the optimum, largest first
  double condition = 0;              ///< largest by smallest singular value
  double digits = 0;                 ///< correct decimal digits of the optimum (see solve)
  int iterations = 0;
  double seconds = 0;
  bool usable = false;
  std::string reason;                ///< why it is not usable, or empty
};

/// Residual of one data point and its derivatives by the parameters, of which there may be none, if
/// they are not wanted. Returns false where the residual is not defined.
using PointResidual = std::function<bool(std::size_t point, std::span<const double> parameters,
                                         double& residual, std::span<double> gradient)>;

struct FitSettings {
  Loss loss = Loss::none;
  double loss_scale = 1;  ///< residuals beyond it are damped
  /// Residuals are in units of their standard errors: the covariance takes them at their word,
  /// unless the residuals are greater than they say.
  bool known_errors = false;
  std::size_t undamped = 0;  ///< the last so many points are no data (priors, bounds): no loss
  double precision = 1e-16;  ///< relative change of the cost that ends the search
  double step = 1e-15;       ///< relative change of the parameters that ends it
  int iterations = 200;      ///< at most
};

/// Least squares by Ceres (Levenberg-Marquardt, dense QR). Parameters and residuals must be
/// dimensionless and of order one. Digits are -log10 of the largest Gauss-Newton step that remains
/// at the optimum, in units of max(1, |value|), or of rounding times the condition number if that
/// is larger. Usable means: finite, at least 6 digits, condition below 1e12, more points than
/// parameters.
Fit solve_least_squares(const PointResidual& residual, std::size_t points,
                        std::vector<double> start, const FitSettings& settings = {});

}  // namespace mdana
