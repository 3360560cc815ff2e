// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "fits/fit.hpp"

namespace mdana {
namespace {

struct LinearProblem {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;

  PointResidual residual() const {
    return [this](std::size_t i, std::span<const double> p, double& r, std::span<double> g) {
      const auto row = static_cast<Eigen::Index>(i);
      r = -right[row];
      for (std::size_t k = 0; k < p.size(); ++k) {
        const double slope = matrix(row, static_cast<Eigen::Index>(k));
        if (!g.empty()) g[k] = slope;
        r += slope * p[k];
      }
      return true;
    };
  }
  Fit solve(const FitSettings& settings = {}) const {
    return solve_least_squares(residual(), static_cast<std::size_t>(matrix.rows()),
                               std::vector<double>(static_cast<std::size_t>(matrix.cols()), 0.5),
                               settings);
  }
};

LinearProblem random_problem(Eigen::Index points, Eigen::Index parameters) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  LinearProblem problem{Eigen::MatrixXd(points, parameters), Eigen::VectorXd(points)};
  for (Eigen::Index i = 0; i < points; ++i) {
    for (Eigen::Index k = 0; k < parameters; ++k) problem.matrix(i, k) = normal(random);
    problem.right[i] = normal(random);
  }
  return problem;
}

TEST(LeastSquares, LinearProblemAgreesWithEigen) {
  const LinearProblem problem = random_problem(40, 3);
  const Fit fit = problem.solve();
  const Eigen::VectorXd exact = problem.matrix.householderQr().solve(problem.right);
  const Eigen::VectorXd residual = problem.matrix * exact - problem.right;
  const Eigen::MatrixXd covariance =
      residual.squaredNorm() / (40 - 3) * (problem.matrix.transpose() * problem.matrix).inverse();
  ASSERT_TRUE(fit.usable) << fit.reason;
  EXPECT_GE(fit.digits, 8);
  for (Eigen::Index k = 0; k < 3; ++k)
    EXPECT_NEAR(fit.values[static_cast<std::size_t>(k)], exact[k], 1e-8);
  EXPECT_LE((fit.covariance - covariance).norm(), 1e-10 * covariance.norm());
  for (Eigen::Index i = 0; i < 40; ++i)
    EXPECT_NEAR(fit.residuals[static_cast<std::size_t>(i)], residual[i], 1e-7);
  const Eigen::VectorXd s = problem.matrix.jacobiSvd().singularValues();
  EXPECT_NEAR(fit.condition, s[0] / s[2], 1e-9 * fit.condition);
}

// Rosenbrock's valley as three residuals, 10 (y - x^2), 1 - x and (1 - y)/100: optimum (1, 1).
TEST(LeastSquares, CurvedValley) {
  const PointResidual rosenbrock = [](std::size_t i, std::span<const double> p, double& r,
                                      std::span<double> g) {
    std::array<double, 2> unwanted{};
    if (g.empty()) g = unwanted;
    if (i == 0) r = 10 * (p[1] - p[0] * p[0]), g[0] = -20 * p[0], g[1] = 10;
    if (i == 1) r = 1 - p[0], g[0] = -1, g[1] = 0;
    if (i == 2) r = 0.01 * (1 - p[1]), g[0] = 0, g[1] = -0.01;
    return true;
  };
  const Fit fit = solve_least_squares(rosenbrock, 3, {-1.2, 1});
  ASSERT_TRUE(fit.usable) << fit.reason;
  EXPECT_NEAR(fit.values[0], 1, 1e-8);
  EXPECT_NEAR(fit.values[1], 1, 1e-8);
  EXPECT_GT(fit.iterations, 1);
}

TEST(LeastSquares, SingularProblemIsNotUsable) {
  LinearProblem problem = random_problem(20, 3);
  problem.matrix.col(2) = problem.matrix.col(0) - 2 * problem.matrix.col(1);
  const Fit fit = problem.solve();
  EXPECT_FALSE(fit.usable);
  EXPECT_FALSE(fit.reason.empty());
  problem.matrix.col(2).setZero();
  EXPECT_FALSE(problem.solve().usable);
  EXPECT_FALSE(problem.solve().reason.empty());
}

TEST(LeastSquares, NoMorePointsThanParametersIsNotUsable) {
  for (const Eigen::Index points : {2, 3}) {
    const Fit fit = random_problem(points, 3).solve();
    EXPECT_FALSE(fit.usable) << points;
    EXPECT_FALSE(fit.reason.empty());
  }
}

TEST(LeastSquares, UndefinedResidualIsNotUsable) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const bool defined : {true, false}) {
    const PointResidual residual = [&](std::size_t, std::span<const double>, double& r,
                                       std::span<double> g) {
      r = nan;
      if (!g.empty()) g[0] = nan;
      return defined;
    };
    const Fit fit = solve_least_squares(residual, 5, {1});
    EXPECT_FALSE(fit.usable);
    EXPECT_FALSE(fit.reason.empty());
  }
}

