// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/readers/gzipped.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::contains;

const std::string box_of_one = "box:\n  - [ 0, 1 ]\n  - [ 0, 1 ]\n  - [ 0, 1 ]\n";

std::string frame(int step, int atoms, const std::string& columns, const std::string& rows,
                  const std::string& box = box_of_one) {
  return "---\ncreator: LAMMPS\ntimestep: " + std::to_string(step) +
         "\nnatoms: " + std::to_string(atoms) + "\nboundary: [ p, p, f, f, p, f, ]\n" + box +
         "keywords: [ " + columns + " ]\ndata:\n" + rows + "...\n";
}

class YamlDump : public ::testing::Test {
 protected:
  test::WholeTrajectory read(const std::string& text, const ColumnSet& wanted) {
    return test::read_all(folder_.write("dump", text), wanted);
  }
  void expect_error(const std::string& text, const std::string& what) {
    const auto whole = read(text, {"q"});
    EXPECT_TRUE(contains(whole.error, what)) << whole.error << "\n" << text;
    EXPECT_FALSE(whole.truncated) << whole.error;
  }
  void expect_bad_row(const std::string& row, const std::string& what) {
    expect_error(frame(0, 2, "id, q,", "  - [ 1, 1, ]\n" + row), "dump:13: " + what);
  }
  test::TemporaryFolder folder_;
};

using Integers = std::vector<std::int64_t>;
using Reals = std::vector<double>;

TEST_F(YamlDump, HeaderOfLammps) {
  const auto whole = read(
      "---\ncreator: LAMMPS\ntimestep: 9000000000\nunits: real\ntime: 2.5e-3\nnatoms: 0\n"
      "boundary: [ p, p, f, f, s, m, ]\nthermo:\n  - keywords: [ Step, Temp, c_p[1], ]\n"
      "  - data: [ 9000000000, , -1, ]\nbox:\n  - [ -1.5, 9 ]\n  - [ 0, 8 ]\n"
      "  - [ 0, 10.25 ]\n  - [ 0.5, 0, -0.5 ]\nkeywords: [ id, type, c_s[1], f_a[2],  ]\n"
      "data:\n...\n", {});
  ASSERT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 1u);
  const FrameHeader& header = whole.frames[0].header;
  EXPECT_EQ(header.step, 9000000000);
  EXPECT_EQ(header.units, Units::real);
  EXPECT_EQ(header.time, 2.5e-3);
  EXPECT_EQ(header.columns, (std::vector<std::string>{"id", "type", "c_s[1]", "f_a[2]"}));
  EXPECT_EQ(header.box.periodic, (std::array{true, false, false}));
  const Box box = box_from_bounds({-1.5, 0, 0}, {9, 8, 10.25}, 0.5, 0, -0.5);
  EXPECT_EQ(header.box.edges, box.edges);
  EXPECT_EQ(header.box.origin, box.origin);
}

TEST_F(YamlDump, PeriodicOnlyIfBothFacesAre) {
  const auto whole = read(frame(0, 0, "id,", ""), {});
  ASSERT_EQ(whole.error, "");
  EXPECT_EQ(whole.frames[0].header.box.periodic, (std::array{true, false, false}));
}

TEST_F(YamlDump, RowsInAllSpellings) {
  const auto whole = read(frame(0, 7, "type, id, q,",
                                "  - [ 2, 9000000000000000001, 1.5, ]\n"
                                "  - [2,-7,-1.5]\n- [ 2 , 1 , -1e-3 , ] \r\n"
                                "\t-\t[ \t3,\t4,\t.5\t]\n  - [ 1, 2, nan, ]\n"
                                "  - [ '1', \"2\", '-2', ]\n  -  [1,2,3,]\n"),
                          {"id", "type", "q"});
  ASSERT_EQ(whole.error, "");
  const auto& atoms = whole.frames[0];
  EXPECT_EQ(atoms.integer.at("id"), (Integers{9000000000000000001, -7, 1, 4, 2, 2, 2}));
  EXPECT_EQ(atoms.integer.at("type"), (Integers{2, 2, 2, 3, 1, 1, 1}));
  const Reals& q = atoms.real.at("q");
  EXPECT_EQ(Reals(q.begin(), q.begin() + 4), (Reals{1.5, -1.5, -1e-3, 0.5}));
  EXPECT_EQ(Reals(q.begin() + 5, q.end()), (Reals{-2, 3}));
  EXPECT_NE(q[4], q[4]);
}

