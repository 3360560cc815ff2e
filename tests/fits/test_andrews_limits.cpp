// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of Andrews' law and the pairs E*, Y of one delta_max, against the law itself; lines over radii;
// scatter of repeats.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "fits/andrews_limits.hpp"
#include "fits/radius_line.hpp"
#include "fits/repeats.hpp"

namespace mdana {
namespace {

using std::numbers::pi;

/// m* of eq. 29.
Impact aggregate(double reduced_radius, double density, double modulus, double velocity) {
  return {reduced_radius, 16 * pi / 3 * density * std::pow(reduced_radius, 3), modulus, velocity};
}

Collision by_law(const Impact& impact, double strength) {
  return collide(*find_collision_law("andrews"), {impact, {strength}});
}

TEST(AndrewsLimits, AreThePapers) {
  const double R = 1.5e-6, rho = 400, E = 2e6, Y = 3e4, v = 12;
  const Impact impact = aggregate(R, rho, E, v);
  const Compressed elastic = elastic_limit(impact), plastic = rigid_plastic_limit(impact, Y);
  EXPECT_NEAR(elastic.delta_max / (std::pow(5 * pi * rho * v * v / E, 0.4) * R), 1, 1e-14);         // (30)
  EXPECT_NEAR(elastic.t_max / (1.471637592 * elastic.delta_max / v), 1, 1e-9);                     // (32)
  EXPECT_NEAR(plastic.delta_max / (4 * v * std::sqrt(rho / (3 * Y)) * R), 1, 1e-14);               // (31)
  EXPECT_NEAR(plastic.t_max / (2 * pi * R * std::sqrt(rho / (3 * Y))), 1, 1e-14);                  // (33)
}

TEST(AndrewsLimits, AreThoseOfTheLaw) {
  const Impact impact = aggregate(2, 0.3, 5, 0.4);
  EXPECT_NEAR(by_law(impact, 1e4).delta_max, elastic_limit(impact).delta_max, 1e-13);
  EXPECT_NEAR(by_law(impact, 1e4).t_max, elastic_limit(impact).t_max, 1e-12);
  Impact rigid = impact;
  rigid.modulus = 1e8;
  EXPECT_NEAR(by_law(rigid, 0.2).delta_max / rigid_plastic_limit(rigid, 0.2).delta_max, 1, 1e-8);
  EXPECT_NEAR(by_law(rigid, 0.2).t_max / rigid_plastic_limit(rigid, 0.2).t_max, 1, 1e-8);
}

TEST(AndrewsLimits, EveryPairGivesTheDeltaMax) {
  Impact impact = aggregate(10, 1e-3, 0, 0.02);
  const double delta_max = 3.3;
  const auto pairs = degenerate_pairs(impact, delta_max, 21);
  ASSERT_EQ(pairs.size(), 21u);
  EXPECT_EQ(pairs.front().yield_share, 1);
  EXPECT_TRUE(std::isinf(pairs.back().modulus));
  for (std::size_t k = 0; k + 1 < pairs.size(); ++k) {
    impact.modulus = pairs[k].modulus;
    EXPECT_NEAR(by_law(impact, pairs[k].yield_strength).delta_max, delta_max, 1e-12) << k;
    EXPECT_GT(pairs[k].yield_strength, pairs[k + 1].yield_strength);
    EXPECT_LT(pairs[k].modulus, pairs[k + 1].modulus);
  }
  EXPECT_NEAR(rigid_plastic_limit(impact, pairs.back().yield_strength).delta_max, delta_max, 1e-12);
}

TEST(RadiusLine, IsExactOnALine) {
  const std::vector<double> R{20, 25, 30, 40, 50};
  std::vector<double> delta;
  const double k = 0.3125, off = 0.75;  // delta_max - 2 off = k (R - off)
  for (const double r : R) delta.push_back(k * (r - off) + 2 * off);
  for (const std::vector<double>& errors : {std::vector<double>(), {0.1, 0.2, 0.1, 0.3, 0.1}}) {
    const RadiusLine line = fit_radius_line(R, delta, errors);
    EXPECT_NEAR(line.slope.value, k, 1e-15);
    EXPECT_NEAR(line.offset.value, off, 1e-13);
    EXPECT_NEAR(line.intercept.value, (2 - k) * off, 1e-13);
    EXPECT_LT(line.chi2, 1e-20);
  }
  const RadiusLine two = fit_radius_line(std::vector{20.0, 30.0}, std::vector{5.0, 7.0}, {});
  EXPECT_FALSE(two.slope.error || two.offset.error);
  EXPECT_TRUE(std::isnan(two.covariance));
}

// Drawn many times with known errors: the scatter of slope, intercept and offset is what is stated, and so
// is their covariance. 4000 draws know a standard deviation to 1.1 %, here five of that.
TEST(RadiusLine, ErrorsAndCovarianceAreThoseOfManyDraws) {
  const std::vector<double> R{20, 20, 30, 30, 40}, errors{0.1, 0.1, 0.2, 0.2, 0.1};
  std::mt19937_64 random(2);
  std::normal_distribution<double> gauss;
  constexpr int draws = 4000;
  double a = 0, b = 0, ab = 0, o = 0;
  RadiusLine line{};
  for (int k = 0; k < draws; ++k) {
    std::vector<double> delta;
    for (std::size_t i = 0; i < R.size(); ++i) delta.push_back(0.3 * R[i] + 0.5 + errors[i] * gauss(random));
    line = fit_radius_line(R, delta, errors);
    const double da = line.slope.value - 0.3, db = line.intercept.value - 0.5, off = line.offset.value - 0.5 / 1.7;
    a += da * da / draws, b += db * db / draws, ab += da * db / draws, o += off * off / draws;
  }
  const std::vector<double> exact{6.5, 6.5, 9.5, 9.5, 12.5};  // on the line: chi2 is 0, errors as given
  line = fit_radius_line(R, exact, errors);
  EXPECT_NEAR(std::sqrt(a) / *line.slope.error, 1, 0.06);
  EXPECT_NEAR(std::sqrt(b) / *line.intercept.error, 1, 0.06);
  EXPECT_NEAR(std::sqrt(o) / *line.offset.error, 1, 0.06);
  EXPECT_NEAR(ab / line.covariance, 1, 0.12);
}

ObservedCollision seen(double R, double v, double delta, double time) {
  ObservedCollision s;
  s.given = {{"R", R}, {"m", 1}, {"v", v}};
  s.delta_max.value = delta;
  s.t_max.value = time;
  return s;
}

TEST(Repeats, AreFoundWithinTolerances) {
  const std::vector<ObservedCollision> all{seen(20, 5, 1, 1), seen(20.01, 5.01, 1, 1), seen(20, 10, 1, 1),
                                           seen(30, 5, 1, 1), seen(20, 4.99, 1, 1)};
  const auto groups = repeats_of(all);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0], (std::vector<std::size_t>{0, 1, 4}));
}

