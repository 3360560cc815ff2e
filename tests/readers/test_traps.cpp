// SPDX-License-Identifier: GPL-3.0-or-later
// What readers of dumps are known to get wrong, each with an answer worked out by hand.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "readers/bodies.hpp"
#include "tests/readers/gzipped.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::contains;

using Integers = std::vector<std::int64_t>;
using Reals = std::vector<double>;

const std::string cube = "ff ff ff\n0 1\n0 1\n0 1\n";

/// A frame without ITEM: UNITS and ITEM: TIME.
std::string frame(int step, int atoms, const std::string& box, const std::string& columns,
                  const std::string& lines) {
  return "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ATOMS\n" +
         std::to_string(atoms) + "\nITEM: BOX BOUNDS " + box + "ITEM: ATOMS " + columns + "\n" + lines;
}

class Traps : public ::testing::Test {
 protected:
  test::WholeTrajectory read(const std::string& text, const ColumnSet& wanted) {
    return test::read_all(folder_.write("dump", text), wanted);
  }

  /// x, y, z of the only atom of the only frame.
  Reals place(const std::string& box, const std::string& columns, const std::string& line) {
    const auto whole = read(frame(0, 1, box, columns, line + "\n"), {"x", "y", "z"});
    EXPECT_EQ(whole.error, "");
    const auto& real = whole.frames.at(0).real;
    return {real.at("x").at(0), real.at("y").at(0), real.at("z").at(0)};
  }
  test::TemporaryFolder folder_;
};

// Corner (1, 2, 3), edges (8, 0, 0), (2, 4, 0), (-1, 1, 16). The corners with the least and greatest
// x are 1 - 1 and 1 + 8 + 2, those of y 2 and 2 + 4 + 1. The middle of the box is
// (1 + 4 + 1 - 0.5, 2 + 2 + 0.5, 3 + 8); that of the bounds of x would also be 5.5, but a quarter
// along the first edge is 2 away from the corner, and 2.75 along the bounds.
TEST_F(Traps, TiltedBoxIsNotItsBounds) {
  const std::string box = "xy xz yz pp pp pp\n0 11 2\n2 7 -1\n3 19 1\n";
  EXPECT_EQ(place(box, "xs ys zs", "0.5 0.5 0.5"), (Reals{5.5, 4.5, 11}));
  EXPECT_EQ(place(box, "xs ys zs", "0.25 0 0"), (Reals{3, 2, 3}));
  EXPECT_EQ(place(box, "xs ys zs", "0 0.5 0"), (Reals{2, 4, 3}));
  EXPECT_EQ(place(box, "xs ys zs", "0 0 0.5"), (Reals{0.5, 2.5, 11}));
  EXPECT_EQ(place(box, "x y z ix iy iz", "5 5 5 1 -1 2"),
            (Reals{5 + 8 - 2 - 2, 5 - 4 + 2, 5 + 2 * 16}));
}

// Rows are a, b, c with the origin's components behind them: not bounds and a tilt.
TEST_F(Traps, AbcOriginIsNotBoundsAndTilts) {
  const std::string box = "abc origin pp pp pp\n0 4 0 10\n-8 2 0 20\n1 1 16 30\n";
  EXPECT_EQ(place(box, "xs ys zs", "0.5 0 0"), (Reals{10, 22, 30}));
  EXPECT_EQ(place(box, "xs ys zs", "0 0.5 0"), (Reals{6, 21, 30}));
  EXPECT_EQ(place(box, "xs ys zs", "0 0 0.5"), (Reals{10.5, 20.5, 38}));
  EXPECT_EQ(place(box, "x y z ix iy iz", "0 0 0 1 1 -1"), (Reals{-9, 5, -16}));
}

