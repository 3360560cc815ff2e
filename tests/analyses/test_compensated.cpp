// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "analyses/compensated.hpp"

namespace mdana {
namespace {

using Sum = CompensatedSum<3>;
using Eigen::Vector3d;

TEST(CompensatedSum, KeepsWhatCancelsAround) {
  Sum sum;
  sum.add({1e16, 1, 1e100});
  sum.add({1, 1e20, 1});
  sum.add({-1e16, -1e20, -1e100});
  EXPECT_EQ(sum.value(), Vector3d(1, 1, 1));
}

// Pairs f, -f of any size leave the one unpaired force exactly, in any order.
TEST(CompensatedSum, PairsLeaveTheRest) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  std::vector<Vector3d> forces{{0.125, -3, 7e-3}};
  for (int i = 0; i < 5000; ++i) {
    const Vector3d f = 1e6 * Vector3d(normal(random), normal(random), normal(random));
    forces.push_back(f);
    forces.push_back(-f);
  }
  std::shuffle(forces.begin(), forces.end(), random);
  Sum sum;
  for (const Vector3d& f : forces) sum.add(f);
  // Errors are of second order, n^2 epsilon^2 times the terms at worst: 1e8 * 5e-32 * 1e6 = 5e-18;
  // then one rounding of the result. A plain sum is wrong by about 1e4^0.5 * 1e-16 * 1e8 = 1e-6.
  EXPECT_LE((sum.value() - Vector3d(0.125, -3, 7e-3)).norm(), 3 * 2.2e-16);
}

TEST(CompensatedSum, MergesLikeOneSum) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  Sum whole, left, right;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d f(1e10 * normal(random), normal(random), 1e-10 * normal(random));
    whole.add(f);
    (i < 700 ? left : right).add(f);
  }
  left.merge(right);
  // one rounding of the total: it is the same sum to the last digit or its neighbour
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(left.value()[k] / whole.value()[k], 1, 4.5e-16);
}

TEST(CompensatedSum, IsZeroAtFirst) { EXPECT_EQ(Sum().value(), Vector3d(0, 0, 0)); }

}  // namespace
}  // namespace mdana
