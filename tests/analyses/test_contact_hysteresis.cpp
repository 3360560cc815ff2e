// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "analyses/contact_hysteresis.hpp"

namespace mdana {
namespace {

using Series = std::vector<double>;

TEST(ContactHysteresis, LargestDifferenceAtTheSameDelta) {
  // Loading a = 2 delta; unloading a = 2 delta + bulge, most at delta = 1.25.
  const Series delta{-1, 0, 1, 2, 3, 2.5, 1.25, 0.5, -0.5};
  const Series radius{0, 0, 2, 4, 6, 5.5, 4.0, 2.0, 0};
  const Series error{0.1, 0.1, 0.3, 0.3, 0.4, 0.4, 0.4, 0.4, 0.4};
  const ContactHysteresis h = contact_hysteresis(delta, radius, error);
  EXPECT_DOUBLE_EQ(h.difference.value, 1.5);
  EXPECT_DOUBLE_EQ(h.difference.error.value(), 0.5);  // 3-4-5
  EXPECT_DOUBLE_EQ(h.delta.value, 1.25);
}

TEST(ContactHysteresis, NoneWithoutLoop) {
  const Series delta{-1, 0, 1, 2, 1, 0, -1}, radius{0, 0, 1, 2, 1, 0, 0}, error(7, 0.25);
  EXPECT_EQ(contact_hysteresis(delta, radius, error).difference.value, 0);
}

// The second cycle of a bound pair does not count.
TEST(ContactHysteresis, FirstCycleOnly) {
  const Series delta{0, 2, 1, 2, 1, 2}, radius{1, 3, 2.5, 3, 9, 3}, error(6, 0.0);
  EXPECT_DOUBLE_EQ(contact_hysteresis(delta, radius, error).difference.value, 0.5);
}

TEST(ContactHysteresis, NothingWithoutTurnOrContact) {
  const Series error(4, 0.0);
  for (const Series& radius : {Series{0, 1, 2, 3}, Series{0, 0, 0, 0}})
    EXPECT_TRUE(std::isnan(contact_hysteresis({0, 1, 2, 3}, radius, error).difference.value));
  EXPECT_TRUE(std::isnan(contact_hysteresis({0, 2, 1, 0}, error, error).difference.value));
  EXPECT_TRUE(std::isnan(contact_hysteresis({}, {}, {}).difference.value));
}

}  // namespace
}  // namespace mdana
