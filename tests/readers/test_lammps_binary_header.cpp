// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "tests/readers/binary_dump.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::BinaryFrame;
using test::contains;

constexpr std::endian orders[] = {std::endian::little, std::endian::big};

class BinaryHeader : public ::testing::Test {
 protected:
  test::WholeTrajectory read(const std::string& bytes) {
    return test::read_all(folder_.write("dump.bin", bytes), {"x", "y", "z"});
  }
  FrameHeader header(const BinaryFrame& frame, std::endian order) {
    const auto whole = read(frame.bytes(order));
    EXPECT_EQ(whole.error, "");
    return whole.frames.at(0).header;
  }
  /// The frame after `change` must be refused, and not as cut short.
  void refused(const std::function<void(BinaryFrame&)>& change, const std::string& says) {
    BinaryFrame frame;
    frame.ranks = {{1, 0.5, 0.25, 0.125}};
    change(frame);
    for (const std::endian order : orders) {
      const auto whole = read(frame.bytes(order));
      EXPECT_TRUE(contains(whole.error, says)) << "'" << says << "' is missing in: " << whole.error;
      EXPECT_TRUE(contains(whole.error, "dump.bin: ")) << whole.error;
      EXPECT_FALSE(whole.truncated) << whole.error;
      EXPECT_TRUE(whole.frames.empty());
    }
  }
  test::TemporaryFolder folder_;
};

