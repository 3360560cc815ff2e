// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/readers/gzipped.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana {
namespace {

const std::string frame_of_two =
    "ITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS xy xz yz pp ff ff\n"
    "-1 9 0.5\n0 8 0\n0 10.25 -0.5\nITEM: ATOMS id type xs ys zs fx\n";

const std::string text = "ITEM: UNITS\nlj\nITEM: TIMESTEP\n100\nITEM: TIME\n12.5\n" + frame_of_two +
                         "12 1 0.125 0.25 0.5 -1.25e-3\n7 2 0.75 0.5 0.25 123.456\n" +
                         "ITEM: TIMESTEP\n200\nITEM: TIME\n25\n" + frame_of_two +
                         "7 2 0.76 0.51 0.26 -77.125\n12 1 0.13 0.26 0.51 1e10\n" +
                         "ITEM: TIMESTEP\n300\nITEM: TIME\n37.5\n" + frame_of_two +
                         "7 2 0.77 0.52 0.27 9\n12 1 0.14 0.27 0.52 12345678\n";

const ColumnSet wanted{"id", "type", "x", "y", "z", "fx"};

void expect_same(const test::WholeFrame& a, const test::WholeFrame& b) {
  EXPECT_EQ(a.header.step, b.header.step);
  EXPECT_EQ(a.header.time, b.header.time);
  EXPECT_EQ(a.header.columns, b.header.columns);
  EXPECT_EQ(a.header.box.edges, b.header.box.edges);
  EXPECT_EQ(a.header.box.origin, b.header.box.origin);
  EXPECT_EQ(a.real, b.real);
  EXPECT_EQ(a.integer, b.integer);
}

/// Whole frames of a cut dump are those of the original; it ends with an error unless the cut is
/// right between two frames.
void expect_beginning(const test::WholeTrajectory& cut, const test::WholeTrajectory& whole,
                      bool between_frames) {
  ASSERT_LE(cut.frames.size(), whole.frames.size());
  for (std::size_t i = 0; i < cut.frames.size(); ++i) expect_same(cut.frames[i], whole.frames[i]);
  EXPECT_EQ(cut.error.empty(), between_frames) << cut.error;
}

bool between_frames(std::size_t bytes) {
  return bytes == text.size() ||
         (bytes > 0 && text.compare(bytes, 14, "ITEM: TIMESTEP") == 0 && text[bytes - 2] != 'j');
}

TEST(DumpCut, AtEveryByteGivesWholeFramesOrSaysSo) {
  const test::TemporaryFolder folder;
  const auto whole = test::read_all(folder.write("whole", text), wanted);
  ASSERT_EQ(whole.error, "");
  ASSERT_EQ(whole.frames.size(), 3u);
  for (std::size_t bytes = 0; bytes <= text.size(); ++bytes) {
    SCOPED_TRACE(bytes);
    const auto cut = test::read_all(folder.write("cut", text.substr(0, bytes)), wanted);
    expect_beginning(cut, whole, between_frames(bytes));
    const bool recognised = bytes >= 6;  // "ITEM: "
    EXPECT_EQ(cut.truncated, recognised && !cut.error.empty()) << cut.error;
  }
}

TEST(DumpCut, GzipCutAtEveryByteGivesWholeFramesAndSaysSo) {
  const test::TemporaryFolder folder;
  const auto whole = test::read_all(folder.write("whole", text), wanted);
  for (const int level : {0, 6}) {  // stored (every byte comes through) and deflated
    const std::string packed = test::gzipped(text, level);
    for (std::size_t bytes = 0; bytes < packed.size(); ++bytes) {
      SCOPED_TRACE(bytes);
      const auto cut = test::read_all(folder.write("cut.gz", packed.substr(0, bytes)), wanted);
      expect_beginning(cut, whole, false);
    }
  }
}

// A bit that flips in the compressed bytes is noticed, at the latest by the checksum behind the
// last frame; members of one frame each keep the frames before.
TEST(DumpCut, GzipWithAFlippedBitSaysSo) {
  const test::TemporaryFolder folder;
  const std::string packed = test::gzipped(text);
  for (std::size_t byte = 10; byte < packed.size(); ++byte) {
    std::string broken = packed;
    broken[byte] = static_cast<char>(broken[byte] ^ 1);
    const auto read = test::read_all(folder.write("broken.gz", broken), wanted);
    EXPECT_FALSE(read.error.empty()) << byte;
  }
}

}  // namespace
}  // namespace mdana
