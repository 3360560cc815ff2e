// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/fit.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include <Eigen/SVD>
#include <ceres/ceres.h>
#include <fmt/format.h>
#include <glog/logging.h>

namespace mdana {
namespace {

constexpr double least_digits = 6;
constexpr double worst_condition = 1e12;

/// A step that a residual cannot take is no news: the optimum itself is assessed.
void silence_ceres() {
  static const bool once = [] {
    FLAGS_minloglevel = google::GLOG_FATAL;
    return true;
  }();
  (void)once;
}

/// One data point as a Ceres cost function.
class PointCost final : public ceres::CostFunction {
 public:
  PointCost(const PointResidual& residual, std::size_t point, int parameters)
      : residual_(residual), point_(point) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(parameters);
  }

  bool Evaluate(double const* const* parameters, double* residual,
                double** jacobian) const override {
    const auto n = static_cast<std::size_t>(parameter_block_sizes()[0]);
    std::vector<double> gradient(jacobian && jacobian[0] ? n : 0);
    if (!residual_(point_, {parameters[0], n}, *residual, gradient)) return false;
    if (!gradient.empty()) std::copy(gradient.begin(), gradient.end(), jacobian[0]);
    return true;
  }

 private:
  const PointResidual& residual_;
  std::size_t point_;
};

std::unique_ptr<ceres::LossFunction> make_loss(const FitSettings& settings) {
  switch (settings.loss) {
    case Loss::none: break;
    case Loss::huber: return std::make_unique<ceres::HuberLoss>(settings.loss_scale);
    case Loss::cauchy: return std::make_unique<ceres::CauchyLoss>(settings.loss_scale);
  }
  return nullptr;
}

ceres::Solver::Options solver_options(const FitSettings& settings) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.minimizer_type = ceres::TRUST_REGION;
  options.max_num_iterations = settings.iterations;
  options.function_tolerance = settings.precision;
  options.gradient_tolerance = 1e-16;
  options.parameter_tolerance = settings.step;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  return options;
}

/// Residuals and Jacobian at the optimum, rows scaled by the square root of the loss's weight.
struct Linearised {
  Eigen::VectorXd raw, weighted;
  Eigen::MatrixXd jacobian;
};

Linearised linearise(const PointResidual& residual, std::size_t points, std::size_t damped,
                     const std::vector<double>& values, const ceres::LossFunction* loss) {
  const auto m = static_cast<Eigen::Index>(points);
  const auto n = static_cast<Eigen::Index>(values.size());
  Linearised at{Eigen::VectorXd(m), Eigen::VectorXd(m), Eigen::MatrixXd(m, n)};
  std::vector<double> gradient(values.size());
  for (Eigen::Index i = 0; i < m; ++i) {
    double r = std::numeric_limits<double>::quiet_NaN();
    residual(static_cast<std::size_t>(i), values, r, gradient);
    std::array<double, 3> rho{r * r, 1, 0};
    if (loss && static_cast<std::size_t>(i) < damped) loss->Evaluate(r * r, rho.data());
    const double weight = std::sqrt(rho[1]);
    at.raw[i] = r;
    at.weighted[i] = weight * r;
    for (Eigen::Index j = 0; j < n; ++j)
      at.jacobian(i, j) = weight * gradient[static_cast<std::size_t>(j)];
  }
  return at;
}

double correct_digits(const Eigen::VectorXd& step, const std::vector<double>& values,
                      double condition) {
  double error = std::numeric_limits<double>::epsilon() * condition;
  for (std::size_t i = 0; i < values.size(); ++i)
    error = std::max(error, std::abs(step[static_cast<Eigen::Index>(i)]) /
                                std::max(1.0, std::abs(values[i])));
  return std::isfinite(error) ? -std::log10(error) : 0;
}

void judge(Fit& fit, std::size_t points) {
  const auto finite = [](double v) { return std::isfinite(v); };
  if (!std::all_of(fit.values.begin(), fit.values.end(), finite) || !fit.covariance.allFinite())
    fit.reason = "the optimum is not finite";
  else if (points <= fit.values.size())
    fit.reason = "no more points than parameters";
  else if (!(fit.condition < worst_condition))
    fit.reason = fmt::format("the data do not determine the parameters (condition {:.1e})",
                             fit.condition);
  else if (fit.digits < least_digits)
    fit.reason = fmt::format("the optimum is known to {:.1f} digits only", fit.digits);
  fit.usable = fit.reason.empty();
}

void assess(Fit& fit, const Linearised& at, bool known_errors) {
  fit.residuals.assign(at.raw.begin(), at.raw.end());
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(at.jacobian,
                                              Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& s = svd.singularValues();
  fit.singular_values.assign(s.begin(), s.end());
  fit.condition = s[0] / s[s.size() - 1];
  const Eigen::VectorXd inverse = s.cwiseInverse();
  const Eigen::VectorXd step =
      svd.matrixV() * inverse.cwiseProduct(svd.matrixU().transpose() * at.weighted);
  fit.digits = correct_digits(step, fit.values, fit.condition);
  const auto freedom = static_cast<double>(at.jacobian.rows() - at.jacobian.cols());
  const double residual_variance = at.weighted.squaredNorm() / std::max(1.0, freedom);
  const double variance = known_errors ? std::max(1.0, residual_variance) : residual_variance;
  const Eigen::MatrixXd half = svd.matrixV() * inverse.asDiagonal();
  fit.covariance = variance * half * half.transpose();
}

}  // namespace

std::string_view name(Loss loss) {
  constexpr std::array<std::string_view, 3> names{"none", "huber", "cauchy"};
  return names[static_cast<std::size_t>(loss)];
}

Fit solve_least_squares(const PointResidual& residual, std::size_t points,
                        std::vector<double> start, const FitSettings& settings) {
  silence_ceres();
  const auto begin = std::chrono::steady_clock::now();
  Fit fit;
  fit.values = std::move(start);
  const auto loss = make_loss(settings);
  const std::size_t damped = points - std::min(points, settings.undamped);
  {
    ceres::Problem::Options options;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(options);
    for (std::size_t i = 0; i < points; ++i)
      problem.AddResidualBlock(
          new PointCost(residual, i, static_cast<int>(fit.values.size())),
          i < damped ? loss.get() : nullptr,
          fit.values.data());
    ceres::Solver::Summary summary;
    ceres::Solve(solver_options(settings), &problem, &summary);
    fit.iterations = static_cast<int>(summary.iterations.size());
  }
  assess(fit, linearise(residual, points, damped, fit.values, loss.get()), settings.known_errors);
  judge(fit, points);
  fit.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return fit;
}

}  // namespace mdana
