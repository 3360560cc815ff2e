// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include <gtest/gtest.h>

#include "analyses/force_series.hpp"
#include "tests/analyses/collision.hpp"

namespace mdana {
namespace {

constexpr double mass = 3, radii = 20;

/// delta = sin(omega t): the force is -m* omega^2 sin(omega t).
RelativeMotion oscillation(double omega, double step, std::size_t frames = 200) {
  return test::head_on(test::even_times(0, step * static_cast<double>(frames), step),
                       [=](double t) -> test::Approach {
                         return {std::sin(omega * t), omega * std::cos(omega * t),
                                 -omega * omega * std::sin(omega * t)};
                       },
                       radii, mass);
}

double exact(const RelativeMotion& motion, double omega, std::size_t i) {
  return mass * omega * omega * std::sin(omega * motion.times[i]);
}

/// Share of the frames, away from the ends, whose error is within `widths` stated ones.
double covered(const RelativeMotion& motion, const ForceSeries& series, double omega, double widths) {
  const double rounding = 1e-9 * mass * omega * omega;
  std::size_t within = 0, all = 0;
  for (std::size_t i = 10; i + 10 < series.value.size(); ++i, ++all)
    within += std::abs(series.value[i] - exact(motion, omega, i)) <=
              widths * series.error(i) + rounding;
  return static_cast<double>(within) / static_cast<double>(all);
}

TEST(ForceSeries, TruncationIsCoveredFromFineToCoarseSampling) {
  for (const double step : {0.05, 0.1, 0.2, 0.4, 0.8, 1.2})
    for (const ForceSource source : {ForceSource::velocities, ForceSource::positions}) {
      const RelativeMotion motion = oscillation(1, step);
      const ForceSeries series = force_series(motion, source, Units::lj);
      EXPECT_EQ(series.window, 5);
      EXPECT_GT(covered(motion, series, 1, 2), 0.95) << step << " " << name(source);
    }
}

// Where sampling resolves the oscillation the estimate is no more than a few times too large.
TEST(ForceSeries, TruncationIsNotFarTooLarge) {
  const RelativeMotion motion = oscillation(1, 0.2);
  const ForceSeries series = force_series(motion, ForceSource::velocities, Units::lj);
  EXPECT_GT(series.order, 3.5);
  double stated = 0, true_error = 0;
  for (std::size_t i = 10; i + 10 < series.value.size(); ++i) {
    stated += series.truncation[i] * series.truncation[i];
    true_error += std::pow(series.value[i] - exact(motion, 1, i), 2);
  }
  EXPECT_LT(std::sqrt(stated / true_error), 2);
  EXPECT_GT(std::sqrt(stated / true_error), 0.7);
}

/// Velocities rounded to a step, as printed digits do.
RelativeMotion rounded(RelativeMotion motion, double step) {
  for (double& component : motion.velocity.reshaped()) component = std::round(component / step) * step;
  motion.velocity_noise = step / std::sqrt(12.0);
  return motion;
}

TEST(ForceSeries, NoiseOfDigitsLengthensTheWindowAndIsCovered) {
  const RelativeMotion fine = oscillation(0.2, 0.1, 400);
  const RelativeMotion coarse = rounded(fine, 1e-3);
  const ForceSeries a = force_series(fine, ForceSource::velocities, Units::lj);
  const ForceSeries b = force_series(coarse, ForceSource::velocities, Units::lj);
  EXPECT_EQ(a.window, 5);
  EXPECT_GT(b.window, 9);
  EXPECT_GT(covered(coarse, b, 0.2, 3), 0.9);
  const std::vector<double> five = interparticle_force(coarse, ForceSource::velocities, Units::lj, {5});
  double error_of_five = 0, error_of_best = 0;
  for (std::size_t i = 10; i + 10 < five.size(); ++i) {
    error_of_five += std::pow(five[i] - exact(coarse, 0.2, i), 2);
    error_of_best += std::pow(b.value[i] - exact(coarse, 0.2, i), 2);
  }
  EXPECT_LT(error_of_best, 0.2 * error_of_five);
}

TEST(NoiseOf, IsThatOfIndependentNumbersOnASmoothCurve) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal(0, 0.25);
  std::vector<double> series, smooth;
  for (int i = 0; i < 4000; ++i) {
    smooth.push_back(10 * std::sin(0.05 * i));
    series.push_back(smooth.back() + normal(random));
  }
  EXPECT_NEAR(noise_of(series), 0.25, 0.025);  // least of three estimates, each within 3 %
  EXPECT_LT(noise_of(smooth), 1e-6);
  EXPECT_EQ(noise_of({1, 2, 3}), 0);
}

}  // namespace
}  // namespace mdana