// Three repeats at one velocity tell the error of all; five tell their own.
TEST(Repeats, ScatterIsTheError) {
  std::vector<ObservedCollision> all{seen(20, 5, 0.9, 1), seen(20, 5, 1.0, 1), seen(20, 5, 1.1, 1), seen(20, 10, 4, 2)};
  all[3].delta_max.error = 0.3;
  EXPECT_FALSE(set_errors_by_repeats(all));  // t_max: no scatter, no errors of its own
  for (const ObservedCollision& s : all) EXPECT_TRUE(std::isnan(s.delta_max.error));
  all[3].delta_max.error = 0.3;
  for (ObservedCollision& s : all) s.t_max.error = 0.5;
  for (const double d : {1.0, 1.5, 2.0, 2.5, 3.0}) all.push_back(seen(30, 5, d, d));
  EXPECT_TRUE(set_errors_by_repeats(all));
  const double pooled = std::sqrt((0.02 + 2.5 / 4) / 6);  // squares 2 0.1^2 about 1, 2.5 about 2
  EXPECT_NEAR(all[0].delta_max.error, pooled, 1e-15);
  EXPECT_NEAR(all[3].delta_max.error, std::hypot(4 * pooled, 0.3), 1e-15);
  EXPECT_NEAR(all[4].delta_max.error, std::sqrt(2.5 / 4), 1e-15);
}

TEST(Repeats, WithoutThemErrorsAreNotKnown) {
  std::vector<ObservedCollision> all{seen(20, 5, 0.9, 1), seen(20, 10, 1.0, 1)};
  all[0].delta_max.error = 0.01;
  EXPECT_FALSE(set_errors_by_repeats(all));
  EXPECT_TRUE(std::isnan(all[0].delta_max.error));
}

}  // namespace
}  // namespace mdana
