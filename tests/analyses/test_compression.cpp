// SPDX-License-Identifier: GPL-3.0-or-later
// delta_max and t_max between frames, against motions in closed form.
#include <random>

#include <gtest/gtest.h>

#include "analyses/compression.hpp"
#include "tests/analyses/collision.hpp"

namespace mdana {
namespace {

using std::numbers::pi;

constexpr double radius_sum = 20;

ApproachSeries series_of(const test::Path& path, const std::vector<double>& times) {
  ApproachSeries series{times, {}, {}, 0, 0};
  for (const double t : times) {
    series.distance.push_back(radius_sum - path(t).delta);
    series.speed.push_back(path(t).speed);
  }
  return series;
}

// A cubic through both ends of an interval is right to h^4/384 of the fourth derivative, omega^4 delta_max;
// a straight line between two values of cos omega t about its zero to omega^2 h^3/62. Here with room.
TEST(MaximumCompression, LiesBetweenFrames) {
  const double v = 0.3, omega = 0.7;
  for (const double h : {0.5, 0.1, 0.02})
    for (const double phase : {0.0, 0.3, 0.77}) {
      const auto series = series_of(test::elastic_bounce(v, omega), test::even_times(-3.1 - phase * h, 8, h));
      const MaximumCompression m = maximum_compression(series, radius_sum);
      const double x = omega * h;
      EXPECT_NEAR(m.delta.value, v / omega, v / omega * (x * x * x * x / 200 + 1e-14));
      EXPECT_NEAR(m.time.value, pi / 2 / omega, (x * x * x / 50 + 1e-13) / omega);
      EXPECT_NEAR(m.contact_time, 0, x * x * x / 50 / omega + 1e-13);
      EXPECT_TRUE(test::covers(m.delta, v / omega, 1));
      EXPECT_TRUE(test::covers(m.time, pi / 2 / omega, 1));
      EXPECT_TRUE(m.delta_reason.empty() && m.time_reason.empty());
    }
}

TEST(MaximumCompression, OfAnotherReturnThanLoading) {
  const auto path = test::plastic_bounce(0.3, 0.7, 2.1);
  const MaximumCompression m = maximum_compression(series_of(path, test::even_times(-2, 6, 0.0213)), radius_sum);
  EXPECT_NEAR(m.delta.value, 0.3 / 0.7, 1e-8);
  EXPECT_NEAR(m.time.value, pi / 2 / 0.7, 1e-6);
  EXPECT_TRUE(test::covers(m.time, pi / 2 / 0.7, 1));
}

TEST(MaximumCompression, OffsetMovesTheTimeOfContact) {
  const double v = 0.3, omega = 0.7, off = 0.05;
  const auto series = series_of(test::elastic_bounce(v, omega), test::even_times(-3, 8, 0.02));
  const MaximumCompression m = maximum_compression(series, radius_sum - 2 * off);
  EXPECT_NEAR(m.delta.value, v / omega - 2 * off, 1e-8);
  EXPECT_NEAR(m.time.value, (pi / 2 - std::asin(2 * off * omega / v)) / omega, 1e-6);
}

// Noise of v and X of known size: the errors cover in about two of three, and no more than three of them
// are needed.
TEST(MaximumCompression, ErrorsHoldWithNoise) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> gauss;
  int covered = 0, far = 0;
  constexpr int trials = 200;
  for (int k = 0; k < trials; ++k) {
    auto series = series_of(test::elastic_bounce(0.3, 0.7), test::even_times(-3, 8, 0.02));
    for (double& x : series.distance) x += 1e-5 * gauss(random);
    for (double& v : series.speed) v += 1e-5 * gauss(random);
    const MaximumCompression m = maximum_compression(series, radius_sum);
    const double off = std::abs(m.time.value - pi / 2 / 0.7);
    covered += off <= *m.time.error;
    far += off > 4 * *m.time.error;
    EXPECT_LT(*m.time.error, 5e-4);
    EXPECT_LT(std::abs(m.delta.value - 0.3 / 0.7), 4 * *m.delta.error);
  }
  EXPECT_GT(covered, 0.6 * trials);
  EXPECT_LE(far, 0.02 * trials);
}

TEST(MaximumCompression, IsNotKnownWithoutATurn) {
  const auto path = test::elastic_bounce(0.3, 0.7);
  const MaximumCompression early = maximum_compression(series_of(path, test::even_times(-3, 2, 0.1)), radius_sum);
  EXPECT_TRUE(std::isnan(early.delta.value));
  EXPECT_NE(early.delta_reason.find("the dump ends before"), std::string::npos);
  const MaximumCompression late = maximum_compression(series_of(path, test::even_times(0.5, 6, 0.1)), radius_sum);
  EXPECT_NEAR(late.delta.value, 0.3 / 0.7, 1e-5);
  EXPECT_TRUE(std::isnan(late.time.value));
  EXPECT_NE(late.time_reason.find("begins in contact"), std::string::npos);
  const MaximumCompression apart = maximum_compression(series_of(path, test::even_times(-3, 6, 0.1)), radius_sum - 1);
  EXPECT_NE(apart.delta_reason.find("never come nearer"), std::string::npos);
  EXPECT_NE(maximum_compression({}, 1).delta_reason.find("time between frames"), std::string::npos);
}

// A first touch and, after more time apart, a deeper one: the first maximum counts.
TEST(MaximumCompression, IsTheFirst) {
  ApproachSeries series;
  for (int i = 0; i < 200; ++i) {
    const double t = 0.05 * i;
    series.times.push_back(t);
    series.distance.push_back(radius_sum - (std::sin(t) * (1 + 0.1 * t) - 0.2));
    series.speed.push_back(std::cos(t) * (1 + 0.1 * t) + 0.1 * std::sin(t));
  }
  EXPECT_NEAR(maximum_compression(series, radius_sum).turn_time, 1.657, 0.01);
}

}  // namespace
}  // namespace mdana
