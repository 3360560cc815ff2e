// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of collision laws: what is refused, and that the message names it.
#include <gtest/gtest.h>

#include "readers/input_error.hpp"
#include "tests/fits/collision_cases.hpp"

namespace mdana {
namespace {

using test::parameters_of;
using test::sphere;

struct Bad {
  const char* name;
  const char* value;
};

TEST(CollisionParameters, BadOnesAreNamed) {
  for (const auto& [name, value] : {Bad{"T_vis", "-1"},
                                    {"nu", "0"},
                                    {"nu", "nan"},
                                    {"nu", "0.6"},
                                    {"gamma", "-1e-300"},
                                    {"E", "0"},
                                    {"E", "inf"},
                                    {"R", "-147"},
                                    {"m", "x"},
                                    {"v", "0"},
                                    {"v", "1e400"},
                                    {"start", "max"},
                                    {"spacing", "0"},
                                    {"gamma", ""},
                                    {"v", ""},
                                    {"Q", "1"},
                                    {"nu", "0.25x"}}) {
    test::Values p = parameters_of("krijt");
    p[name] = value;
    try {
      sphere("krijt", p);
      ADD_FAILURE() << name << "=" << value;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(name), std::string::npos) << e.what();
    }
  }
}

TEST(CollisionParameters, OneOfTwoIsNeeded) {
  test::Values p = parameters_of("krijt-plastic");
  p["Y"] = "8";
  EXPECT_THROW(sphere("krijt-plastic", p), InputError);
  p["v_Y"] = "";
  EXPECT_NO_THROW(sphere("krijt-plastic", p));
  p["Y"] = "";
  EXPECT_THROW(sphere("krijt-plastic", p), InputError);
}

TEST(CollisionParameters, GeometryHasOneMeaning) {
  const test::Values jkr = parameters_of("jkr");
  const auto with = [&](test::Values more) {
    more.insert(jkr.begin(), jkr.end());
    return sphere("jkr", more).impact;
  };
  EXPECT_EQ(with({}).radius, 73.5);
  EXPECT_EQ(with({{"R", ""}, {"R1", "147"}, {"R2", "inf"}}).radius, 147);
  EXPECT_EQ(with({{"m", ""}, {"m1", "3"}, {"m2", "6"}}).mass, 2);
  EXPECT_NEAR(with({{"m", ""}, {"rho", "1"}}).mass, 16 * 3.141592653589793 / 3 * 73.5 * 73.5 * 73.5,
              1e-6);
  EXPECT_THROW(with({{"R1", "147"}}), InputError);
  EXPECT_THROW(with({{"R", ""}, {"R1", "147"}}), InputError);
  EXPECT_THROW(with({{"R", ""}, {"R1", "inf"}, {"R2", "inf"}}), InputError);
  EXPECT_THROW(with({{"rho", "1"}}), InputError);
  EXPECT_THROW(with({{"m", ""}}), InputError);
}

}  // namespace
}  // namespace mdana
