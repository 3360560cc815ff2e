// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "readers/clusters.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

/// Points of an fcc lattice of unit edge within a ball.
std::vector<Eigen::Vector3d> ball(double radius, const Eigen::Vector3d& centre) {
  std::vector<Eigen::Vector3d> points;
  const int n = static_cast<int>(radius) + 2;
  for (int i = -2 * n; i <= 2 * n; ++i)
    for (int j = -2 * n; j <= 2 * n; ++j)
      for (int k = -2 * n; k <= 2 * n; ++k) {
        const Eigen::Vector3d p(0.5 * i, 0.5 * j, 0.5 * k);
        if ((i + j + k) % 2 == 0 && p.norm() <= radius) points.push_back(centre + p);
      }
  return points;
}

Eigen::Matrix3Xd matrix(const std::vector<Eigen::Vector3d>& points, double scale) {
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    result.col(static_cast<Eigen::Index>(i)) = scale * points[i];
  return result;
}

struct TwoBalls {
  std::vector<Eigen::Vector3d> points;
  std::size_t first;  ///< points of the first ball

  /// With a gap of 2.5 nearest-neighbour distances between the surfaces, off the axes.
  TwoBalls(double r1, double r2) : points(ball(r1, {0, 0, 0})), first(points.size()) {
    const Eigen::Vector3d direction = Eigen::Vector3d(1, 2, -2) / 3;
    const auto second = ball(r2, (r1 + r2 + 2.5 * std::sqrt(0.5)) * direction);
    points.insert(points.end(), second.begin(), second.end());
  }
};

TEST(Clusters, TwoBallsAtAnyLengthScale) {
  const TwoBalls balls(4, 3);
  for (const double scale : {1e-9, 1e-3, 1.0, 1e5, 1e9}) {
    const Clusters found = find_clusters(matrix(balls.points, scale));
    EXPECT_NEAR(found.link_distance / scale, 1.5 * std::sqrt(0.5), 1e-9) << scale;
    ASSERT_EQ(found.sizes.size(), 2u) << scale;
    for (std::size_t i = 0; i < balls.points.size(); ++i)
      ASSERT_EQ(found.of_point[i] == found.of_point[0], i < balls.first) << scale;
  }
}

TEST(Clusters, OrderOfPointsAndThermalNoiseChangeNothing) {
  TwoBalls balls(4, 3);
  std::vector<std::size_t> order(balls.points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937 random(3);
  std::shuffle(order.begin(), order.end(), random);
  std::uniform_real_distribution<double> noise(-0.05, 0.05);
  std::vector<Eigen::Vector3d> shuffled;
  for (const std::size_t i : order)
    shuffled.push_back(balls.points[i] +
                       Eigen::Vector3d(noise(random), noise(random), noise(random)));
  const Clusters found = find_clusters(matrix(shuffled, 1e-9));
  ASSERT_EQ(found.sizes.size(), 2u);
  for (std::size_t i = 0; i < order.size(); ++i)
    EXPECT_EQ(found.of_point[i] == found.of_point[0],
              (order[i] < balls.first) == (order[0] < balls.first));
}

TEST(Clusters, FarFromTheOrigin) {
  TwoBalls balls(3, 3);
  for (auto& p : balls.points) p += Eigen::Vector3d(1e7, -1e7, 1e7);
  EXPECT_EQ(find_clusters(matrix(balls.points, 1)).sizes.size(), 2u);
}

TEST(Clusters, OfVeryDifferentDensityAreTwo) {
  auto points = ball(4, {0, 0, 0});
  for (const auto& p : ball(1, {0, 0, 0})) points.push_back(1.2 * p + Eigen::Vector3d(50, 0, 0));
  EXPECT_EQ(find_clusters(matrix(points, 1)).sizes.size(), 2u);
}

TEST(Clusters, UnusablePointsAreAnError) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 3);
  EXPECT_INPUT_ERROR(find_clusters(points), "different places");
  EXPECT_INPUT_ERROR(find_clusters(points.leftCols(1)), "different places");
  EXPECT_INPUT_ERROR(find_clusters(points.leftCols(0)), "different places");
  points(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_INPUT_ERROR(find_clusters(points), "not finite");
}

TEST(Clusters, OneAtomLostFarAway) {
  auto points = ball(3, {0, 0, 0});
  for (const double far : {1e6, -1e6, 1e12, -1e12}) {
    auto with_lost = points;
    with_lost.push_back({far, far, far});
    EXPECT_EQ(find_clusters(matrix(with_lost, 1)).sizes.size(), 2u) << far;
  }
}

TEST(ClusterRuns, IdsThatStandTwiceAreAnError) {
  const Clusters clusters{1, {0, 0, 1, 1}, {2, 2}};
  const std::vector<std::int64_t> ids{5, 6, 5, 7};
  EXPECT_INPUT_ERROR(cluster_runs(clusters, ids, 1), "5");
}

TEST(ClusterRuns, BodiesByLowestIdWithGapsBeyond32Bits) {
  const Clusters clusters{1, {0, 0, 1, 1, 1, 2, 0}, {3, 3, 1}};
  const std::int64_t big = std::int64_t{1} << 40;
  const std::vector<std::int64_t> ids{big + 5, big + 6, big, 3, big + 1, 1, big + 9};
  const auto runs = cluster_runs(clusters, ids, 2);
  const struct {
    std::int64_t first, last;
    int body;
  } expected[] = {{3, 3, 1}, {big, big + 1, 1}, {big + 5, big + 6, 2}, {big + 9, big + 9, 2}};
  ASSERT_EQ(runs.size(), std::size(expected));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].first, expected[i].first);
    EXPECT_EQ(runs[i].last, expected[i].last);
    EXPECT_EQ(runs[i].body, expected[i].body);
  }
}

}  // namespace
}  // namespace mdana
