// SPDX-License-Identifier: GPL-3.0-or-later
// The whole catalogue of known motions, with a table of how often twice a stated error holds the truth.
#include <gtest/gtest.h>

#include "tests/analyses/coverage.hpp"

namespace mdana {
namespace {

TEST(CoverageOfAll, OfStatedErrorsIsAtLeastNinetyFivePercent) {
  const test::CoverageTable table = test::coverage(20, 7);
  test::print(table);
  for (const auto& [number, rows] : table) {
    EXPECT_GE(rows.at("all").share(), 0.95) << number;
    for (const auto& motion : test::known_motions())
      if (const auto row = rows.find(motion.name); row != rows.end()) {
        EXPECT_GE(row->second.share(), 0.95) << number << ", " << motion.name;
      }
  }
}

}  // namespace
}  // namespace mdana
