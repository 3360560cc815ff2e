// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "reports/plasticity.hpp"
#include "tests/analyses/collision.hpp"

namespace mdana {
namespace {

constexpr double mass = 3, omega = 0.25, radii = 20, reduced = 5;

ForceCurve bounce(double v, double omega2) {
  return force_curve(test::head_on(test::even_times(-20, 40, 0.1),
                                   test::plastic_bounce(v, omega, omega2), radii, mass),
                     ForceSource::forces, Units::lj, radii);
}

// Unloading with the frequency omega2 ends at delta_max (1 - omega^2/omega2^2); the forces are exact,
// the zero lies between frames 0.1 apart in which delta moves by v/10.
TEST(Plasticity, ResidualIsWhereTheForceVanishes) {
  for (const double omega2 : {0.5, 1.0}) {
    const double v = 0.5, most = v / omega, left = most * (1 - omega * omega / (omega2 * omega2));
    const PlasticSigns signs = plastic_signs(bounce(v, omega2), {reduced, 0, 0});
    EXPECT_NEAR(signs.residual.value, left, 2 * v / 10);
    EXPECT_NE(signs.verdict, Plasticity::no);
    EXPECT_EQ(signs.reasons.size(), 2u);
  }
  EXPECT_NEAR(plastic_signs(bounce(0.5, omega), {reduced, 0, 0}).residual.value, 0, 0.1);
}

TEST(Plasticity, PressureByHertzIsThatOfTheGreatestDelta) {
  const double v = 0.05, most = v / omega;
  const PlasticSigns signs = plastic_signs(bounce(v, omega), {reduced, 0, 0});
  const double exact = 2 / std::numbers::pi * std::sqrt(most / reduced);  // 0.127: elastic
  ASSERT_TRUE(signs.pressure_hertz.error);
  EXPECT_NEAR(signs.pressure_hertz.value, exact, *signs.pressure_hertz.error + 1e-12);
  EXPECT_FALSE(signs.pressure_jkr);
  EXPECT_EQ(signs.verdict, Plasticity::no);
}

// At delta0 the JKR contact carries no load: u = 1, p_c/E* = 2 a0/(pi R*) (1 - 1/3).
TEST(Plasticity, PressureByJkrInEquilibrium) {
  const double modulus = 50, gamma = 2;
  const double a0 = std::cbrt(9 * std::numbers::pi * gamma * reduced * reduced / modulus);
  ForceCurve curve = bounce(0.5, omega);
  curve.delta_max = {a0 * a0 / (3 * reduced), 1e-6, dimension::length};
  const PlasticSigns signs = plastic_signs(curve, {reduced, modulus, gamma});
  ASSERT_TRUE(signs.pressure_jkr);
  EXPECT_NEAR(signs.pressure_jkr->value, 4 * a0 / (3 * std::numbers::pi * reduced), 1e-9);
  EXPECT_EQ(&signs.pressure(), &*signs.pressure_jkr);
}

TEST(Plasticity, WithoutATurnThereIsNoResidual) {
  const ForceCurve curve =
      force_curve(test::head_on(test::even_times(-20, 5, 0.1), test::plastic_bounce(0.5, omega, 0.5),
                                radii, mass),
                  ForceSource::forces, Units::lj, radii);
  const PlasticSigns signs = plastic_signs(curve, {reduced, 0, 0});
  EXPECT_TRUE(std::isnan(signs.residual.value));
  EXPECT_NE(signs.reasons.back().find("does not vanish"), std::string::npos);
}

}  // namespace
}  // namespace mdana