TEST_F(Traps, BoxOriginIsAddedToScaledPositions) {
  const std::string box = "pp pp pp\n-4 4\n100 116\n0.5 1\n";
  EXPECT_EQ(place(box, "xs ys zs", "0.75 0.25 0.5"), (Reals{2, 104, 0.75}));
  EXPECT_EQ(place(box, "xsu ysu zsu", "1.75 -0.75 0.5"), (Reals{10, 88, 0.75}));
  EXPECT_EQ(place(box, "xs ys zs ix iy iz", "0.75 0.25 0.5 1 -1 0"), (Reals{10, 88, 0.75}));
  EXPECT_EQ(place(box, "x y z", "0.75 0.25 0.5"), (Reals{0.75, 0.25, 0.5}));  // are not scaled
}

TEST_F(Traps, ScaledPositionsInBoxesOfNanometresAndMetres) {
  const std::string box = "pp pp pp\n-1e-9 3e-9\n0 2e-8\n1e-9 2e-9\n";
  const Reals found = place(box, "xs ys zs", "0.5 0.5 0");
  EXPECT_NEAR(found[0], 1e-9, 1e-24);  // ten roundings of 3e-9
  EXPECT_NEAR(found[1], 1e-8, 1e-23);
  EXPECT_EQ(found[2], 1e-9);
}

// 2^32 + 1 would be 1 in 32 bits, and 2^53 + 1 is no double.
TEST_F(Traps, IdsAbove32And53Bits) {
  const auto whole = read(frame(0, 4, cube, "id q", "4294967297 1\n1 2\n9007199254740993 3\n"
                                "9223372036854775807 4\n"), {"id", "q"});
  ASSERT_EQ(whole.error, "");
  EXPECT_EQ(whole.frames[0].integer.at("id"),
            (Integers{4294967297, 1, 9007199254740993, std::numeric_limits<std::int64_t>::max()}));
  EXPECT_EQ(whole.frames[0].real.at("q"), (Reals{1, 2, 3, 4}));
}

// An id is a name, not a place: these would lie far outside an array of four atoms.
TEST_F(Traps, IdsWithGapsAndZero) {
  const auto path = folder_.write(
      "dump", frame(0, 4, cube, "id type x y z", "7000000000 1 4 0 0\n0 1 5 0 0\n-3 2 6 0 0\n12 2 7 0 0\n"));
  const auto whole = test::read_all(path, {"id", "x", "y", "z"});
  ASSERT_EQ(whole.error, "");
  EXPECT_EQ(whole.frames[0].integer.at("id"), (Integers{7000000000, 0, -3, 12}));
  EXPECT_EQ(whole.frames[0].real.at("x"), (Reals{4, 5, 6, 7}));
  const Bodies bodies = find_bodies(path, first_header(path), "id:0-12");
  std::vector<BodyIndex> body;
  for_first_frame(path, bodies.columns(), [&](const AtomBlock& block) { bodies.label(block, body); });
  EXPECT_EQ(body, (std::vector<BodyIndex>{2, 1, 2, 1}));
}

// Two frames are whole, of the third the last number may be cut: 12 is not 123.
TEST_F(Traps, LastFrameTruncatedIsNoFrame) {
  const std::string two = frame(0, 2, cube, "id q", "1 10\n2 20\n") + frame(1, 2, cube, "id q", "2 21\n1 11\n");
  for (const std::string last : {"1 12\n2 12", "1 12\n2", "1 12\n", ""}) {
    const auto whole = read(two + frame(2, 2, cube, "id q", last), {"id", "q"});
    EXPECT_EQ(whole.frames.size(), 2u) << last;
    EXPECT_TRUE(whole.truncated) << last;
    EXPECT_TRUE(contains(whole.error, "frame 2")) << whole.error;
  }
}

TEST_F(Traps, NanAndInfinityAreReadAsSuch) {
  const auto whole = read(frame(0, 6, cube, "q", "nan\n-nan\ninf\n-inf\nNaN\nInf\n"), {"q"});
  ASSERT_EQ(whole.error, "");
  const Reals& q = whole.frames[0].real.at("q");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isnan(q[0]) && std::isnan(q[1]) && std::isnan(q[4]));
  EXPECT_EQ(q[2], infinity);
  EXPECT_EQ(q[3], -infinity);
  EXPECT_EQ(q[5], infinity);
}

