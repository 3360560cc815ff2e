// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "analyses/turning_points.hpp"

namespace mdana {
namespace {

std::string text(const std::vector<Turn>& turns) {
  std::string result;
  for (const Turn& turn : turns)
    result += std::string(turn.maximum ? "max" : "min") + std::to_string(turn.index) + " ";
  return result;
}

TEST(TurningPoints, OfAZigzag) {
  EXPECT_EQ(text(turning_points({0, 3, 1, 5, -2, 4}, 0.5)), "max1 min2 max3 min4 ");
  EXPECT_EQ(text(turning_points({0, -3, 1, -5, 2}, 0.5)), "min1 max2 min3 ");
}

TEST(TurningPoints, SmallOnesDoNotCount) {
  EXPECT_EQ(text(turning_points({0, 3, 2.6, 5, 4.7, 4.9, -2}, 0.5)), "max3 ");
  EXPECT_EQ(text(turning_points({0, 3, 2.5, 5}, 0.5)),
            "");  // goes back by more than, not as much as
}

TEST(TurningPoints, NoneInMonotoneAndFlatSeries) {
  EXPECT_EQ(text(turning_points({}, 0)), "");
  EXPECT_EQ(text(turning_points({1}, 0)), "");
  EXPECT_EQ(text(turning_points({1, 1, 1}, 0)), "");
  EXPECT_EQ(text(turning_points({1, 2, 2, 3}, 0)), "");
  EXPECT_EQ(text(turning_points({3, 2, 1}, 0)), "");
}

TEST(TurningPoints, OfAPlateauIsItsFirst) {
  EXPECT_EQ(text(turning_points({0, 2, 2, 2, 0}, 0)), "max1 ");
}

// A sine with noise below the threshold: one maximum and one minimum a period, alternating.
TEST(TurningPoints, OfANoisySine) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-0.02, 0.02);
  std::vector<double> series;
  for (int i = 0; i <= 1000; ++i) series.push_back(std::sin(0.0628318530718 * i) + noise(random));
  const auto turns = turning_points(series, 0.1);
  ASSERT_EQ(turns.size(), 20u);
  for (std::size_t k = 0; k < turns.size(); ++k) {
    EXPECT_EQ(turns[k].maximum, k % 2 == 0);
    EXPECT_NEAR(static_cast<double>(turns[k].index), 25.0 + 50.0 * static_cast<double>(k), 6);
  }
}

}  // namespace
}  // namespace mdana
