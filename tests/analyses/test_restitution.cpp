// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include <gtest/gtest.h>

#include "analyses/restitution.hpp"
#include "tests/analyses/collision.hpp"

namespace mdana {
namespace {

constexpr double mass = 3, v = 0.5, omega = 0.25, radii = 20;

RelativeMotion bounce(double omega2, double first = -20, double last = 40) {
  return test::head_on(test::even_times(first, last, 0.2), test::plastic_bounce(v, omega, omega2),
                       radii, mass);
}

Restitution of(const RelativeMotion& motion, ForceSource source = ForceSource::velocities) {
  return restitution(motion, force_curve(motion, source, Units::lj, radii));
}

// Flight is straight before and after, so that only rounding of means of a hundred speeds is left;
// by positions, of derivatives of X = 20 over steps of 0.2: 20 epsilon / 0.2.
TEST(Restitution, IsTheRatioOfTheSpeedsOfFlight) {
  for (const double omega2 : {0.25, 0.5, 1.0}) {
    const Restitution r = of(bounce(omega2));
    EXPECT_EQ(r.reason, "");
    EXPECT_NEAR(r.e.value, omega / omega2, 1e-12);
    EXPECT_NEAR(r.e_total.value, omega / omega2, 1e-12);
    ASSERT_TRUE(r.e.error);
    EXPECT_LT(*r.e.error, 1e-6);
    RelativeMotion positions = bounce(omega2);
    positions.velocity.resize(3, 0);
    EXPECT_NEAR(of(positions, ForceSource::positions).e.value, omega / omega2, 1e-3);
  }
}

// The stated error is one standard deviation: of a hundred runs with noise about 95 lie within two.
TEST(Restitution, ErrorCoversNoise) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0, 0.01 * v);
  int covered = 0;
  for (int run = 0; run < 100; ++run) {
    RelativeMotion motion = bounce(0.5);
    for (double& component : motion.velocity.reshaped()) component += noise(random);
    const Restitution r = of(motion, ForceSource::forces);
    covered += std::abs(r.e.value - 0.5) <= 2 * r.e.error.value_or(0);
  }
  EXPECT_GE(covered, 90);
}

TEST(Restitution, TotalCountsTheMotionAcrossTheLine) {
  RelativeMotion motion = bounce(0.5);
  const Eigen::Vector3d across = Eigen::Vector3d(2, 2, 1) / 3 * 0.25;  // normal to (1, -2, 2)
  motion.velocity.colwise() += across;
  const Restitution r = of(motion, ForceSource::forces);
  EXPECT_NEAR(r.e.value, 0.5, 1e-12);
  EXPECT_NEAR(r.e_total.value, std::hypot(0.25, 0.25) / std::hypot(0.5, 0.25), 1e-12);
}

TEST(Restitution, SaysWhyItIsNotDetermined) {
  const Restitution begins = of(bounce(0.5, 0.5));
  EXPECT_TRUE(std::isnan(begins.e.value));
  EXPECT_NE(begins.reason.find("begins in contact"), std::string::npos) << begins.reason;
  const Restitution ends = of(bounce(0.5, -20, 5));
  EXPECT_TRUE(std::isnan(ends.e.value));
  EXPECT_NE(ends.reason.find("dump ends"), std::string::npos) << ends.reason;
}

}  // namespace
}  // namespace mdana
