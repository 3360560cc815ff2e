// SPDX-License-Identifier: GPL-3.0-or-later
// Hertz fits of noisy data: what the stated errors are worth.
#include <gtest/gtest.h>

#include "tests/fits/hertz_data.hpp"

namespace mdana {
namespace {

constexpr test::Spheres spheres = test::lj_spheres;

/// Mean and mean square over many seeds of (fit - truth)/(stated error), for E* and R.
struct Scores {
  double modulus_mean = 0, modulus_square = 0, radius_mean = 0, radius_square = 0;
  static constexpr int seeds = 400;

  void add(const HertzFit& fit) {
    const double m = (fit.modulus.value - spheres.modulus) / *fit.modulus.error;
    const double r = (fit.radius.value - spheres.radius) / *fit.radius.error;
    modulus_mean += m / seeds;
    modulus_square += m * m / seeds;
    radius_mean += r / seeds;
    radius_square += r * r / seeds;
  }
};

Scores scores(const HertzSettings& settings, double noise, double depth = 0.02) {
  Scores scores;
  const HertzData exact = spheres.collision(100, depth);
  for (std::uint64_t seed = 0; seed < Scores::seeds; ++seed)
    scores.add(fit_hertz(test::noisy(exact, noise, seed), settings));
  return scores;
}

// The method `force` is least squares in the noise itself: scores are of mean 0 and variance 1, to
// 1/sqrt(400) = 0.05 and sqrt(2/400) = 0.07; four of those. But points are chosen by their noisy
// force, which favours forces above the truth at the threshold: R is biased by 0.2 errors. In a
// deep contact the errors of E* and R hang together.
TEST(FitHertzNoise, StandardErrorsAreThoseOfTheScatter) {
  for (const double depth : {0.02, 1.0}) {
    const Scores s = scores({}, 0.01, depth);
    EXPECT_NEAR(s.modulus_mean, 0, 0.3) << depth;
    EXPECT_NEAR(s.radius_mean, 0, 0.3) << depth;
    EXPECT_NEAR(s.modulus_square, 1, 0.3) << depth;
    EXPECT_NEAR(s.radius_square, 1, 0.3) << depth;
  }
}

// `linear` weighs small forces too much and is biased by them, but not by more than its error when
// the smallest are left out.
TEST(FitHertzNoise, LinearMethodIsWithinItsErrors) {
  HertzSettings settings;
  settings.method = HertzMethod::linear;
  settings.min_force_fraction = 0.2;
  const Scores s = scores(settings, 0.003);
  EXPECT_LT(std::abs(s.modulus_mean), 1);
  EXPECT_LT(std::abs(s.radius_mean), 1);
  EXPECT_LT(s.modulus_square, 3);
}

// One point in ten off by a third of the greatest force.
TEST(FitHertzNoise, RobustLossWithstandsOutliers) {
  HertzData data = test::noisy(spheres.collision(100, 0.02), 0.003, 1);
  const double f_max = *std::max_element(data.force.begin(), data.force.end());
  for (std::size_t i = 60; i < 100; i += 10) data.force[i] -= 0.35 * f_max;
  HertzSettings settings;
  const double plain = fit_hertz(data, settings).modulus.value;
  settings.loss = Loss::cauchy;
  const double cauchy = fit_hertz(data, settings).modulus.value;
  settings.loss = Loss::huber;
  const double huber = fit_hertz(data, settings).modulus.value;
  EXPECT_GT(std::abs(plain / spheres.modulus - 1), 0.05);
  EXPECT_LT(std::abs(huber / spheres.modulus - 1), 0.4 * std::abs(plain / spheres.modulus - 1));
  EXPECT_LT(std::abs(cauchy / spheres.modulus - 1), 0.02);
}

TEST(FitHertzNoise, MorePointsAreBetterKnown) {
  const HertzFit few = fit_hertz(test::noisy(spheres.collision(50, 0.02), 0.01, 3));
  const HertzFit many = fit_hertz(test::noisy(spheres.collision(5000, 0.02), 0.01, 3));
  EXPECT_NEAR(*few.modulus.error / *many.modulus.error, 10,
              3);  // sqrt(100); the error's own scatter
  EXPECT_NEAR(many.rms_residual, 0.01, 1e-3);
}

}  // namespace
}  // namespace mdana
