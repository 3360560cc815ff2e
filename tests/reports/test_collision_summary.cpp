// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "reports/collision_summary.hpp"

namespace mdana {
namespace {

// The limits p of Wilson's interval are where the share lies z standard deviations of p from it:
// (k/n - p)^2 = z^2 p (1 - p)/n.
TEST(Wilson, LimitsSolveTheirEquation) {
  constexpr double z = 1.959963984540054;
  for (const std::size_t n : {1, 2, 8, 20, 1000})
    for (std::size_t k = 0; k <= n; k += 1 + n / 7) {
      const BinomialShare share = wilson(k, n);
      EXPECT_LE(share.low, share.value);
      EXPECT_GE(share.high, share.value);
      for (const double p : {share.low, share.high}) {
        const double off = share.value - p;
        EXPECT_NEAR(off * off, z * z * p * (1 - p) / static_cast<double>(n), 1e-14) << k << "/" << n;
      }
    }
  EXPECT_TRUE(std::isnan(wilson(0, 0).value));
}

TEST(RootMeanSquare, OfAFewNumbers) {
  const std::vector<double> e{0.3, 0.5, 0, 0.4};
  const RootMeanSquare r = root_mean_square(e);
  EXPECT_NEAR(r.value.value, std::sqrt(0.5 / 4), 1e-15);
  EXPECT_NEAR(r.spread, std::sqrt((0.09 + 0.25 + 0.16 - 4 * 0.09) / 3), 1e-15);
  EXPECT_EQ(r.count, 4u);
  ASSERT_TRUE(r.value.error);
  const RootMeanSquare one = root_mean_square(std::vector<double>{0.7});
  EXPECT_NEAR(one.value.value, 0.7, 1e-15);
  EXPECT_FALSE(one.value.error);
  EXPECT_TRUE(std::isnan(root_mean_square({}).value.value));
}

}  // namespace
}  // namespace mdana
