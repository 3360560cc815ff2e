// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of the force laws: every member of the list, and each against independent formulas.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fits/force_law.hpp"

namespace mdana {
namespace {

const ElasticContact lj{73.5, 65.5, 3.17};    // P1, R = 147
const ElasticContact ice{5e-8, 3.7e9, 0.1};   // SI, grains of 0.1 um
const ElasticContact stiff{1e6, 1e12, 1e-3};  // almost no adhesion

double jkr_radius(const ElasticContact& c) {
  return std::cbrt(9 * std::numbers::pi * c.surface_energy * c.radius * c.radius / c.modulus);
}
double jkr_delta(const ElasticContact& c) { return jkr_radius(c) * jkr_radius(c) / (3 * c.radius); }
double pull_off_force(const ElasticContact& c) {
  return 3 * std::numbers::pi * c.surface_energy * c.radius;
}

/// Energy of a contact at u on the JKR curve (physics sheet: U = 24/5 u^5 - 8 u^3.5 + 2 u^2).
double jkr_energy(double u) { return 4.8 * std::pow(u, 5) - 8 * std::pow(u, 3.5) + 2 * u * u; }

TEST(ForceLaws, AreFoundByName) {
  for (const ForceLaw* law : force_laws()) {
    EXPECT_EQ(find_force_law(law->name), law);
    EXPECT_FALSE(law->summary.empty());
  }
  EXPECT_EQ(find_force_law("none"), nullptr);
}

// Beyond the least delta there is no force and no contact, above it there is.
TEST(ForceLaws, ContactBeginsAtTheLeastDelta) {
  for (const ForceLaw* law : force_laws())
    for (const ElasticContact& c : {lj, ice, stiff}) {
      const double least = law->least_delta(c), step = 1e-6 * jkr_delta(c);
      EXPECT_EQ(law->force(least - step, c), 0) << law->name;
      EXPECT_EQ(law->contact_radius(least - step, c), 0) << law->name;
      EXPECT_NE(law->force(least + step, c), 0) << law->name;
      EXPECT_GT(law->contact_radius(least + step, c), 0) << law->name;
    }
}

TEST(ForceLaws, GrowWithDelta) {
  for (const ForceLaw* law : force_laws())
    for (const ElasticContact& c : {lj, ice, stiff}) {
      double force = law->force(0, c), radius = law->contact_radius(0, c);
      for (double d = 1e-3; d < 1e6; d *= 1.1) {
        const double next = law->force(d * jkr_delta(c), c),
                     a = law->contact_radius(d * jkr_delta(c), c);
        EXPECT_GT(next, force) << law->name << " " << d;
        EXPECT_GT(a, radius) << law->name << " " << d;
        force = next;
        radius = a;
      }
    }
}

// By dimension F = E* L^2 f(delta/L, gamma/(E* L)): lengths and pressures times powers of two.
// Eight times the length is exact in a cube root too, other powers are so to rounding.
TEST(ForceLaws, ScaleWithLengthAndPressure) {
  for (const ForceLaw* law : force_laws())
    for (const double l : {0x1p-30, 0x1p-7, 0x1p+21})
      for (const double p : {0x1p-10, 0x1p+33}) {
        const ElasticContact scaled{lj.radius * l, lj.modulus * p, lj.surface_energy * p * l};
        for (const double delta : {-1.0, 0.0, 0.5, 30.0}) {
          const double force = law->force(delta, lj) * (p * l * l);
          EXPECT_NEAR(law->force(delta * l, scaled), force, 1e-14 * std::abs(force)) << law->name;
          const double a = law->contact_radius(delta, lj) * l;
          EXPECT_NEAR(law->contact_radius(delta * l, scaled), a, 1e-14 * a) << law->name;
        }
      }
}

// F is the derivative of the energy 8/15 E* sqrt(R*) delta^2.5; central differences at a step of
// 1e-5 delta: 1e-10 of truncation, 1e-16/1e-5 of rounding.
TEST(Hertz, ForceIsTheDerivativeOfTheEnergy) {
  const ForceLaw& hertz = *find_force_law("hertz");
  for (const ElasticContact& c : {lj, ice})
    for (double delta = 1e-3 * jkr_delta(c); delta < 10 * jkr_delta(c); delta *= 2) {
      const auto energy = [&](double d) {
        return 8.0 / 15 * c.modulus * std::sqrt(c.radius) * std::pow(d, 2.5);
      };
      const double slope =
          (energy(delta * (1 + 1e-5)) - energy(delta * (1 - 1e-5))) / (2e-5 * delta);
      EXPECT_NEAR(hertz.force(delta, c) / slope, 1, 1e-9);
    }
}

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
