// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/derivative.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/QR>

namespace mdana {
namespace {

/// Weights w with derivative = sum of w_j * sample_j, for samples at times[first ...] seen from t.
/// Times are scaled to order one before the fit.
Eigen::VectorXd weights(std::span<const double> times, double t, const DerivativeRule& rule) {
  const auto n = static_cast<Eigen::Index>(times.size());
  const double scale = times.back() - times.front();
  Eigen::MatrixXd powers(n, rule.degree + 1);
  for (Eigen::Index j = 0; j < n; ++j) {
    double power = 1;
    for (int k = 0; k <= rule.degree; ++k, power *= (times[static_cast<std::size_t>(j)] - t) / scale)
      powers(j, k) = power;
  }
  const Eigen::MatrixXd inverse =
      powers.householderQr().solve(Eigen::MatrixXd::Identity(n, n));  // coefficients of samples
  const double factorial = rule.order == 2 ? 2.0 : 1.0;
  return inverse.row(rule.order).transpose() * (factorial / std::pow(scale, rule.order));
}

}  // namespace

Eigen::MatrixXd derivative(std::span<const double> times, const Eigen::MatrixXd& samples,
                           const DerivativeRule& rule) {
  const auto n = static_cast<std::ptrdiff_t>(times.size());
  if (n <= rule.degree) throw std::invalid_argument("derivative: fewer samples than degree + 1");
  const std::ptrdiff_t window = std::min<std::ptrdiff_t>(rule.window, n);
  Eigen::MatrixXd result(samples.rows(), samples.cols());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const std::ptrdiff_t first = std::clamp<std::ptrdiff_t>(i - window / 2, 0, n - window);
    const Eigen::VectorXd w =
        weights(times.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(window)),
                times[static_cast<std::size_t>(i)], rule);
    result.col(i) = samples.middleCols(first, window) * w;
  }
  return result;
}

}  // namespace mdana
