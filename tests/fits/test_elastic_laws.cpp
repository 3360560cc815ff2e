// SPDX-License-Identifier: GPL-3.0-or-later
// The elastic laws against independent formulas and against each other in their limits.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/fits/contacts.hpp"

namespace mdana {
namespace {

using namespace test;

/// Energy of a contact at u on the JKR curve (physics sheet: U = 24/5 u^5 - 8 u^3.5 + 2 u^2).
double jkr_energy(double u) { return 4.8 * std::pow(u, 5) - 8 * std::pow(u, 3.5) + 2 * u * u; }

// On the JKR curve, with u from the law's own contact radius: d and F follow, and dU/dd = F.
TEST(Jkr, ForceIsTheDerivativeOfTheEnergy) {
  const ForceLaw& jkr = *find_force_law("jkr");
  for (const ElasticContact& c : {lj, ice, stiff})
    for (double d = -0.8; d < 100; d += 0.37) {
      const auto u_at = [&](double x) {
        return jkr.contact_radius(x * jkr_delta(c), c) / jkr_radius(c);
      };
      const double u = u_at(d), h = 1e-5;
      EXPECT_NEAR(3 * u * u - 2 * std::sqrt(u), d, 1e-13 * (1 + 3 * u * u));
      const double force = jkr.force(d * jkr_delta(c), c) / pull_off_force(c);
      EXPECT_NEAR(force, 4 * (std::pow(u, 3) - std::pow(u, 1.5)), 1e-12 * (1 + std::pow(u, 3)));
      const double slope = (jkr_energy(u_at(d + h)) - jkr_energy(u_at(d - h))) / (2 * h);
      EXPECT_NEAR(force, slope, 1e-8 * (1 + std::pow(u, 5)));
    }
}

// gamma -> 0 at a fixed delta: with u^2 ~ d/3 ~ gamma^(-2/3), d = 3u^2 (1 - 2/3 u^-1.5) and F =
// 4u^3 (1 - u^-1.5) give a = a_Hertz (1 + u^-1.5/3), the first order in sqrt(gamma), and
// F = F_Hertz (1 + O(u^-3)), where it cancels: the first order in gamma.
TEST(Jkr, TendsToHertzWithoutAdhesion) {
  const ForceLaw &jkr = *find_force_law("jkr"), &hertz = *find_force_law("hertz");
  double force_before = 30, radius_before = 4;
  for (double gamma = 1e-2; gamma > 1e-34; gamma *= 1e-4) {
    const ElasticContact c{73.5, 65.5, gamma};
    const double force = std::abs(jkr.force(2, c) / hertz.force(2, c) - 1);
    const double radius = jkr.contact_radius(2, c) / hertz.contact_radius(2, c) - 1;
    EXPECT_LE(force, std::max(1.1e-4 * force_before, 3e-15)) << gamma;
    EXPECT_LE(radius, std::max(1.1e-2 * radius_before, 3e-15)) << gamma;
    if (radius > 1e-6) {
      const double u = jkr.contact_radius(2, c) / jkr_radius(c);
      EXPECT_NEAR(radius / (std::pow(u, -1.5) / 3), 1, 0.2) << gamma;
    }
    force_before = force;
    radius_before = radius;
  }
  EXPECT_LE(force_before, 3e-15);
  EXPECT_LE(radius_before, 3e-15);
}

TEST(Jkr, ContactReachesDownToItsLeastDelta) {
  const ForceLaw& jkr = *find_force_law("jkr");
  int lost = 0;
  for (int i = 0; i < 1000; ++i) {
    const ElasticContact c{10 + 0.37 * i, 65.5 + 0.11 * i, 3.17};
    const double force = jkr.force(jkr.least_delta(c), c) / pull_off_force(c);
    lost += std::abs(force + 5.0 / 9.0) > 1e-6;  // sqrt(epsilon) with room
  }
  EXPECT_EQ(lost, 0) << "of 1000 contacts end above their least delta";
}

// The energy lost by breaking off and jumping into contact: the loop between F(delta) down to
// pull-off and no force up to delta = 0 (physics sheet, section 2: 0.7722405 F_c delta0).
TEST(Jkr, LossOfOneContact) {
  const ForceLaw& jkr = *find_force_law("jkr");
  const double least = jkr.least_delta(lj);
  constexpr int n = 4000;  // midpoint rule in s = sqrt(delta - least), where F is smooth
  double work = 0;
  for (int i = 0; i < n; ++i) {
    const double top = std::sqrt(-least), s = (i + 0.5) / n * top;
    work -= jkr.force(least + s * s, lj) * 2 * s * top / n;
  }
  const double exact = std::pow(6.0, -4.0 / 3.0) * (6 * std::pow(4.0, 4.0 / 3.0) + 4) / 5;
  EXPECT_NEAR(exact, 0.7722405, 1e-7);
  EXPECT_NEAR(work / (pull_off_force(lj) * jkr_delta(lj)), exact, 1e-6);
}

}  // namespace
}  // namespace mdana
