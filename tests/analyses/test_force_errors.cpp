// SPDX-License-Identifier: GPL-3.0-or-later
// A stated error must cover the distance to the truth, wherever the frames fall.
#include <random>

#include <gtest/gtest.h>

#include "tests/analyses/collision.hpp"

namespace mdana {
namespace {

constexpr double mass = 3, v = 0.5, omega = 0.25, radii = 20;

/// The elastic bounce with frames every `step`; the turn lies `part` of a step behind a frame.
ForceCurve curve(const test::Path& path, ForceSource source, double step, double part) {
  const double turn = std::numbers::pi / (2 * omega);
  const double first = turn - (part + 80) * step;
  return force_curve(
      test::head_on(test::even_times(first, first + 200 * step, step), path, radii, mass), source,
      Units::lj, radii);
}

class ForceErrors : public ::testing::TestWithParam<ForceSource> {};

void expect_maxima_covered(ForceSource source, int part) {
  const ForceCurve c = curve(test::elastic_bounce(v, omega), source, 0.25, 0.05 * part);
  EXPECT_TRUE(test::covers(c.delta_max, v / omega, v / omega))
      << part << ": " << c.delta_max.value - v / omega << " stated " << *c.delta_max.error;
  EXPECT_TRUE(test::covers(c.force_max, mass * omega * v, mass * omega * v))
      << part << ": " << c.force_max.value - mass * omega * v << " stated " << *c.force_max.error;
}

TEST_P(ForceErrors, CoverTheMaximaOfABounce) {
  for (int part = 0; part < 20; ++part)
    if (part < 9 || part > 11) expect_maxima_covered(GetParam(), part);
}

TEST_P(ForceErrors, CoverTheMaximaOfATurnHalfWayBetweenFrames) {
  for (int part = 9; part <= 11; ++part) expect_maxima_covered(GetParam(), part);
}

TEST_P(ForceErrors, CoverTheLoopAreaOfABounce) {
  const double energy = 0.5 * mass * v * v;
  for (int i = 0; i < 20; ++i) {
    const ForceCurve c = curve(test::elastic_bounce(v, omega), GetParam(), 0.25, 0.05 * i);
    EXPECT_TRUE(test::covers(c.hysteresis_area, 0, energy))
        << i << ": " << c.hysteresis_area.value << " stated " << *c.hysteresis_area.error;
  }
}

TEST_P(ForceErrors, CoverTheEnergyLost) {
  const double energy = 0.5 * mass * v * v, lost = energy * (1 - 1 / 4.0);
  for (int i = 0; i < 20; ++i) {
    const ForceCurve c =
        curve(test::plastic_bounce(v, omega, 2 * omega), GetParam(), 0.15, 0.05 * i);
    EXPECT_TRUE(test::covers(c.hysteresis_area, lost, energy))
        << i << ": " << c.hysteresis_area.value - lost << " stated " << *c.hysteresis_area.error;
  }
}

// Twice a standard error covers the truth in about 95 of 100 runs.
TEST(ForceErrorsOfNoise, CoverTheLoopAreaOfNoisyForces) {
  const double lost = 0.5 * mass * v * v * (1 - 1 / 4.0);
  for (const double share : {1e-3, 1e-2}) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> noise(0, share * omega * v);
    int covered = 0;
    for (int run = 0; run < 100; ++run) {
      RelativeMotion motion = test::head_on(test::even_times(-12, 20, 0.15),
                                            test::plastic_bounce(v, omega, 2 * omega), radii, mass);
      for (Eigen::Index i = 0; i < motion.frames(); ++i)
        motion.acceleration.col(i) += noise(random) * motion.position.col(i).normalized();
      const Value area =
          force_curve(motion, ForceSource::forces, Units::lj, radii).hysteresis_area;
      covered += area.error && std::abs(area.value - lost) <= 2 * *area.error;
    }
    EXPECT_GE(covered, 90) << share;
  }
}

INSTANTIATE_TEST_SUITE_P(Sources, ForceErrors,
                         ::testing::Values(ForceSource::forces, ForceSource::velocities,
                                           ForceSource::positions),
                         [](const auto& param) { return std::string(name(param.param)); });

}  // namespace
}  // namespace mdana
