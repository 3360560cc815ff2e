// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "readers/masses.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

AtomBlock block_of_types(const std::vector<std::int64_t>& types) {
  AtomBlock block;
  block.reset(0, types.size());
  std::copy(types.begin(), types.end(), block.make_integer("type").begin());
  return block;
}

TEST(Masses, ByType) {
  const Masses masses = Masses::by_type({{1, 39.95}, {7, 1e-26}}, "--masses");
  std::vector<double> mass;
  masses.fill(block_of_types({7, 1, 1, 7}), mass);
  EXPECT_EQ(mass, (std::vector<double>{1e-26, 39.95, 39.95, 1e-26}));
  EXPECT_EQ(masses.columns().names(), (std::vector<std::string>{"type"}));
  EXPECT_EQ(masses.source(), "--masses");
}

TEST(Masses, TypeWithoutMassIsNamed) {
  const Masses masses = Masses::by_type({{1, 1}}, "");
  std::vector<double> mass;
  EXPECT_INPUT_ERROR(masses.fill(block_of_types({1, 1, 3}), mass), "type 3");
}

TEST(Masses, FromColumn) {
  AtomBlock block;
  block.reset(0, 2);
  block.make_real("mass")[0] = 2;
  block.make_real("mass")[1] = 0.5;
  std::vector<double> mass;
  Masses::from_column("column").fill(block, mass);
  EXPECT_EQ(mass, (std::vector<double>{2, 0.5}));
}

TEST(Masses, MustBePositiveAndFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_INPUT_ERROR(Masses::by_type({{1, wrong}}, ""), "not positive and finite");
    AtomBlock block;
    block.reset(0, 1);
    block.make_real("mass")[0] = wrong;
    std::vector<double> mass;
    EXPECT_INPUT_ERROR(Masses::from_column("").fill(block, mass), "not positive and finite");
  }
}

TEST(Masses, UniformNeedsNoColumn) {
  std::vector<double> mass;
  AtomBlock block;
  block.reset(0, 3);
  Masses::uniform("1").fill(block, mass);
  EXPECT_EQ(mass, (std::vector<double>{1, 1, 1}));
  EXPECT_TRUE(Masses::uniform("1").columns().empty());
}

TEST(ParseMasses, ReadsTypesAndMasses) {
  EXPECT_EQ(parse_masses("1=39.95,12=1.07e-25"),
            (std::map<std::int64_t, double>{{1, 39.95}, {12, 1.07e-25}}));
}

TEST(ParseMasses, EachTypeOnceAndPositive) {
  EXPECT_INPUT_ERROR(parse_masses("1=2,1=2"), "type 1", "twice");
  EXPECT_INPUT_ERROR(parse_masses("1=2,2=0"), "not positive");
}

TEST(ParseMasses, QuotesWhatItCannotRead) {
  for (const std::string text :
       {"1", "1:2", "=2", "1=", "a=1", "1=2;2=3", "1=2x", "1 =2", "1=1,,2=2"})
    EXPECT_INPUT_ERROR(parse_masses(text), "'" + text + "'", "TYPE=MASS");
}

}  // namespace
}  // namespace mdana
