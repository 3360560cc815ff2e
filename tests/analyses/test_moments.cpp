// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "analyses/moments.hpp"

namespace mdana {
namespace {

struct Point {
  double weight;
  Eigen::Vector3d at;
};

/// Points whose components are multiples of 2^-20 below one, so that they stay exact on a drift of
/// up to 2^32.
std::vector<Point> points(std::size_t count) {
  std::mt19937_64 random(5);
  std::vector<Point> made(count);
  for (Point& p : made) {
    p.weight = static_cast<double>(random() % 7 + 1);
    for (int k = 0; k < 3; ++k) p.at[k] = static_cast<double>(random() % 2'000'001) * 0x1p-20 - 1;
  }
  return made;
}

Moments<3> one(const Point& p, const Eigen::Vector3d& drift) {
  return {1, p.weight, p.at + drift, 0};
}

Moments<3> sum_of(const std::vector<Point>& all, const Eigen::Vector3d& drift) {
  Moments<3> sum;
  for (const Point& p : all) sum.merge(one(p, drift));
  return sum;
}

/// The definition in twice the precision.
double exact_spread(const std::vector<Point>& all) {
  using Long = Eigen::Matrix<long double, 3, 1>;
  Long mean = Long::Zero();
  long double weight = 0, spread = 0;
  for (const Point& p : all) {
    weight += p.weight;
    mean += p.weight * p.at.cast<long double>();
  }
  mean /= weight;
  for (const Point& p : all) spread += p.weight * (p.at.cast<long double>() - mean).squaredNorm();
  return static_cast<double>(spread);
}

TEST(Moments, FollowTheDefinition) {
  const auto all = points(1000);
  const Moments<3> sum = sum_of(all, {0, 0, 0});
  EXPECT_EQ(sum.count, 1000u);
  EXPECT_EQ(sum.weight, std::accumulate(all.begin(), all.end(), 0.0,
                                        [](double w, const Point& p) { return w + p.weight; }));
  EXPECT_NEAR(sum.spread / exact_spread(all), 1, 1e-13);  // 1000 additions
}

// Each merge rounds the mean to epsilon * drift = 2e-9 here; the spread feels that only by the
// product with the points' distance from the mean, 1e-9 relative at worst. Mean square minus
// squared mean would lose all of its 16 digits: (1e7)^2 * epsilon = 0.02.
TEST(Moments, KeepThermalPartsOnADriftOf1e7) {
  const auto all = points(1000);
  const Moments<3> drifting = sum_of(all, {1e7, -3e7, 2e7});
  EXPECT_NEAR(drifting.spread / exact_spread(all), 1, 1e-8);
  EXPECT_NEAR(drifting.mean.x() - 1e7, sum_of(all, {0, 0, 0}).mean.x(), 1e-8);
}

TEST(Moments, MergeInAnyOrder) {
  const auto all = points(1000);
  const Moments<3> whole = sum_of(all, {0, 0, 0});
  for (const std::ptrdiff_t cut : {1, 7, 500, 999}) {
    Moments<3> first = sum_of({all.begin(), all.begin() + cut}, {0, 0, 0});
    Moments<3> second = sum_of({all.begin() + cut, all.end()}, {0, 0, 0});
    Moments<3> swapped = second;
    swapped.merge(first);
    first.merge(second);
    for (const Moments<3>& merged : {first, swapped}) {
      EXPECT_EQ(merged.count, whole.count);
      EXPECT_NEAR(merged.spread / whole.spread, 1, 1e-13);
      EXPECT_LE((merged.mean - whole.mean).norm(), 1e-14);
    }
  }
}

TEST(Moments, EmptyIsTheNeutralElement) {
  const Moments<3> some = sum_of(points(10), {0, 0, 0});
  Moments<3> left, right = some;
  left.merge(some);
  right.merge(Moments<3>{});
  for (const Moments<3>& merged : {left, right}) {
    EXPECT_EQ(merged.count, some.count);
    EXPECT_EQ(merged.mean, some.mean);
    EXPECT_EQ(merged.spread, some.spread);
  }
}

TEST(Moments, EqualPointsHaveNoSpread) {
  Moments<2> sum;
  for (int i = 0; i < 1000; ++i) sum.merge({1, 3, {0.1, -7.7}, 0});
  EXPECT_EQ(sum.spread, 0);
  EXPECT_EQ(sum.mean, Eigen::Vector2d(0.1, -7.7));
}

}  // namespace
}  // namespace mdana
