// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::contains;

std::string frame(int step, int atoms, const std::string& columns, const std::string& lines) {
  return "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ATOMS\n" +
         std::to_string(atoms) + "\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS " +
         columns + "\n" + lines;
}

class DumpAtoms : public ::testing::Test {
 protected:
  test::WholeTrajectory read(const std::string& text, const ColumnSet& wanted) {
    return test::read_all(folder_.write("dump", text), wanted);
  }
  test::TemporaryFolder folder_;
};

using Integers = std::vector<std::int64_t>;
using Reals = std::vector<double>;

TEST_F(DumpAtoms, FileOrderAnd64BitIds) {
  const auto whole = read(frame(0, 4, "type id q",
                                "2 9000000000000000001 1\n1 0 2\n"
                                "1 -3 3\n2 9223372036854775807 4\n"),
                          {"id", "type", "q"});
  ASSERT_EQ(whole.error, "");
  EXPECT_EQ(whole.frames[0].integer.at("id"),
            (Integers{9000000000000000001, 0, -3, std::numeric_limits<std::int64_t>::max()}));
  EXPECT_EQ(whole.frames[0].integer.at("type"), (Integers{2, 1, 1, 2}));
  EXPECT_EQ(whole.frames[0].real.at("q"), (Reals{1, 2, 3, 4}));
}

TEST_F(DumpAtoms, ColumnsAndAtomsMayChangeBetweenFrames) {
  const auto whole = read(frame(0, 1, "id x y z", "1 1 2 3\n") +
                              frame(1, 3, "z q y x id", "3 w 2 1 5\n6 w 5 4 6\n9 w 8 7 7\n") +
                              frame(2, 1, "xs ys zs id", ".5 .25 1 8\n"),
                          {"id", "x", "y", "z"});
  ASSERT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 3u);
  EXPECT_EQ(whole.frames[1].real.at("x"), (Reals{1, 4, 7}));
  EXPECT_EQ(whole.frames[1].integer.at("id"), (Integers{5, 6, 7}));
  EXPECT_EQ(whole.frames[2].real.at("y"), (Reals{0.25}));
  EXPECT_EQ(whole.frames[2].header.index, 2u);
}

TEST_F(DumpAtoms, EmptyFramesAndBlankLinesBetweenFrames) {
  const auto whole =
      read(frame(0, 0, "id x y z", "") + "\n \n" + frame(1, 1, "id x y z", "1 1 2 3\n"),
           {"x", "y", "z"});
  EXPECT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 2u);
  EXPECT_TRUE(whole.frames[0].block_atoms.empty());
}

TEST_F(DumpAtoms, TabsAndManyBlanksSeparateColumns) {
  const auto whole = read(frame(0, 2, "id q", "  1\t 2.5  \r\n\t2    -0.0\n"), {"q"});
  ASSERT_EQ(whole.error, "");
  EXPECT_EQ(whole.frames[0].real.at("q"), (Reals{2.5, -0.0}));
  EXPECT_TRUE(std::signbit(whole.frames[0].real.at("q")[1]));
}

TEST_F(DumpAtoms, NanInfinityAndOutOfRangeNumbersAreNumbers) {
  const auto whole = read(frame(0, 7, "q", "nan\n-nan\ninf\n-inf\n1e400\n1e-400\n5e-324\n"), {"q"});
  ASSERT_EQ(whole.error, "");
  const Reals& q = whole.frames[0].real.at("q");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isnan(q[0]) && std::isnan(q[1]));
  EXPECT_EQ(Reals(q.begin() + 2, q.end()), (Reals{infinity, -infinity, infinity, 0, 5e-324}));
}

TEST_F(DumpAtoms, WhatIsNotWantedIsNotConverted) {
  const auto whole = read(frame(0, 1, "element id c_s[1] q", "Si x ? 4\n"), {"q"});
  ASSERT_EQ(whole.error, "");
  EXPECT_EQ(whole.frames[0].real.at("q"), (Reals{4}));
}

TEST_F(DumpAtoms, TooFewColumnsNamesLineAndCounts) {
  for (const std::string short_line : {"2 1\n", "2 1   \n", "2 1\r\n"}) {
    const auto whole = read(frame(0, 3, "id type q", "1 1 1\n" + short_line + "3 1 1\n"), {"q"});
    EXPECT_TRUE(contains(whole.error, "dump:11: 2 columns (the header names 3)")) << whole.error;
  }
  const auto empty = read(frame(0, 1, "id type q", "\n"), {"q"});
  EXPECT_TRUE(contains(empty.error, "dump:10: 0 columns (the header names 3)")) << empty.error;
}

TEST_F(DumpAtoms, TokenThatIsNoNumberNamesLineAndColumn) {
  for (const std::string token : {"abc", "1.5x", "1,5", "--1", "0x10", "1e", ".", "ITEM:"}) {
    const auto whole = read(frame(0, 2, "id q", "1 1\n2 " + token + "\n"), {"q"});
    EXPECT_TRUE(contains(whole.error, "dump:11: '" + token + "' in column q")) << whole.error;
  }
  for (const std::string token : {"1.0", "9223372036854775808", "1e3", "x"}) {
    const auto whole = read(frame(0, 1, "id q", token + " 1\n"), {"id"});
    EXPECT_TRUE(contains(whole.error, "dump:10: '" + token + "' in column id")) << whole.error;
  }
}

TEST_F(DumpAtoms, MissingColumnIsNamed) {
  const std::string text = frame(0, 1, "id x y", "1 1 1\n");
  EXPECT_TRUE(contains(read(text, {"vx"}).error, "no column 'vx'"));
  EXPECT_TRUE(contains(read(text, {"x", "y", "z"}).error, "no position columns"));
}

TEST_F(DumpAtoms, WrongNumberOfAtomsIsNoticed) {
  const std::string good = "1 1\n2 2\n3 3\n", next = frame(1, 3, "id q", good);
  const auto too_small = read(frame(0, 2, "id q", good) + next, {"id", "q"});
  EXPECT_TRUE(contains(too_small.error, "is the number of atoms")) << too_small.error;
  const auto too_large = read(frame(0, 4, "id q", good) + next, {"id", "q"});
  EXPECT_FALSE(too_large.error.empty());
  EXPECT_TRUE(too_large.frames.empty());
  const auto at_end = read(frame(0, 4, "id q", good), {"id", "q"});
  EXPECT_TRUE(at_end.truncated) << at_end.error;
  EXPECT_TRUE(contains(at_end.error, "1 whole lines are missing")) << at_end.error;
}

}  // namespace
}  // namespace mdana
