// SPDX-License-Identifier: GPL-3.0-or-later
// Twice a stated error holds the truth in at least 95 of 100 dumps of known motions. More of them: tests/long.
#include <gtest/gtest.h>

#include "tests/analyses/coverage.hpp"

namespace mdana {
namespace {

TEST(Coverage, OfStatedErrorsIsAtLeastNinetyFivePercent) {
  const test::CoverageTable table = test::coverage(1, 1);
  for (const auto& [number, rows] : table) {
    EXPECT_GE(rows.at("all").share(), 0.95) << number;
    EXPECT_GE(rows.at("all").seen, 200) << number;
  }
}

}  // namespace
}  // namespace mdana