TEST_F(YamlDump, WordsQuotedOrNot) {
  const auto path = folder_.write(
      "dump", frame(0, 6, "id, element, q,",
                    "  - [ 1, Si, 1, ]\n  - [ 2, 'O', 1, ]\n  - [ 3, \"C\", 1, ]\n"
                    "  - [ 4, 'a,b', 1, ]\n  - [ 5, H5', 1, ]\n  - [ 6, c[1], 1, ]\n"));
  std::vector<std::string> elements;
  for_first_frame(path, {"element"}, [&](const AtomBlock& block) {
    const auto text = block.text("element");
    elements.assign(text.begin(), text.end());
  });
  EXPECT_EQ(elements, (std::vector<std::string>{"Si", "O", "C", "a,b", "H5'", "c[1]"}));
}

TEST_F(YamlDump, WhatIsNoRowNamesItsLine) {
  for (const std::string row : {"  [ 2, 2, ]\n", "  - 2, 2\n", "  - [ 2, 2, \n", "  - 2, 2 ]\n",
                                "  -[ 2, 2, ]\n", "\n", "...\n", "  - [\n", "  -\n", "-",
                                "ITEM: ATOMS\n"})
    expect_bad_row(row + (row.ends_with('\n') ? "" : "\n"), "'");
}

TEST_F(YamlDump, WrongNumberOfValuesNamesLineAndCounts) {
  expect_bad_row("  - [ 2, ]\n", "1 values (the header names 2 columns)");
  expect_bad_row("  - [ 2, 2, 2 ]\n", "3 values (the header names 2 columns)");
  expect_bad_row("  - [ ]\n", "0 values (the header names 2 columns)");
  expect_bad_row("  - [ 2 2 ]\n", "1 values (the header names 2 columns)");
  expect_bad_row("  - [ '2', 2, \"2\" ]\n", "3 values (the header names 2 columns)");
}

TEST_F(YamlDump, EmptyOrDoubleValuesAreNoValues) {
  expect_bad_row("  - [ 2, , ]\n", "a row with an empty value");
  expect_bad_row("  - [ , 2 ]\n", "a row with an empty value");
  expect_bad_row("  - [ 2, '2', , ]\n", "a row with an empty value");
  expect_bad_row("  - [ 2, 2 2 ]\n", "3 columns (the header names 2)");
  expect_bad_row("  - [ 2, '2 2' ]\n", "3 columns (the header names 2)");
  expect_bad_row("  - [ 2, 2 ] ]\n", "3 columns (the header names 2)");
}

TEST_F(YamlDump, WordThatIsNoNumberNamesLineAndColumn) {
  for (const std::string word : {"abc", "1.5x", "--1", "[1", "1]", "-", "''", "'x"})
    expect_bad_row("  - [ 2, " + word + " ]\n", "'" + word + "' in column q is not a number");
}

TEST_F(YamlDump, WrongNumberOfAtomsIsNoticed) {
  const std::string rows = "  - [ 1, 1 ]\n  - [ 2, 2 ]\n";
  expect_error(frame(0, 1, "id, q", rows), "is natoms of the frame before right?");
  expect_error(frame(0, 3, "id, q", rows) + frame(1, 2, "id, q", rows), "is natoms right?");
  const auto whole = read(frame(0, 4, "id, q", rows), {"q"});
  EXPECT_TRUE(whole.truncated) << whole.error;
}

