// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "analyses/derivative.hpp"

namespace mdana {
namespace {

/// 1 - 2t + 3t^2 ... with derivatives.
double polynomial(double t, int degree, int order) {
  double value = 0;
  for (int k = degree; k >= order; --k) {
    double factor = k % 2 ? -(k + 1.0) : k + 1.0;
    for (int j = 0; j < order; ++j) factor *= k - j;
    value += factor * std::pow(t, k - order);
  }
  return value;
}

std::vector<double> uneven_times(std::size_t n, double start, double step) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> jitter(0.6, 1.4);
  std::vector<double> times{start};
  while (times.size() < n) times.push_back(times.back() + step * jitter(random));
  return times;
}

Eigen::MatrixXd sampled(const std::vector<double>& times, auto&& f) {
  Eigen::MatrixXd samples(1, static_cast<Eigen::Index>(times.size()));
  for (std::size_t i = 0; i < times.size(); ++i)
    samples(0, static_cast<Eigen::Index>(i)) = f(times[i]);
  return samples;
}

// Values and derivatives are of order 100; the weights of a second derivative at steps of 0.1
// amplify rounding by some 1e3: 1e-16 * 1e2 * 1e3 = 1e-11, with room 1e-9.
TEST(Derivative, IsExactForPolynomials) {
  const auto times = uneven_times(12, -0.5, 0.1);
  for (const DerivativeRule rule :
       {DerivativeRule{1, 4, 5}, {2, 4, 5}, {1, 2, 5}, {2, 3, 9}, {1, 1, 3}})
    for (int degree = 0; degree <= rule.degree; ++degree) {
      const auto samples = sampled(times, [&](double t) { return polynomial(t, degree, 0); });
      const auto result = derivative(times, samples, rule);
      for (std::size_t i = 0; i < times.size(); ++i)
        EXPECT_NEAR(result(0, static_cast<Eigen::Index>(i)),
                    polynomial(times[i], degree, rule.order), 1e-9)
            << rule.order << " " << rule.degree << " " << degree;
    }
}

/// Largest error of the derivative of sin at all samples, at the ends too.
double error(const DerivativeRule& rule, double step, bool ends) {
  std::vector<double> times;
  for (double t = 0; t < 1.5; t += step) times.push_back(t);
  const auto result =
      derivative(times, sampled(times, [](double t) { return std::sin(t + 0.3); }), rule);
  double worst = 0;
  const std::size_t margin = ends ? 0 : 3;
  for (std::size_t i = margin; i + margin < times.size(); ++i) {
    const double exact = rule.order == 1 ? std::cos(times[i] + 0.3) : -std::sin(times[i] + 0.3);
    worst = std::max(worst, std::abs(result(0, static_cast<Eigen::Index>(i)) - exact));
  }
  return worst;
}

// Five points: fourth order, but third for the second derivative off the centre of the window.
TEST(Derivative, ConvergesWithItsOrder) {
  const DerivativeRule first{1, 4, 5}, second{2, 4, 5};
  EXPECT_NEAR(std::log2(error(first, 0.04, false) / error(first, 0.02, false)), 4, 0.1);
  EXPECT_NEAR(std::log2(error(first, 0.04, true) / error(first, 0.02, true)), 4, 0.2);
  EXPECT_NEAR(std::log2(error(second, 0.04, false) / error(second, 0.02, false)), 4, 0.1);
  EXPECT_NEAR(std::log2(error(second, 0.04, true) / error(second, 0.02, true)), 3, 0.2);
}

// Times as large as those of a long run: only their differences count.
TEST(Derivative, StartOfTheClockDoesNotMatter) {
  std::vector<double> times, later;
  for (int i = 0; i < 9; ++i) {
    times.push_back(0.25 * i);
    later.push_back(0x1p40 + 0.25 * i);
  }
  const auto samples = sampled(times, [](double t) { return std::exp(t); });
  EXPECT_EQ(derivative(times, samples, {2, 4, 5}), derivative(later, samples, {2, 4, 5}));
}

TEST(Derivative, ScalesWithPowersOfTwo) {
  const auto times = uneven_times(9, 3, 0.1);
  std::vector<double> scaled;
  for (const double t : times) scaled.push_back(t * 0x1p-40);
  const auto samples = sampled(times, [](double t) { return std::sin(t); });
  for (const int order : {1, 2})
    EXPECT_EQ((derivative(times, samples, {order, 4, 5}) * std::pow(0x1p40, order)).eval(),
              derivative(scaled, samples, {order, 4, 5}));
}

TEST(Derivative, EachRowByItself) {
  const auto times = uneven_times(7, 0, 1);
  Eigen::MatrixXd samples(2, 7);
  samples.row(0) = sampled(times, [](double t) { return t * t; });
  samples.row(1) = sampled(times, [](double t) { return std::cos(t); });
  const auto both = derivative(times, samples, {1, 4, 5});
  EXPECT_EQ(both.row(0).eval(), derivative(times, samples.row(0), {1, 4, 5}));
  EXPECT_EQ(both.row(1).eval(), derivative(times, samples.row(1), {1, 4, 5}));
}

TEST(Derivative, NeedsMoreSamplesThanItsDegree) {
  const auto times = uneven_times(4, 0, 1);
  const auto samples = sampled(times, [](double t) { return t * t * t; });
  EXPECT_THROW(derivative(times, samples, {1, 4, 5}), std::invalid_argument);
  // a window longer than the series is shortened: 4 samples still give a cubic
  EXPECT_NEAR(derivative(times, samples, {1, 3, 7})(0, 2), 3 * times[2] * times[2], 1e-11);
}

}  // namespace
}  // namespace mdana
