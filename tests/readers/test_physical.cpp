// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "readers/input_error.hpp"
#include "readers/physical.hpp"

namespace mdana {
namespace {

// By hand: m = 0.03995/6.02214076e23 = 6.633854e-26 kg, epsilon = 0.01032 * 1.602176634e-19 =
// 1.653446e-21 J, epsilon/m = 24924.37 m^2/s^2.
TEST(Physical, Argon) {
  const PhysicalUnits argon = parse_physical("argon");
  EXPECT_EQ(argon.name, "argon");
  EXPECT_NEAR(argon.of(dimension::mass) / 6.633854e-26, 1, 1e-6);
  EXPECT_NEAR(argon.of(dimension::length) / 0.341e-9, 1, 1e-14);
  EXPECT_NEAR(argon.of(dimension::energy) / 1.653446e-21, 1, 1e-6);
  EXPECT_NEAR(argon.of(dimension::velocity) / 157.8745, 1, 1e-6);
  EXPECT_NEAR(argon.of(dimension::time) / 2.159943e-12, 1, 1e-6);
  EXPECT_NEAR(argon.of(dimension::force) / 4.848816e-12, 1, 1e-6);
  EXPECT_NEAR(argon.of(dimension::pressure) / 4.169913e7, 1, 1e-6);
  EXPECT_NEAR(argon.of(dimension::surface_energy) / 1.421940e-2, 1, 1e-6);
  EXPECT_EQ(argon.of(dimension::none), 1);
}

// P1, Table I: t and v follow from its m, sigma and epsilon to the digits that it prints, but for v
// of silver, 555.5 cut off to 555.
TEST(Physical, TableOfThePaper) {
  const struct {
    const char* name;
    double picoseconds, half_digit_t, speed, half_digit_v;
  } rows[] = {{"argon", 2.16, 0.005, 158, 0.5}, {"water", 0.599, 0.0005, 533, 0.5},
              {"silver", 0.476, 0.0005, 555, 1}};
  for (const auto& row : rows) {
    const PhysicalUnits u = parse_physical(row.name);
    EXPECT_NEAR(u.of(dimension::time) * 1e12, row.picoseconds, row.half_digit_t) << row.name;
    EXPECT_NEAR(u.of(dimension::velocity), row.speed, row.half_digit_v) << row.name;
    EXPECT_NE(u.source.find("Table I"), std::string::npos);
  }
}

TEST(Physical, GivenValuesInAnyOrderAndUnit) {
  const PhysicalUnits argon = parse_physical("argon");
  const PhysicalUnits same = parse_physical("epsilon=10.32meV,m=39.95g/mol,sigma=3.41A");
  const PhysicalUnits si = parse_physical("m=2,sigma=3,epsilon=8");
  EXPECT_NEAR(same.mass / argon.mass, 1, 1e-15);
  EXPECT_NEAR(same.length / argon.length, 1, 1e-15);
  EXPECT_NEAR(same.energy / argon.energy, 1, 1e-15);
  EXPECT_NEAR(parse_physical("m=1u,sigma=1nm,epsilon=119.8K").energy, 119.8 * 1.380649e-23, 1e-35);
  EXPECT_EQ(si.time(), 1.5);
  EXPECT_EQ(si.of(dimension::force), 2 * 3 / 2.25);
}

TEST(Physical, RefusesWhatIsNoMaterial) {
  for (const char* text :
       {"", "gold", "m=1", "m=1,sigma=1", "m=1,sigma=1,epsilon=1,m=2", "m=1,sigma=1,epsilon=0",
        "m=1,sigma=-1,epsilon=1", "m=1,sigma=nan,epsilon=1", "m=1,sigma=1e400,epsilon=1",
        "m=1kg,sigma=1ly,epsilon=1", "m=,sigma=1,epsilon=1", "m,sigma,epsilon", "m=1 sigma=1",
        "m=1,sigma=1,gamma=1", ",,,"})
    EXPECT_THROW(parse_physical(text), InputError) << text;
}

}  // namespace
}  // namespace mdana
