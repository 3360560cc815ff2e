// SPDX-License-Identifier: GPL-3.0-or-later
// Maugis' law between its limits.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/fits/contacts.hpp"

namespace mdana {
namespace {

using namespace test;

const ForceLaw& law(const char* name) { return *find_force_law(name); }

/// The lj contact with the spacing that makes Maugis' parameter lambda.
ElasticContact with_lambda(double lambda) {
  ElasticContact c = lj;
  const double stress =
      lambda / 2 *
      std::cbrt(32 * std::numbers::pi * c.surface_energy * c.modulus * c.modulus / (9 * c.radius));
  c.spacing = c.surface_energy / stress;
  return c;
}

// lambda -> infinity at a fixed delta: the zone is 1/lambda^2 of a wide, and F and a approach those of
// JKR as 1/lambda^2 or faster, down to the rounding of a few operations.
TEST(Maugis, TendsToJkrForAHighStress) {
  for (const double d : {-0.5, 0.0, 1.0, 30.0}) {
    const double delta = d * jkr_delta(lj), a = law("jkr").contact_radius(delta, lj),
                 force = law("jkr").force(delta, lj), unit = pull_off_force(lj) + std::abs(force);
    double error_before = 0;
    for (const double lambda : {1e2, 1e3, 1e4, 1e6}) {
      const ElasticContact c = with_lambda(lambda);
      const double error = std::abs(law("maugis").force(delta, c) - force) / unit;
      EXPECT_LE(error, 3 / lambda + 1e-14) << lambda << " " << d;
      if (error_before > 1e-11) {
        EXPECT_LE(error, 0.11 * error_before) << lambda << " " << d;
      }
      EXPECT_NEAR(law("maugis").contact_radius(delta, c) / a, 1, 3 / lambda) << lambda << " " << d;
      EXPECT_NEAR(law("maugis").energy(delta, c), law("jkr").energy(delta, lj),
                  3 / lambda * unit * jkr_delta(lj) * (1 + std::abs(d)))
          << lambda << " " << d;
      error_before = error;
    }
  }
}

// The end of the contact tends to JKR's pull-off.
TEST(Maugis, PullOffTendsToThatOfJkr) {
  for (const double lambda : {1e3, 1e4, 1e6})
    EXPECT_NEAR(law("maugis").least_delta(with_lambda(lambda)) / law("jkr").least_delta(lj), 1,
                3 / lambda)
        << lambda;
}

// lambda -> 0 at a fixed a: F = F_Hertz - 4 pi gamma R* (1 + O(lambda)) with delta = a^2/R* - O(sqrt
// lambda), so that at a fixed delta the difference falls as sqrt(lambda).
TEST(Maugis, TendsToDmtForALowStress) {
  for (const double d : {0.5, 3.0, 30.0}) {
    const double delta = d * jkr_delta(lj), dmt = law("dmt").force(delta, lj),
                 unit = pull_off_force(lj) * (1 + d);
    double error_before = 0;
    for (const double lambda : {1e-2, 1e-4, 1e-6, 1e-8}) {
      const ElasticContact c = with_lambda(lambda);
      const double error = std::abs(law("maugis").force(delta, c) - dmt) / unit;
      EXPECT_LE(error, 3 * std::sqrt(lambda)) << lambda << " " << d;
      if (lambda < 1e-5) {
        EXPECT_NEAR(error / error_before, 0.1, 0.03) << lambda << " " << d;
      }
      error_before = error;
      const double a = law("maugis").contact_radius(delta, c), hertz = std::pow(a, 3) / 0.75 *
                                                                      (c.modulus / c.radius);
      EXPECT_NEAR(law("maugis").force(delta, c) - hertz, -4.0 / 3.0 * pull_off_force(c),
                  10 * lambda * unit * (1 + d) + 1e-14 * hertz)
          << lambda << " " << d;
    }
  }
}

// Least force of the stable branch: from 4/3 F_c (DMT) to F_c (JKR), falling with lambda.
TEST(Maugis, PullOffForceFallsFromDmtToJkr) {
  double before = 4.0 / 3.0 * (1 + 1e-12);
  for (double lambda = 1e-6; lambda < 2e6; lambda *= 10) {
    const ElasticContact c = with_lambda(lambda);
    const double least = law("maugis").least_delta(c);
    double force = 0;
    for (int i = 0; i <= 4000; ++i)
      force = std::min(force, law("maugis").force(least + i * 5e-4 * jkr_delta(c), c));
    EXPECT_LE(-force / pull_off_force(c), before) << lambda;
    EXPECT_GE(-force / pull_off_force(c), 1 - 1e-6) << lambda;
    before = -force / pull_off_force(c);
  }
  EXPECT_NEAR(before, 1, 1e-5);
}

// Up to lambda = 0.938 the contact shrinks to a point, beyond it ends in a jump (Johnson & Greenwood
// 1997).
TEST(Maugis, TheJumpBeginsAtTheKnownStress) {
  const auto last_radius = [](double lambda) {
    const ElasticContact c = with_lambda(lambda);
    return law("maugis").contact_radius(law("maugis").least_delta(c), c) / jkr_radius(c);
  };
  EXPECT_LT(last_radius(0.93), 1e-6);
  EXPECT_GT(last_radius(0.95), 1e-2);
  EXPECT_NEAR(last_radius(1e6), std::pow(6.0, -2.0 / 3.0), 1e-3);
}

// The gap at the rim of the zone is 2 gamma/sigma0: from the displacement under the pressure,
// u(c) = (4/(pi E* c)) int p(r) K(r/c) r dr.
TEST(Maugis, TheZoneEndsWhereTheGapIsTheRangeOfTheStress) {
  for (const double lambda : {0.1, 0.5, 1.0, 5.0}) {
    const ElasticContact k = with_lambda(lambda);
    for (const double d : {0.0, 1.0, 10.0}) {
      const double delta = d * jkr_delta(k), c = law("maugis").pressure_radius(delta, k);
      constexpr int n = 20000;  // midpoint rule in r = c (1 - s^2), which lifts the logarithm of K
      double displacement = 0;
      for (int i = 0; i < n; ++i) {
        const double s = (i + 0.5) / n, r = c * (1 - s * s);
        displacement += law("maugis").pressure(r, delta, k) * std::comp_ellint_1(r / c) * r * 2 * s *
                        c / n;
      }
      displacement *= 4 / (std::numbers::pi * k.modulus * c);
      const double gap = c * c / (2 * k.radius) - delta + displacement;
      EXPECT_NEAR(gap / (2 * k.spacing), 1, 2e-4) << lambda << " " << d;
    }
  }
}

}  // namespace
}  // namespace mdana