// A point far from the optimum from which no step leads on: the solver stops, the fit must say so.
TEST(LeastSquares, StuckSolverIsNotUsable) {
  const PointResidual lying = [](std::size_t i, std::span<const double> p, double& r,
                                 std::span<double> g) {
    r = std::abs(p[0] - 3 + 1e-3 * static_cast<double>(i)) + 1;
    if (!g.empty()) g[0] = 1;  // wrong sign on one side
    return true;
  };
  const Fit fit = solve_least_squares(lying, 5, {0});
  EXPECT_FALSE(fit.usable) << fit.digits;
}

// A line with a tenth of wild points: the robust losses find it, plain least squares does not.
TEST(LeastSquares, RobustLossesWithstandOutliers) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> noise(0, 0.01);
  LinearProblem problem{Eigen::MatrixXd(200, 2), Eigen::VectorXd(200)};
  for (Eigen::Index i = 0; i < 200; ++i) {
    const double x = static_cast<double>(i) / 200;
    problem.matrix.row(i) << 1, x;
    problem.right[i] = 0.3 + 2 * x + noise(random) + (i % 10 == 3 ? 5.0 : 0.0);
  }
  const Fit plain = problem.solve();
  const Fit huber = problem.solve({Loss::huber, 0.01}),
            cauchy = problem.solve({Loss::cauchy, 0.01});
  EXPECT_GT(std::abs(plain.values[0] - 0.3), 0.2);
  EXPECT_TRUE(huber.usable) << huber.reason;
  EXPECT_TRUE(cauchy.usable) << cauchy.reason;
  // outliers pull a Huber fit by 10 % of its scale each way; 0.01 is one standard deviation
  EXPECT_NEAR(huber.values[0], 0.3, 0.01);
  EXPECT_NEAR(huber.values[1], 2, 0.02);
  EXPECT_NEAR(cauchy.values[0], 0.3, 0.01);
  EXPECT_NEAR(cauchy.values[1], 2, 0.02);
}

TEST(LeastSquares, StandardErrorsAreThoseOfTheScatter) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> noise(0, 0.1);
  double square = 0;
  constexpr int runs = 400;
  for (int run = 0; run < runs; ++run) {
    LinearProblem problem = random_problem(50, 2);
    for (Eigen::Index i = 0; i < 50; ++i)
      problem.right[i] = problem.matrix(i, 0) - 0.5 * problem.matrix(i, 1) + noise(random);
    const Fit fit = problem.solve();
    square += (fit.values[0] - 1) * (fit.values[0] - 1) / fit.covariance(0, 0) / runs;
  }
  // Student's t with 48 degrees: mean square 48/46; its scatter over 400 runs is sqrt(2/400) =
  // 0.07.
  EXPECT_NEAR(square, 48.0 / 46.0, 4 * 0.075);
}

}  // namespace
}  // namespace mdana
