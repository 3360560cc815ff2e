// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace mdana {

/// First or second derivative of samples at any increasing times: at each sample, of the polynomial
/// fitted by least squares (Eigen QR) to the `window` nearest samples (Savitzky & Golay 1964 for
/// uneven steps; exact for polynomials up to `degree`). At the ends the window is one-sided.
struct DerivativeRule {
  int order = 1;   ///< 1 or 2
  int degree = 4;  ///< at least order
  int window = 5;  ///< samples, odd, more than degree
};

/// Derivatives of each row of `samples` (one column a time). Throws std::invalid_argument if there
/// are fewer samples than degree + 1; a window longer than the series is shortened to it.
Eigen::MatrixXd derivative(std::span<const double> times, const Eigen::MatrixXd& samples,
                           const DerivativeRule& rule);

}  // namespace mdana