// LAMMPS states the units once, before the first frame, and the time before each.
TEST_F(Traps, UnitsAndTimeHeaders) {
  const auto whole = read("ITEM: UNITS\nmetal\nITEM: TIME\n0.5\n" + frame(10, 1, cube, "id", "1\n") +
                          "ITEM: TIME\n0.75\n" + frame(15, 1, cube, "id", "2\n") +
                          frame(20, 1, cube, "id", "3\n"), {"id"});
  ASSERT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 3u);
  EXPECT_EQ(whole.frames[0].header.units, Units::metal);
  EXPECT_EQ(whole.frames[0].header.time, 0.5);
  EXPECT_EQ(whole.frames[1].header.time, 0.75);
  EXPECT_EQ(whole.frames[2].header.time, std::nullopt);
  EXPECT_EQ(whole.frames[1].header.step, 15);
  EXPECT_EQ(whole.frames[2].integer.at("id"), (Integers{3}));
}

TEST_F(Traps, ColumnsAndNumberOfAtomsChangeBetweenFrames) {
  const auto whole = read(frame(0, 2, cube, "id vx x y z", "1 10 1 2 3\n2 20 4 5 6\n") +
                          frame(1, 1, cube, "z y x q vx id", "9 8 7 ? 70 3\n") +
                          frame(2, 0, cube, "id vx x y z", "") +
                          frame(3, 3, cube, "xu yu zu id vx x", "1 0 0 1 11 0\n2 0 0 2 22 0\n3 0 0 3 33 0\n"),
                          {"id", "vx", "x", "y", "z"});
  ASSERT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 4u);
  EXPECT_EQ(whole.frames[0].real.at("vx"), (Reals{10, 20}));
  EXPECT_EQ(whole.frames[1].real.at("vx"), (Reals{70}));
  EXPECT_EQ(whole.frames[1].real.at("x"), (Reals{7}));
  EXPECT_EQ(whole.frames[1].real.at("z"), (Reals{9}));
  EXPECT_EQ(whole.frames[2].header.atoms, 0u);
  EXPECT_EQ(whole.frames[3].real.at("vx"), (Reals{11, 22, 33}));
  EXPECT_EQ(whole.frames[3].real.at("x"), (Reals{1, 2, 3}));
}

std::string with_crlf(const std::string& text) {
  std::string crlf;
  for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return crlf;
}

// The last column's name, the last value of a line, words and numbers of the header.
TEST_F(Traps, Crlf) {
  const auto whole = read(with_crlf("ITEM: UNITS\nsi\nITEM: TIME\n2\n" +
                                    frame(5, 2, "pp pp pp\n0 8\n0 1\n0 2\n", "id xs ys zs",
                                          "1 0.5 0.5 0.5\n2 0.25 0.5 1\n")), {"id", "x", "y", "z"});
  ASSERT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 1u);
  EXPECT_EQ(whole.frames[0].header.columns, (std::vector<std::string>{"id", "xs", "ys", "zs"}));
  EXPECT_EQ(whole.frames[0].header.units, Units::si);
  EXPECT_EQ(whole.frames[0].header.box.periodic, (std::array<bool, 3>{true, true, true}));
  EXPECT_EQ(whole.frames[0].real.at("x"), (Reals{4, 2}));
  EXPECT_EQ(whole.frames[0].real.at("z"), (Reals{1, 2}));
}

TEST_F(Traps, CommentLines) {
  const std::string one = frame(1, 1, cube, "id q", "1 10\n"), two = frame(2, 1, cube, "id q", "2 20\n");
  const auto whole = read("# of a run\n#\n" + one + "# ITEM: TIMESTEP\n\n" + two + "# end\n", {"id", "q"});
  ASSERT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 2u);
  EXPECT_EQ(whole.frames[1].real.at("q"), (Reals{20}));
  // Among the atoms it is no comment: LAMMPS writes none there, and an atom may be lost behind it.
  EXPECT_TRUE(contains(read(frame(0, 2, cube, "id q", "1 10\n# 2 20\n"), {"q"}).error, "dump:11: "));
}

