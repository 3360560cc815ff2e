// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "analyses/lattice_sum.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

/// The definition: pairs of one atom of a crystal, cell by cell, with no idea of shells.
double brute_force(const LennardJones& u, double distance) {
  const double a = std::sqrt(2.0) * distance;
  const auto pair = [&](double r) {
    return 4 * u.epsilon * (std::pow(u.sigma / r, 12) - std::pow(u.sigma / r, 6));
  };
  const int cells = static_cast<int>(*u.cutoff / a) + 2;
  double sum = 0;
  for (int i = -cells; i <= cells; ++i)
    for (int j = -cells; j <= cells; ++j)
      for (int k = -cells; k <= cells; ++k)
        for (const auto [x, y, z] : {std::array{0.0, 0.0, 0.0}, {0.0, 0.5, 0.5}, {0.5, 0.0, 0.5},
                                     {0.5, 0.5, 0.0}}) {
          const double r = a * std::hypot(i + x, j + y, k + z);
          if (r > 0 && r < *u.cutoff)
            sum += 0.5 * (pair(r) - (u.shifted ? pair(*u.cutoff) : 0));
        }
  return sum;
}

// About 500 terms, the greatest of order one: 1e-13.
TEST(LatticeSum, EnergyIsThatOfTheDefinition) {
  for (const bool shifted : {false, true})
    for (const double cutoff : {1.5, 2.5, 3.0, 5.0})
      for (const double distance : {1.05, 1.0907, 1.13}) {
        const LennardJones u{1, 1, cutoff, shifted};
        EXPECT_NEAR(fcc_energy(u, distance), brute_force(u, distance), 1e-13) << cutoff;
      }
}

// In other units: the same numbers times epsilon, sigma, epsilon/sigma^3.
TEST(LatticeSum, ScalesWithEpsilonAndSigma) {
  const FccCrystal one = relaxed_fcc({1, 1, 2.5, true});
  const FccCrystal other = relaxed_fcc({0x1p-70, 0x1p-30, 2.5 * 0x1p-30, true});
  EXPECT_EQ(other.energy, one.energy * 0x1p-70);
  EXPECT_EQ(other.distance, one.distance * 0x1p-30);
  EXPECT_EQ(other.bulk_modulus, one.bulk_modulus * 0x1p+20);
}

// No neighbour distance does better, and the curve there has the slope 0 and the bulk modulus's
// curvature. Differences over h = 1e-4 D lose h^2 times the fourth derivative: 1e-6 of the second.
TEST(LatticeSum, RelaxedCrystalIsTheMinimum) {
  for (const std::optional<double> cutoff : {std::optional<double>(), {2.5}, {3.0}, {5.0}}) {
    const LennardJones u{1, 1, cutoff, true};
    const FccCrystal c = relaxed_fcc(u);
    const double h = 1e-4 * c.distance;
    const double below = fcc_energy(u, c.distance - h), above = fcc_energy(u, c.distance + h);
    const double second = (below - 2 * c.energy + above) / (h * h);
    EXPECT_NEAR((above - below) / (2 * h), 0, 1e-4);  // third derivative * h^2/6
    EXPECT_NEAR(c.bulk_modulus / (std::sqrt(2.0) / (9 * c.distance) * second), 1, 1e-5);
    for (double d = 1.0; d < 1.3; d += 0.001) EXPECT_GE(fcc_energy(u, d), c.energy) << d;
  }
}

// e = -8.61 epsilon, a = 1.5417 sigma, K = 75.2 epsilon/sigma^3 (Ashcroft & Mermin, ch. 20).
TEST(LatticeSum, FullPotentialHasTheTextbooksValues) {
  const FccCrystal c = relaxed_fcc({});
  EXPECT_NEAR(c.energy, -8.6102, 5e-5);
  EXPECT_NEAR(c.distance, 1.0902, 5e-5);
  EXPECT_NEAR(c.bulk_modulus, 75.2, 0.05);
}

// P1, appendix C: e_1 = -8.464, D = 1.091 with cutoff 5, shifted.
TEST(LatticeSum, PapersValues) {
  const FccCrystal c = relaxed_fcc({1, 1, 5, true});
  EXPECT_NEAR(c.energy, -8.464, 5e-4);
  EXPECT_NEAR(c.distance, 1.091, 5e-4);
}

// What the cutoff leaves out is 4/3 pi sqrt(2) 2 (rc/D)^-3 D^-6 of the sixth powers, on average.
TEST(LatticeSum, ApproachesTheFullPotential) {
  const double full = relaxed_fcc({}).energy;
  double before = 1;
  for (const double cutoff : {5.0, 10.0, 20.0, 40.0, 80.0}) {
    const double gap = relaxed_fcc({1, 1, cutoff, false}).energy - full;
    EXPECT_GT(gap, 0) << cutoff;
    EXPECT_LT(gap, before / 4) << cutoff;
    before = gap;
  }
}

TEST(LatticeSum, CutoffsWithoutACrystalAreRefused) {
  EXPECT_THROW(relaxed_fcc({1, 1, 1.0, false}), InputError);  // nobody within reach
  EXPECT_THROW(relaxed_fcc({1, 1, 101, false}), InputError);
  EXPECT_THROW(relaxed_fcc({1, 1, std::nan(""), false}), InputError);
  EXPECT_THROW(fcc_energy({1, 1, 5, false}, 1e-9), InputError);
}

// Unshifted, second neighbours at sqrt(2) D pull the crystal in to D = 1.1129 or leave it at 1.1225;
// with the cutoff between, both are free of pressure, and the one of more neighbours lies lower.
TEST(LatticeSum, OfTwoCrystalsTheLowerIsTaken) {
  const FccCrystal c = relaxed_fcc({1, 1, 1.58, false});
  EXPECT_LT(c.energy, -6);
  EXPECT_LT(c.distance, 1.12);
}

}  // namespace
}  // namespace mdana
