// SPDX-License-Identifier: GPL-3.0-or-later
// The estimates of Arakawa et al. 2024, Sec. 5, from their own definitions.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fits/aggregate_constants.hpp"

namespace mdana {
namespace {

using std::numbers::pi;

// Grains of water ice as they are usually taken, in nm, ns, ag.
constexpr double radius = 100, modulus = 7000, nu = 0.25, gamma = 100;
const ElasticContact contact = grain_contact(radius, modulus, nu, gamma);

TEST(AggregateConstants, ContactOfGrains) {
  EXPECT_DOUBLE_EQ(contact.radius, 50);
  EXPECT_DOUBLE_EQ(contact.modulus, modulus / (2 * 0.9375));
  const ForceLaw& jkr = *find_force_law("jkr");
  const double delta0 = equilibrium_overlap(contact);
  EXPECT_NEAR(jkr.force(delta0, contact), 0, 1e-12 * pull_force(contact));
  EXPECT_NEAR(jkr.contact_radius(delta0, contact), equilibrium_radius(contact), 1e-12 * radius);
  EXPECT_NEAR(jkr.stiffness(delta0, contact) / contact_stiffness(contact), 1, 1e-12);
  EXPECT_NEAR(contact_stiffness(contact) / (1.2 * pull_force(contact) / delta0), 1, 1e-14);  // (38)
}

// (36), (37): -V dP/dV by a difference, V as the cube of the distance of grains, phi and n_c kept.
TEST(AggregateConstants, BulkModulusIsThatOfThePressure) {
  const double phi = 0.4, n = 6.5, k = contact_stiffness(contact);
  const auto pressure = [&](double closer) {
    return phi * n * k * closer / (4 * pi * radius * radius);
  };
  const auto volume = [&](double closer) { return std::pow(2 * radius - closer, 3); };
  const double h = 1e-4;
  const double difference = -volume(0) * (pressure(h) - pressure(-h)) / (volume(h) - volume(-h));
  EXPECT_NEAR(bulk_modulus(phi, n, k, radius) / difference, 1, 1e-9);
}

TEST(AggregateConstants, PoissonRatioAndModuliAgree) {
  for (const double ratio : {-0.99, -0.3, 0.0, 0.1, 0.25, 0.45, 0.4999}) {
    const double bulk = 80, young = 3 * bulk * (1 - 2 * ratio);
    EXPECT_NEAR(aggregate_poisson_ratio(young / (2 * (1 - ratio * ratio)), bulk), ratio, 1e-13);
  }
  EXPECT_NEAR(aggregate_poisson_ratio(1e-12, 1), 0.5, 1e-12);
  EXPECT_NEAR(aggregate_poisson_ratio(1e12, 1), -1, 1e-11);
}

TEST(AggregateConstants, Coordination) {
  EXPECT_DOUBLE_EQ(largest_filling, pi / std::sqrt(18.0));
  EXPECT_DOUBLE_EQ(cpe_coordination(largest_filling), 12);
  EXPECT_DOUBLE_EQ(cpe_coordination(largest_filling / 4), 3);
  EXPECT_DOUBLE_EQ(bcca_coordination(0), 2);
  EXPECT_DOUBLE_EQ(bcca_coordination(1), 11.38);
  for (const double phi : {0.4, 0.5})
    EXPECT_GT(cpe_coordination(phi), bcca_coordination(phi));  // Fig. 11
}

// E_roll = 6 pi^2 gamma r xi_c; where 1/phi - 1/phi_max = 1/2 the stress is eight times E_roll/r^3.
TEST(AggregateConstants, StaticYieldStress) {
  const double xi = 0.8, phi = 1 / (0.5 + 1 / largest_filling);
  EXPECT_NEAR(static_yield_stress(phi, radius, gamma, xi) /
                  (8 * 6 * pi * pi * gamma * radius * xi / std::pow(radius, 3)),
              1, 1e-14);
  EXPECT_TRUE(std::isinf(static_yield_stress(largest_filling, radius, gamma, xi)));
}

// Lengths, masses, times in units that are powers of two: exactly scaled numbers.
TEST(AggregateConstants, PowersOfTwoScaleExactly) {
  const double length = 0x1p-30, pressure = 0x1p+20;
  const ElasticContact other =
      grain_contact(radius * length, modulus * pressure, nu, gamma * pressure * length);
  EXPECT_EQ(equilibrium_overlap(other), equilibrium_overlap(contact) * length);
  EXPECT_EQ(pull_force(other), pull_force(contact) * pressure * length * length);
  EXPECT_EQ(bulk_modulus(0.4, 6, contact_stiffness(other), radius * length),
            bulk_modulus(0.4, 6, contact_stiffness(contact), radius) * pressure);
  EXPECT_EQ(static_yield_stress(0.4, radius * length, gamma * pressure * length, 0.8 * length),
            static_yield_stress(0.4, radius, gamma, 0.8) * pressure);
}

}  // namespace
}  // namespace mdana
