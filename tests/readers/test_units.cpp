// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "readers/units.hpp"

namespace mdana {
namespace {

constexpr std::array all{Units::lj,  Units::real,     Units::metal, Units::si,
                         Units::cgs, Units::electron, Units::micro, Units::nano};

TEST(Units, NamesGoBothWays) {
  for (const Units units : all) EXPECT_EQ(parse_units(name(units)), units) << name(units);
}

TEST(Units, OtherNamesAreUnknown) {
  for (const char* text : {"", "LJ", "lj ", "SI", "atomic"})
    EXPECT_FALSE(parse_units(text).has_value()) << text;
}

TEST(Units, MessagesNameAll) {
  for (const Units units : all)
    EXPECT_NE(units_names().find(name(units)), std::string::npos) << name(units);
}

// CODATA 2018; LAMMPS uses older values, which agree to 6 digits.
constexpr double avogadro = 6.02214076e23, elementary_charge = 1.602176634e-19;
constexpr double dalton = 1.66053906660e-27, bohr = 5.29177210903e-11,
                 hartree = 4.3597447222071e-18;

TEST(Units, RealForceIsKilocaloriesPerMolePerAngstrom) {
  const double mass = 1e-3 / avogadro, acceleration = 1e-10 / (1e-15 * 1e-15);
  const double force = 4184.0 / avogadro / 1e-10;
  EXPECT_NEAR(force_per_mass_acceleration(Units::real) / (mass * acceleration / force), 1, 1e-6);
}

TEST(Units, MetalForceIsElectronVoltPerAngstrom) {
  const double mass = 1e-3 / avogadro, acceleration = 1e-10 / (1e-12 * 1e-12);
  const double force = elementary_charge / 1e-10;
  EXPECT_NEAR(force_per_mass_acceleration(Units::metal) / (mass * acceleration / force), 1, 1e-6);
}

TEST(Units, ElectronForceIsHartreePerBohr) {
  const double acceleration = bohr / (1e-15 * 1e-15), force = hartree / bohr;
  EXPECT_NEAR(force_per_mass_acceleration(Units::electron) / (dalton * acceleration / force), 1,
              1e-5);  // LAMMPS gives the older constants to 6 digits
}

TEST(Units, ConsistentSystemsNeedNoFactor) {
  for (const Units units : {Units::lj, Units::si, Units::cgs, Units::micro, Units::nano})
    EXPECT_EQ(force_per_mass_acceleration(units), 1) << name(units);
}

TEST(Units, SymbolsOfDerivedQuantities) {
  EXPECT_EQ(symbol(Units::si, dimension::force), "N");
  EXPECT_EQ(symbol(Units::si, dimension::pressure), "Pa");
  EXPECT_EQ(symbol(Units::metal, dimension::force), "eV/Å");
  EXPECT_EQ(symbol(Units::real, dimension::velocity), "Å/fs");
  EXPECT_EQ(symbol(Units::si, dimension::none), "");
  EXPECT_EQ(symbol(Units::si, dimension::surface_energy), "J/m^2");
  EXPECT_EQ(symbol(Units::lj, dimension::surface_energy), "ε/σ^2");
  EXPECT_EQ(symbol(Units::si, {1, -3, 0}), "kg m^-3");
}

}  // namespace
}  // namespace mdana