TEST_F(YamlDump, BrokenHeadersNameTheirLine) {
  const std::string good = frame(0, 0, "id, q", "");
  const auto broken = [&](const std::string& from, const std::string& to, const std::string& what) {
    std::string text = good;
    ASSERT_NE(text.find(from), std::string::npos);
    text.replace(text.find(from), from.size(), to);
    expect_error(text, what);
  };
  broken("timestep: 0", "timestep: 1.5", "dump:3: '1.5' of 'timestep:' is not a whole number");
  broken("natoms: 0", "natoms: -1", "dump:4: '-1' of 'natoms:'");
  broken("natoms: 0\n", "", "no 'natoms:' before 'data:'");
  broken("natoms: 0\n", "natoms: 0\nnatoms: 0\n", "dump:5: 'natoms' stands twice");
  broken("natoms: 0\n", "natoms: 0\nsurprise: 1\n", "dump:5: 'surprise: 1' is not a line");
  broken("natoms: 0\n", "units: miles\nnatoms: 0\n", "dump:4: unknown units 'miles'");
  broken("natoms: 0\n", "time: soon\nnatoms: 0\n", "dump:4: 'soon' of 'time:' is not a number");
  broken("p, f, ]", "p, ]", "dump:5: six letters");
  broken("  - [ 0, 1 ]\n", "", "2 of 3 rows of bounds");
  broken("  - [ 0, 1 ]\n", "  - [ 0, 1, 2, 3 ]\n", "row 1 of 'box:' has 4 numbers, not 2");
  broken("  - [ 0, 1 ]\n", "  - [ 0, inf ]\n", "must be finite");
  broken("  - [ 0, 1 ]\n", "  - [ 1, 0 ]\n", "the bounds and tilts are no box");
  broken("  - [ 0, 1 ]\n", "  - [ 0, x ]\n", "'x' of 'box:' is not a number");
  broken("  - [ 0, 1 ]\n", "  - [ 0, 1\n", "is not a list [ ... ] on one line");
  broken("box:\n", "box: 1\n", "dump:6: a list expected below 'box:'");
  broken("[ id, q ]", "[ id, id ]", "column 'id' stands twice");
  broken("[ id, q ]", "[ ]", "names no columns");
  broken("[ id, q ]", "[ id, , q ]", "is not a list");
  broken("...\n", "...\n...\n", "dump:13: '...' where a frame should begin");
}

// Bounds that leave nothing for the edges once the tilts are taken off.
TEST_F(YamlDump, TiltsBeyondTheBoundsAreNoBox) {
  expect_error(frame(0, 0, "q", "", box_of_one + "  - [ 2, 0, 0 ]\n"), "are no box");
  expect_error(frame(0, 0, "q", "", box_of_one + "  - [ 0, 0 ]\n"), "row 4 of 'box:' has 2");
  expect_error(frame(0, 0, "q", "", box_of_one + box_of_one.substr(5)), "is not an item of 'box:'");
}

TEST_F(YamlDump, FramesWithoutTheirEndMayFollowEachOther) {
  std::string first = frame(0, 1, "q", "  - [ 1 ]\n");
  first.resize(first.size() - 4);
  const auto whole = read("# by hand\n\n" + first + frame(1, 1, "q", "  - [ 2 ]\n") + "\n# end\n",
                          {"q"});
  EXPECT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 2u);
  EXPECT_EQ(whole.frames[1].real.at("q"), (Reals{2}));
}

TEST_F(YamlDump, ManyBlocksKeepTheirLines) {
  constexpr int atoms = 3 * static_cast<int>(AtomBlock::capacity) / 2;
  std::string rows;
  for (int i = 0; i < atoms; ++i) rows += "  - [ " + std::to_string(i) + ", -0.5, ]\n";
  const auto whole = read(frame(0, atoms, "id, q,", rows), {"id", "q"});
  ASSERT_EQ(whole.error, "");
  const auto& id = whole.frames[0].integer.at("id");
  for (std::size_t i = 0; i < id.size(); ++i) ASSERT_EQ(id[i], static_cast<std::int64_t>(i));
  EXPECT_EQ(whole.frames[0].real.at("q"), Reals(id.size(), -0.5));
  rows += "  - [ 1, x, ]\n";
  EXPECT_TRUE(contains(read(frame(0, atoms + 1, "id, q,", rows), {"q"}).error,
                       "dump:" + std::to_string(12 + atoms) + ": 'x' in column q"));
}

