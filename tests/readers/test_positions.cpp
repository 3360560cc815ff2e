// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "readers/positions.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana {
namespace {

// One frame of two atoms in a tilted box with corner (-4, -2, 0) and edges (8, 0, 0), (2, 4, 0),
// (-1, 1, 16), written in every spelling. The numbers are dyadic: the positions are exact.
struct Spelling {
  const char* columns;
  const char* first;
  const char* second;
};

// Fractions (0.5, 0.25, 0.125) in the image (0, 0, 0) and (0.25, 0.5, 0.5) in (1, -2, 3).
const Spelling spellings[] = {
    {"xu yu zu", "0.375 -0.875 2", "-0.5 -4.5 56"},
    {"xsu ysu zsu", "0.5 0.25 0.125", "1.25 -1.5 3.5"},
    {"x y z ix iy iz", "0.375 -0.875 2 0 0 0", "-1.5 0.5 8 1 -2 3"},
    {"ix xs iy ys iz zs", "0 0.5 0 0.25 0 0.125", "1 0.25 -2 0.5 3 0.5"},
    {"zu q yu xu", "2 x -0.875 0.375", "56 x -4.5 -0.5"},
    // the most faithful of several wins: the wrapped ones are wrong here on purpose
    {"x y z xu yu zu", "9 9 9 0.375 -0.875 2", "9 9 9 -0.5 -4.5 56"},
    {"xs ys zs xsu ysu zsu", "0 0 0 0.5 0.25 0.125", "0 0 0 1.25 -1.5 3.5"},
};

std::string dump_of(const Spelling& s) {
  return std::string(
             "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\n"
             "ITEM: BOX BOUNDS xy xz yz pp pp pp\n-5 6 2\n-2 3 -1\n0 16 1\n"
             "ITEM: ATOMS id ") +
         s.columns + "\n1 " + s.first + "\n2 " + s.second + "\n";
}

TEST(Positions, AreTheSameInEverySpelling) {
  const test::TemporaryFolder folder;
  for (const Spelling& s : spellings) {
    const auto whole = test::read_all(folder.write("dump", dump_of(s)), {"x", "y", "z"});
    ASSERT_EQ(whole.error, "") << s.columns;
    const auto& real = whole.frames.at(0).real;
    EXPECT_EQ(real.at("x"), (std::vector<double>{0.375, -0.5})) << s.columns;
    EXPECT_EQ(real.at("y"), (std::vector<double>{-0.875, -4.5})) << s.columns;
    EXPECT_EQ(real.at("z"), (std::vector<double>{2, 56})) << s.columns;
  }
}

TEST(Positions, JumpOnlyIfWrappedWithoutImages) {
  Box periodic;
  periodic.periodic[1] = true;
  EXPECT_TRUE(position_source({"id", "x", "y", "z"})->may_jump(periodic));
  EXPECT_TRUE(position_source({"xs", "ys", "zs", "ix", "iy"})->may_jump(periodic));
  EXPECT_FALSE(position_source({"xs", "ys", "zs", "ix", "iy", "iz"})->may_jump(periodic));
  EXPECT_FALSE(position_source({"x", "y", "z", "xu", "yu", "zu"})->may_jump(periodic));
  EXPECT_FALSE(position_source({"x", "y", "z"})->may_jump(Box()));
}

TEST(Positions, AreMissingWithoutAllThree) {
  EXPECT_FALSE(position_source({"x", "y"}).has_value());
  EXPECT_FALSE(position_source({"x", "ys", "zu"}).has_value());
  EXPECT_FALSE(position_source({}).has_value());
}

}  // namespace
}  // namespace mdana