// Pieces are parts of each frame, not frames: three atoms in two frames, not six frames of one.
TEST_F(Traps, PercentPiecesAreOneFrame) {
  for (int k = 0; k < 3; ++k)
    folder_.write("d." + std::to_string(k),
                  frame(0, k, cube, "id", k == 0 ? "" : k == 1 ? "5\n" : "3\n4\n") +
                      frame(7, 1, cube, "id", std::to_string(10 * k) + "\n"));
  const auto whole = test::read_all(folder_.path() / "d.%", {"id"});
  ASSERT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 2u);
  EXPECT_EQ(whole.frames[0].integer.at("id"), (Integers{5, 3, 4}));
  EXPECT_EQ(whole.frames[1].integer.at("id"), (Integers{0, 10, 20}));
  EXPECT_EQ(whole.frames[1].header.atoms, 3u);
  EXPECT_EQ(whole.frames[1].header.step, 7);
}

// Numbers of pieces that are missing are told. Of the last piece of every step nothing tells that it
// was ever there (LAMMPS writes no count of them): what is there is read.
TEST_F(Traps, PercentPiecesThatAreMissing) {
  const auto write = [&](const std::string& name, int step) {
    return folder_.write(name, frame(step, 1, cube, "id", "1\n"));
  };
  for (const char* name : {"gap.0", "gap.2", "first.1", "last.0", "last.1"}) write(name, 0);
  const auto error = [&](const std::string& name) { return test::read_all(folder_.path() / name, {"id"}).error; };
  EXPECT_TRUE(contains(error("gap.%"), "piece 1 is missing")) << error("gap.%");
  EXPECT_TRUE(contains(error("first.%"), "piece 0 is missing")) << error("first.%");
  EXPECT_EQ(error("last.%"), "");
  for (const int step : {5, 6, 7})
    for (int k = 0; k < (step == 6 ? 2 : 3); ++k) write("n." + std::to_string(k) + "." + std::to_string(step), step);
  EXPECT_TRUE(contains(error("n.%.*"), "piece 2 is missing")) << error("n.%.*");
  EXPECT_TRUE(contains(error("n.%.*"), "n.1.6")) << error("n.%.*");
}

// The frames are as long as each other when packed: three quarters end within the second one.
TEST_F(Traps, TruncatedGzipIsNotAWholeDump) {
  std::string squares, others;
  for (int id = 1; id <= 2000; ++id) {
    squares += std::to_string(id) + " " + std::to_string(id * id) + "\n";
    others += std::to_string(id + 2000) + " " + std::to_string(7 * id * id) + "\n";
  }
  const std::string text = frame(0, 2000, cube, "id q", squares) + frame(1, 2000, cube, "id q", others);
  const std::string packed = test::gzipped(text);
  const auto part = test::read_all(folder_.write("part.gz", packed.substr(0, packed.size() * 3 / 4)), {"id", "q"});
  ASSERT_EQ(part.frames.size(), 1u);
  EXPECT_EQ(part.frames[0].real.at("q").back(), 4e6);
  EXPECT_TRUE(part.truncated);
  EXPECT_TRUE(contains(part.error, "part.gz")) << part.error;
  const auto unchecked = test::read_all(folder_.write("unchecked.gz", packed.substr(0, packed.size() - 5)), {"id", "q"});
  EXPECT_TRUE(unchecked.truncated) << "without its check sum nobody knows";
}

TEST_F(Traps, DuplicateIdColumn) {
  const std::string text = frame(0, 1, cube, "id type x y z id", "1 1 0 0 0 2\n");
  const auto whole = read(text, {"x", "y", "z"});
  EXPECT_TRUE(whole.frames.empty());
  EXPECT_TRUE(contains(whole.error, "dump:9: column 'id' stands twice")) << whole.error;
}

}  // namespace
}  // namespace mdana