const std::string end_of_frame = "...\n";
const std::string three_frames =
    frame(100, 2, "id, type, xs, ys, zs, fx,",
          "  - [ 12, 1, 0.125, 0.25, 0.5, -1.25e-3, ]\n  - [ 7, 2, 0.75, 0.5, 0.25, 123.456, ]\n") +
    frame(200, 1, "id, type, xs, ys, zs, fx,", "  - [ 7, 2, 0.76, 0.51, 0.26, '-77.125', ]\r\n") +
    frame(300, 1, "id, type, xs, ys, zs, fx,", "  - [ 7, 2, 0.77, 0.52, 0.27, 12345678, ]\n");
const ColumnSet wanted{"id", "type", "x", "y", "z", "fx"};

void expect_beginning(const test::WholeTrajectory& cut, const test::WholeTrajectory& whole) {
  ASSERT_LE(cut.frames.size(), whole.frames.size());
  for (std::size_t i = 0; i < cut.frames.size(); ++i) {
    EXPECT_EQ(cut.frames[i].header.step, whole.frames[i].header.step);
    EXPECT_EQ(cut.frames[i].header.box.edges, whole.frames[i].header.box.edges);
    EXPECT_EQ(cut.frames[i].real, whole.frames[i].real);
    EXPECT_EQ(cut.frames[i].integer, whole.frames[i].integer);
  }
}

/// Frames whose rows are all among the bytes, newlines included.
std::size_t whole_frames(std::size_t bytes) {
  std::size_t count = 0;
  for (std::size_t end = three_frames.find(end_of_frame); end <= bytes;
       end = three_frames.find(end_of_frame, end + 1))
    ++count;
  return count;
}

TEST_F(YamlDump, CutAtEveryByteGivesWholeFramesOrSaysSo) {
  const auto whole = read(three_frames, wanted);
  ASSERT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 3u);
  const std::size_t recognised = std::string("---\ncreator: LAMMPS").size();
  for (std::size_t bytes = 0; bytes <= three_frames.size(); ++bytes) {
    SCOPED_TRACE(bytes);
    const auto cut = read(three_frames.substr(0, bytes), wanted);
    expect_beginning(cut, whole);
    EXPECT_EQ(cut.frames.size(), bytes >= recognised ? whole_frames(bytes) : 0);
    const bool between = three_frames.substr(0, bytes).ends_with(end_of_frame);
    EXPECT_EQ(cut.error.empty(), between) << cut.error;
    EXPECT_EQ(cut.truncated, bytes >= recognised && !between) << cut.error;
  }
}

TEST_F(YamlDump, GzipCutAtEveryByteGivesWholeFramesAndSaysSo) {
  const auto whole = read(three_frames, wanted);
  for (const int level : {0, 6}) {  // stored (every byte comes through) and deflated
    const std::string packed = test::gzipped(three_frames, level);
    EXPECT_EQ(read(packed, wanted).frames.size(), 3u);
    for (std::size_t bytes = 0; bytes < packed.size(); ++bytes) {
      SCOPED_TRACE(bytes);
      const auto cut = read(packed.substr(0, bytes), wanted);
      expect_beginning(cut, whole);
      EXPECT_FALSE(cut.error.empty());
    }
  }
}

TEST_F(YamlDump, CarriageReturnsChangeNothing) {
  std::string windows;
  for (const char c : three_frames) windows += c == '\n' ? "\r\n" : std::string(1, c);
  const auto whole = read(windows, wanted);
  ASSERT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 3u);
  expect_beginning(whole, read(three_frames, wanted));
}

}  // namespace
}  // namespace mdana