TEST_F(BinaryHeader, StatesEverything) {
  BinaryFrame frame;
  frame.step = 5'000'000'000;
  frame.boundary = {0, 0, 2, 3, 1, 1};
  frame.box = {0, 1, -2, 3, 0, 1e-9};
  frame.units = "metal";
  frame.time_flag = 1;
  frame.time = 0.0625;
  frame.ranks = {{7, 0.5, 0.25, 0.125}};
  for (const std::endian order : orders) {
    const FrameHeader h = header(frame, order);
    EXPECT_EQ(h.step, 5'000'000'000);
    EXPECT_EQ(h.atoms, 1u);
    EXPECT_EQ(h.index, 0u);
    EXPECT_EQ(h.columns, (std::vector<std::string>{"id", "x", "y", "z"}));
    EXPECT_EQ(h.box.periodic, (std::array<bool, 3>{true, false, false}));
    EXPECT_EQ(h.box.origin, Eigen::Vector3d(0, -2, 0));
    EXPECT_EQ(h.box.edges, Eigen::Matrix3d(Eigen::Vector3d(1, 5, 1e-9).asDiagonal()));
    EXPECT_EQ(h.time, 0.0625);
    EXPECT_EQ(h.units, Units::metal);
    EXPECT_TRUE(contains(h.place, "dump.bin (frame 0, step 5000000000)")) << h.place;
  }
}

TEST_F(BinaryHeader, MayLeaveOutTimeAndUnits) {
  BinaryFrame frame;
  frame.name = "DUMPATOM";
  for (const std::endian order : orders) {
    const FrameHeader h = header(frame, order);
    EXPECT_FALSE(h.time.has_value());
    EXPECT_FALSE(h.units.has_value());
    EXPECT_EQ(h.atoms, 0u);
  }
}

TEST_F(BinaryHeader, TiltedBoxIsThatOfTheSameTextDump) {
  BinaryFrame frame;
  frame.triclinic = 1;
  frame.box = {-1, 9, 0, 8, 0, 10.25, 0.5, 0, -0.5};
  for (const std::endian order : orders) {
    const Box box = header(frame, order).box;
    const Box wanted = box_from_bounds({-1, 0, 0}, {9, 8, 10.25}, 0.5, 0, -0.5);
    EXPECT_EQ(box.edges, wanted.edges);
    EXPECT_EQ(box.origin, wanted.origin);
  }
}

// dump_modify triclinic/general: edges a, b, c, then the origin.
TEST_F(BinaryHeader, GeneralTriclinicBox) {
  BinaryFrame frame;
  frame.triclinic = 2;
  frame.box = {1, 2, 3, -4, 5, 6, 7, 8, -9, 10, 20, 30};
  for (const std::endian order : orders) {
    const Box box = header(frame, order).box;
    EXPECT_EQ(box.origin, Eigen::Vector3d(10, 20, 30));
    EXPECT_EQ(box.position({1, 0, 0}), Eigen::Vector3d(11, 22, 33));
    EXPECT_EQ(box.position({0, 1, 0}), Eigen::Vector3d(6, 25, 36));
    EXPECT_EQ(box.position({0, 0, 1}), Eigen::Vector3d(17, 28, 21));
  }
}

TEST_F(BinaryHeader, WrongFieldsAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](auto& f) { f.name = "DUMPGRID"; }, "'DUMPGRID'");
  refused([](auto& f) { f.name = "DUMP\x01X"; }, "'DUMP?X'");
  refused([](auto& f) { f.order_mark = 0x01000000; },
          "byte 22: the mark of the byte order is 0x1000000");
  refused([](auto& f) { f.revision = 0; }, "revision 0");
  refused([](auto& f) { f.revision = 3; }, "revision 3");
  refused([](auto& f) { f.natoms = -1; }, "number of atoms is -1");
  refused([](auto& f) { f.triclinic = 3; }, "box is of kind 3");
  refused([](auto& f) { f.triclinic = -1; }, "box is of kind -1");
  refused([](auto& f) { f.boundary[3] = 4; }, "boundaries of kind 1 and 4");
  refused([](auto& f) { f.boundary[0] = -1; }, "boundaries of kind -1");
  refused([](auto& f) { f.box[1] = 0; }, "upper bound");
  refused([&](auto& f) { f.box[2] = nan; }, "bound of the box is nan");
  refused(
      [&](auto& f) {
        f.triclinic = 1;
        f.box.insert(f.box.end(), {0, nan, 0});
      },
      "tilt of the box");
  refused(
      [](auto& f) {
        f.triclinic = 1;
        f.box.insert(f.box.end(), {5, 0, 0});
      },
      "no box");
  refused(
      [](auto& f) {
        f.triclinic = 2;
        f.box.assign(12, 1);
      },
      "no box");
  refused([](auto& f) { f.units = "furlong"; }, "unknown units 'furlong'");
  refused([](auto& f) { f.units_length = -1; }, "the units in -1 bytes");
  refused([](auto& f) { f.units_length = 2'000'000'000; }, "the units in 2000000000 bytes");
  refused([](auto& f) { f.time_flag = 2; }, "stated time is 2");
  refused(
      [&](auto& f) {
        f.time_flag = 1;
        f.time = nan;
      },
      "time is nan");
  refused([](auto& f) { f.columns_length = 2'000'000'000; }, "columns in 2000000000 bytes");
  refused([](auto& f) { f.columns_length = -5; }, "columns in -5 bytes");
  refused([](auto& f) { f.columns = "id x y x"; }, "'x' stands twice");
  refused([](auto& f) { f.size_one = 5; }, "4 columns are named, but an atom has 5 numbers");
  refused([](auto& f) { f.size_one = -4; }, "an atom has -4 numbers");
  refused([](auto& f) { f.size_one = 2'000'000'000; }, "an atom has 2000000000 numbers");
  refused([](auto& f) { f.nchunk = 0; }, "0 blocks");
  refused([](auto& f) { f.nchunk = -1; }, "-1 blocks");
}

TEST_F(BinaryHeader, NamelessColumnsAreRefused) {
  const std::string says = "does not name its columns";
  refused([](auto& f) { f.columns = ""; }, says);
  refused([](auto& f) { f.revision = 1; }, says);
  BinaryFrame frame;
  frame.ranks = {{1, 0.5, 0.25, 0.125}};
  for (const std::int32_t triclinic : {0, 1}) {
    frame.triclinic = triclinic;
    if (triclinic) frame.box.insert(frame.box.end(), {0, 0, 0});
    for (const std::endian order : orders)
      EXPECT_TRUE(contains(read(frame.old_header(order) + "atoms").error, says));
  }
}

TEST_F(BinaryHeader, FramesAfterTheFirstMustHaveOneToo) {
  BinaryFrame frame;
  frame.ranks = {{1, 0.5, 0.25, 0.125}};
  for (const std::string& garbage :
       {std::string(200, '\0'), std::string(200, 'D'), frame.old_header()}) {
    const auto whole = read(frame.bytes() + garbage);
    EXPECT_EQ(whole.frames.size(), 1u);
    EXPECT_TRUE(contains(whole.error, "no header of a LAMMPS binary dump begins here"))
        << whole.error;
    EXPECT_FALSE(whole.truncated);
  }
}

// `dump_modify append yes`, on a machine of the other kind and with other columns.
TEST_F(BinaryHeader, EveryFrameHasItsOwn) {
  BinaryFrame first, second;
  first.ranks = {{1, 0.5, 0.25, 0.125}};
  second.step = 3;
  second.columns = "zs ys xs";
  second.box = {0, 2, 0, 2, 0, 2};
  second.ranks = {{0.125, 0.25, 0.5}};
  const auto whole = read(first.bytes(std::endian::big) + second.bytes(std::endian::little));
  ASSERT_EQ(whole.error, "");
  EXPECT_EQ(whole.frames.at(0).real.at("x"), std::vector{0.5});
  EXPECT_EQ(whole.frames.at(1).real.at("x"), std::vector{1.0});
  EXPECT_EQ(whole.frames.at(1).real.at("z"), std::vector{0.25});
}

}  // namespace
}  // namespace mdana
