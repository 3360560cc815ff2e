// SPDX-License-Identifier: GPL-3.0-or-later
// The elastoplastic laws: what a loop costs, against the closed forms of the papers, and their limits.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/fits/contacts.hpp"

namespace mdana {
namespace {

using namespace test;

const ForceLaw& law(const char* name) { return *find_force_law(name); }

/// delta_max/delta_Y at x = v/v_Y > 1 (P2 appendix B, from eqs 27 and 28).
double compression(double x) { return (5 + std::sqrt(120 * x * x - 20)) / 15; }

/// Part of the work of loading that unloading gives back, without adhesion.
double recovered(const ForceLaw& plastic, double yield, double x, ElasticContact c) {
  c.surface_energy = 0;
  c.delta_max = x > 1 ? compression(x) * yield : std::pow(x, 0.8) * yield;
  const double work = plastic.energy(c.delta_max, c);
  // W = x^2 times that up to yield, 4/15 pi R* p delta_Y^2.
  const double p = 2 / std::numbers::pi * c.modulus * std::sqrt(yield / c.radius);
  EXPECT_NEAR(work / (4.0 / 15.0 * std::numbers::pi * c.radius * p * yield * yield * x * x), 1, 1e-13);
  return unloading(plastic).energy(c.delta_max, c) / work;
}

// P1 eq. 13. Rounding: delta_p of shallow dents, 1e-16 delta_max/depth.
TEST(Thornton, LossIsThatOfTheClosedForm) {
  for (const ElasticContact& c : {lj, ice, stiff})
    for (double x = 1; x < 1e4; x *= 1.17) {
      const double root = std::sqrt(6 * x * x / 5 - 0.2);
      const double e2 = 6 * std::sqrt(3.0) / 5 * (1 - 1 / (6 * x * x)) / std::sqrt(1 + 2 * root);
      EXPECT_NEAR(recovered(law("thornton"), 1.6 * 1.6 * yield_delta(c), x, c) / e2, 1, 1e-12) << x;
    }
}

// Physics sheet, section 6. delta_max - delta_end is known to rounding of delta_max only.
TEST(Andrews, LossIsThatOfTheClosedForm) {
  for (const ElasticContact& c : {lj, ice, stiff})
    for (double x = 1; x < 1e4; x *= 1.17) {
      const double e2 = (std::sqrt(30 * x * x - 5) - 2) / (3 * x * x);
      EXPECT_NEAR(recovered(law("andrews"), yield_delta(c), x, c) / e2, 1, 1e-12 + 1e-15 * x) << x;
    }
}

TEST(PlasticLaws, GiveAllBackBelowYield) {
  EXPECT_NEAR(recovered(law("thornton"), 2.56 * yield_delta(lj), 0.9, lj), 1, 1e-14);
  EXPECT_NEAR(recovered(law("andrews"), yield_delta(lj), 0.9, lj), 1, 1e-14);
}

// Force and stiffness go on at yield, with adhesion too: the pressure is cut off from nothing on.
TEST(PlasticLaws, AreSmoothAtYield) {
  for (const ElasticContact& c : {lj, ice, stiff, weak})
    for (const char* name : {"thornton", "andrews"}) {
      const double bearing = c.yield_strength * (name[0] == 't' ? 1.6 : 1);
      double below = law(name).least_delta(c), above = 1e3 * (yield_delta(c) + jkr_delta(c));
      for (int i = 0; i < 100; ++i) {
        const double delta = below + (above - below) / 2;
        (law(name).pressure(0, delta, c) < bearing ? below : above) = delta;
      }
      const double step = 1e-9 * std::abs(above);
      const double force = law(name).force(below - step, c);
      EXPECT_NEAR(law(name).force(above + step, c), force, 1e-7 * std::abs(force)) << name;
      const double k = law(name).stiffness(below - step, c);
      EXPECT_NEAR(law(name).stiffness(above + step, c), k, 1e-7 * std::abs(k)) << name;
    }
}

TEST(PlasticLaws, AreElasticIfStrong) {
  for (ElasticContact c : {lj, ice, stiff}) {
    c.yield_strength = 1e6 * c.modulus;
    for (const double d : {-0.5, 0.0, 1.0, 1e3}) {
      const double delta = d * jkr_delta(c);
      c.delta_max = 1.5 * std::abs(delta);
      EXPECT_EQ(law("thornton").force(delta, c), law("jkr").force(delta, c));
      EXPECT_EQ(unloading(law("thornton")).force(delta, c), law("jkr").force(delta, c));
      EXPECT_EQ(law("andrews").force(delta, c), law("hertz").force(delta, c));
      EXPECT_NEAR(unloading(law("andrews")).force(delta, c), law("hertz").force(delta, c),
                  1e-15 * law("hertz").force(delta, c));
    }
  }
}

// gamma -> 0: the difference falls as sqrt(gamma) or faster, and nothing is lost at zero.
TEST(Thornton, TendsToThatWithoutAdhesion) {
  ElasticContact plain = lj;
  plain.surface_energy = 0;
  for (const double d : {1.0, 3.0, 100.0}) {
    plain.delta_max = 1.1 * d * yield_delta(lj);
    const double delta = plain.delta_max / 1.05;
    for (const double gamma : {1e-4, 1e-8, 1e-16, 1e-40, 1e-300}) {
      ElasticContact c = plain;
      c.surface_energy = gamma;
      const double part = 10 * std::sqrt(gamma / (c.modulus * delta)) + 1e-13;
      for (const ForceBranch* b : {static_cast<const ForceBranch*>(&law("thornton")),
                                   &unloading(law("thornton"))}) {
        EXPECT_NEAR(b->force(delta, c) / b->force(delta, plain), 1, part) << gamma;
        EXPECT_NEAR(b->energy(delta, c) / b->energy(delta, plain), 1, part) << gamma;
        EXPECT_NEAR(b->stiffness(delta, c) / b->stiffness(delta, plain), 1, part) << gamma;
      }
    }
  }
}

}  // namespace
}  // namespace mdana
