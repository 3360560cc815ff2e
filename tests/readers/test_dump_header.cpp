// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::contains;

const std::string bounds = "ITEM: BOX BOUNDS pp ff sm\n0 1\n-2 3\n0 1e-9\n";
const std::string one_atom = "ITEM: ATOMS id x y z \n1 0.5 0.25 0.125 \n";
const std::string step = "ITEM: TIMESTEP\n42\n", atoms = "ITEM: NUMBER OF ATOMS\n1\n";

class DumpHeader : public ::testing::Test {
 protected:
  test::WholeTrajectory read(const std::string& text) {
    return test::read_all(folder_.write("dump", text), {"x", "y", "z"});
  }
  FrameHeader header(const std::string& text) {
    const auto whole = read(text);
    EXPECT_EQ(whole.error, "") << text;
    return whole.frames.at(0).header;
  }
  std::string error(const std::string& text) { return read(text).error; }
  test::TemporaryFolder folder_;
};

TEST_F(DumpHeader, StatesStepAtomsBoxAndColumns) {
  const FrameHeader h = header(step + atoms + bounds + one_atom);
  EXPECT_EQ(h.step, 42);
  EXPECT_EQ(h.atoms, 1u);
  EXPECT_EQ(h.index, 0u);
  EXPECT_EQ(h.columns, (std::vector<std::string>{"id", "x", "y", "z"}));
  EXPECT_EQ(h.box.periodic, (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(h.box.origin, Eigen::Vector3d(0, -2, 0));
  EXPECT_EQ(h.box.edges(2, 2), 1e-9);
  EXPECT_FALSE(h.time.has_value());
  EXPECT_FALSE(h.units.has_value());
  EXPECT_TRUE(contains(h.place, "dump:9 (frame 0, step 42)")) << h.place;
}

TEST_F(DumpHeader, TimeAndUnitsInAnyOrder) {
  const std::string stated = "ITEM: UNITS\nmetal\nITEM: TIME\n0.0625\n";
  for (const std::string& text : {stated + step + atoms + bounds, step + stated + atoms + bounds,
                                  bounds + atoms + step + stated}) {
    const FrameHeader h = header(text + one_atom);
    EXPECT_EQ(h.time, 0.0625);
    EXPECT_EQ(h.units, Units::metal);
  }
}

TEST_F(DumpHeader, OldBoundsHaveNoBoundaryWords) {
  for (const std::string flags : {"", " xy xz yz"}) {
    const std::string tilt = flags.empty() ? "" : " 0";
    const FrameHeader h = header(step + atoms + "ITEM: BOX BOUNDS" + flags + "\n0 1" + tilt +
                                 "\n0 1" + tilt + "\n0 1" + tilt + "\n" + one_atom);
    EXPECT_FALSE(h.box.any_periodic()) << flags;
  }
}

// LAMMPS manual, command dump: rows a, b, c with the origin's components at their ends.
TEST_F(DumpHeader, GeneralTriclinicBox) {
  const FrameHeader h =
      header(step + atoms +
             "ITEM: BOX BOUNDS abc origin pp ff pp\n1 2 3 10\n-4 5 6 20\n7 8 -9 30\n" + one_atom);
  EXPECT_EQ(h.box.origin, Eigen::Vector3d(10, 20, 30));
  EXPECT_EQ(h.box.position({1, 0, 0}), Eigen::Vector3d(11, 22, 33));
  EXPECT_EQ(h.box.position({0, 1, 0}), Eigen::Vector3d(6, 25, 36));
  EXPECT_EQ(h.box.position({0, 0, 1}), Eigen::Vector3d(17, 28, 21));
  EXPECT_EQ(h.box.periodic, (std::array<bool, 3>{true, false, true}));
}

TEST_F(DumpHeader, CrlfReadsTheSame) {
  std::string text = step + "ITEM: UNITS\nsi\n" + atoms + bounds + one_atom, crlf;
  for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const auto plain = read(text), with_cr = read(crlf);
  ASSERT_EQ(with_cr.error, "");
  EXPECT_EQ(with_cr.frames[0].header.columns, plain.frames[0].header.columns);
  EXPECT_EQ(with_cr.frames[0].header.units, Units::si);
  EXPECT_EQ(with_cr.frames[0].real, plain.frames[0].real);
}

TEST_F(DumpHeader, MissingSectionIsNamed) {
  EXPECT_TRUE(contains(error(atoms + bounds + one_atom), "no ITEM: TIMESTEP"));
  EXPECT_TRUE(contains(error(step + bounds + one_atom), "no ITEM: NUMBER OF ATOMS"));
  EXPECT_TRUE(contains(error(step + atoms + one_atom), "no ITEM: BOX BOUNDS"));
  EXPECT_TRUE(contains(error(step + atoms + bounds + "ITEM: ATOMS\n1 1 1 1\n"), "no columns"));
}

TEST_F(DumpHeader, WrongValuesAreNamedWithTheirLine) {
  const struct {
    std::string text, what;
  } cases[] = {
      {"ITEM: TIMESTEP\n4.5\n", "dump:2: '4.5' is not a whole number"},
      {"ITEM: TIMESTEP\n9223372036854775808\n", "dump:2"},
      {"ITEM: TIMESTEP\n1 2\n", "one value expected below ITEM: TIMESTEP"},
      {step + "ITEM: NUMBER OF ATOMS\n-1\n", "dump:4: '-1'"},
      {step + "ITEM: UNITS\nfurlong\n", "dump:4: unknown units 'furlong'"},
      {step + "ITEM: TIME\nnow\n", "dump:4: 'now' is not a number"},
      {step + "ITEM: BOX BOUNDS pp pp pp\n0 1\n0 x\n", "dump:5: 'x' is not a number"},
      {step + "ITEM: BOX BOUNDS pp pp pp\n0 1 0\n", "dump:4: 2 numbers expected"},
      {step + "ITEM: BOX BOUNDS xy xz yz pp pp pp\n0 1\n", "dump:4: 3 numbers expected"},
      {step + "ITEM: BONDS\n", "dump:3: 'ITEM: BONDS' is not a section"},
  };
  for (const auto& c : cases) EXPECT_TRUE(contains(error(c.text), c.what)) << error(c.text);
}

TEST_F(DumpHeader, BoundsThatAreNoBoxAreErrors) {
  for (const std::string line : {"nan 1", "0 inf", "1 0"})
    EXPECT_TRUE(contains(
        error(step + atoms + "ITEM: BOX BOUNDS pp pp pp\n" + line + "\n0 1\n0 1\n" + one_atom),
        "dump:6"))
        << line;
}

TEST_F(DumpHeader, CommentsAndBlankLinesBeforeAFrame) {
  const std::string frame = atoms + bounds + one_atom;
  const auto whole = read("# made by hand\n\n# twice\n" + step + frame + "# between\n \n" + step +
                          frame + "#\n");
  EXPECT_EQ(whole.error, "");
  EXPECT_EQ(whole.frames.size(), 2u);
}

TEST_F(DumpHeader, DuplicateColumnIsAnError) {
  const std::string text = error(step + atoms + bounds + "ITEM: ATOMS id x y z x\n1 0 0 0 1\n");
  EXPECT_TRUE(contains(text, "dump:9: column 'x' stands twice")) << text;
}

TEST_F(DumpHeader, StepsBeyondTheDoubleIntegersSurvive) {
  for (const std::string text : {"9007199254740993", "-9007199254740993", "9223372036854775807"})
    EXPECT_EQ(header("ITEM: TIMESTEP\n" + text + "\n" + atoms + bounds + one_atom).step,
              std::stoll(text));
}

}  // namespace
}  // namespace mdana
