// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "readers/trajectory.hpp"
#include "tests/readers/gzipped.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

const std::string dump =
    "ITEM: TIMESTEP\n3\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
    "ITEM: ATOMS id x y z\n1 0.5 0.25 0.125\n";

TEST(Trajectory, IsRecognisedPlainAndPacked) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(format_of(folder.write("a", dump)), "lammps_text");
  EXPECT_EQ(format_of(folder.write("b", test::gzipped(dump))), "lammps_text");
  EXPECT_EQ(format_of(folder.write("c", "\r\n\n" + dump)), "lammps_text");
}

TEST(Trajectory, OtherFilesAreRefused) {
  const test::TemporaryFolder folder;
  const auto open = [&](const std::string& text) {
    open_trajectory(folder.write("other", text), {"x"});
  };
  EXPECT_INPUT_ERROR(open(""), "other", "empty");
  EXPECT_INPUT_ERROR(open("LAMMPS data file\n"), "other", "not a dump");
  EXPECT_INPUT_ERROR(open("\n \n"), "other", "not a dump");
  EXPECT_INPUT_ERROR(open(test::gzipped("hello\n")), "other", "not a dump");
  EXPECT_INPUT_ERROR(open("\x1f\x8b"), "other", "early");
  EXPECT_INPUT_ERROR(open_trajectory(folder.path() / "none", {}), "none");
  EXPECT_INPUT_ERROR(open_trajectory(folder.path(), {}), "not a file");
}

TEST(Trajectory, FirstHeaderAndFirstFrame) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("dump", dump + dump);
  EXPECT_EQ(first_header(path).step, 3);
  int blocks = 0;
  const FrameHeader header = for_first_frame(path, {"x", "y", "z"}, [&](const AtomBlock& block) {
    ++blocks;
    EXPECT_EQ(block.real("z")[0], 0.125);
  });
  EXPECT_EQ(blocks, 1);
  EXPECT_TRUE(header.has_column("id"));
  EXPECT_FALSE(header.has_column("vx"));
}

}  // namespace
}  // namespace mdana
