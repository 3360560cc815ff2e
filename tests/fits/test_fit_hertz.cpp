// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/fits/hertz_data.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::lj_spheres;
using test::si_spheres;
using test::Spheres;

constexpr Spheres all[] = {lj_spheres, si_spheres, test::huge_spheres};
constexpr HertzMethod methods[] = {HertzMethod::force, HertzMethod::linear};

// X is rounded to epsilon, delta = 0.02 R to 100 epsilon: 8 digits are far within reach.
TEST(FitHertz, ExactDataGiveTheirParameters) {
  for (const Spheres& spheres : all)
    for (const HertzMethod method : methods)
      for (const HertzPhase phase : {HertzPhase::loading, HertzPhase::all}) {
        HertzSettings settings;
        settings.method = method;
        settings.phase = phase;
        const HertzFit fit = fit_hertz(spheres.collision(60, 0.02), settings);
        ASSERT_TRUE(fit.fit.usable) << fit.fit.reason;
        EXPECT_NEAR(fit.modulus.value / spheres.modulus, 1, 1e-8) << name(method);
        EXPECT_NEAR(fit.radius.value / spheres.radius, 1, 1e-10) << name(method);
        EXPECT_LE(fit.rms_residual, 1e-10);
        EXPECT_LE(*fit.modulus.error / spheres.modulus, 1e-8);
      }
}

TEST(FitHertz, DimensionsAreThoseOfTheParameters) {
  const HertzFit fit = fit_hertz(lj_spheres.collision(60, 0.02));
  EXPECT_EQ(fit.modulus.dimension, dimension::pressure);
  EXPECT_EQ(fit.radius.dimension, dimension::length);
}

// The fit is made without dimensions: other units give the same bits, scaled.
TEST(FitHertz, UnitsArePowersOfTwoAway) {
  constexpr double l = 0x1p-30, f = 0x1p-45;
  const HertzData data = test::noisy(lj_spheres.collision(60, 0.02), 0.01, 1);
  HertzData scaled = data;
  for (double& x : scaled.distance) x *= l;
  for (double& y : scaled.force) y *= f;
  for (const HertzMethod method : methods) {
    const HertzFit a = fit_hertz(data, {method}), b = fit_hertz(scaled, {method});
    EXPECT_EQ(a.radius.value * l, b.radius.value);
    EXPECT_EQ(a.modulus.value * (f / (l * l)), b.modulus.value);
    EXPECT_EQ(*a.modulus.error * (f / (l * l)), *b.modulus.error);
    EXPECT_EQ(a.correlation, b.correlation);
  }
}

std::vector<std::size_t> expected_points(const HertzData& data, const HertzSettings& s) {
  std::vector<std::size_t> points;
  const double f_max = *std::max_element(data.force.begin(), data.force.end());
  for (std::size_t i = 0; i < data.force.size(); ++i) {
    const double part = data.force[i] / f_max;
    const bool in_phase = s.phase == HertzPhase::all || i <= data.turn;
    if (in_phase && part >= s.min_force_fraction && part <= s.max_force_fraction && part > 0)
      points.push_back(i);
  }
  return points;
}

TEST(FitHertz, ThresholdsSelectThePoints) {
  const HertzData data = lj_spheres.collision(60, 0.02);
  for (const HertzPhase phase : {HertzPhase::loading, HertzPhase::all})
    for (const double least : {0.0, 0.05, 0.301})
      for (const double most : {0.502, 1.0}) {
        const HertzSettings settings{HertzMethod::force, phase, least, most, Loss::none};
        EXPECT_EQ(fit_hertz(data, settings).points, expected_points(data, settings))
            << least << most;
      }
}

TEST(FitHertz, FramesWithoutForceAreNeverFitted) {
  HertzData data = lj_spheres.collision(60, 0.02);
  data.force[0] = -1;
  HertzSettings settings;
  settings.min_force_fraction = 0;
  for (const std::size_t i : fit_hertz(data, settings).points) EXPECT_GT(data.force[i], 0);
}

TEST(FitHertz, TooFewPointsSayHowMany) {
  EXPECT_INPUT_ERROR(fit_hertz({}), "0 frames", "at least 3");
  EXPECT_INPUT_ERROR(fit_hertz({{2, 1.9}, {0, 1}, 1}), "1 frames", "at least 3");
  HertzSettings narrow;
  narrow.min_force_fraction = 0.999;
  EXPECT_INPUT_ERROR(fit_hertz(lj_spheres.collision(60, 0.02), narrow), "between 0.999 and 1",
                     "loading");
}

TEST(FitHertz, EqualDistancesAreAnError) {
  EXPECT_INPUT_ERROR(fit_hertz({{1.9, 1.9, 1.9, 1.9}, {1, 2, 3, 4}, 3}), "same distance");
}

// Nothing of Hertz in the data: whatever comes out must not pass for a result.
TEST(FitHertz, ForceThatFallsWithCompressionIsNotUsable) {
  HertzData data;
  for (int i = 0; i < 30; ++i) {
    data.distance.push_back(10 - 0.01 * i);
    data.force.push_back(1 - 0.02 * i);
  }
  data.turn = 29;
  for (const HertzMethod method : methods) {
    const HertzFit fit = fit_hertz(data, {method});
    EXPECT_FALSE(fit.fit.usable) << name(method) << " E* " << fit.modulus.value << " R "
                                 << fit.radius.value;
    EXPECT_FALSE(fit.fit.reason.empty());
  }
}

TEST(HertzSpread, OfExactDataIsNothing) {
  for (const Spheres& spheres : all) {
    const HertzData data = spheres.collision(60, 0.02);
    const HertzSpread spread = hertz_spread(data, fit_hertz(data));
    EXPECT_EQ(spread.variants.size(), 48u);
    EXPECT_LE(spread.modulus.deviation / spheres.modulus, 1e-8);
    EXPECT_LE(spread.radius.deviation / spheres.radius, 1e-10);
    EXPECT_LE(spread.modulus.least, spread.modulus.greatest);
  }
}

// A law with another exponent: every way to fit it gives other parameters, and the spread shows it.
TEST(HertzSpread, OfAnotherLawIsSeen) {
  HertzData data = lj_spheres.collision(60, 0.02);
  for (double& f : data.force) f = std::pow(f, 1.2);
  const HertzFit chosen = fit_hertz(data);
  const HertzSpread spread = hertz_spread(data, chosen);
  EXPECT_GT(spread.modulus.deviation / chosen.modulus.value, 0.02);
  EXPECT_GT(spread.modulus.deviation, 5 * *chosen.modulus.error);
  EXPECT_LE(spread.modulus.least, chosen.modulus.value);
  EXPECT_GE(spread.modulus.greatest, chosen.modulus.value);
}

}  // namespace
}  // namespace mdana
