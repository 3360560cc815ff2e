// SPDX-License-Identifier: GPL-3.0-or-later
// Binary dumps that end early, and such that lie about how much there is.
#include <sys/resource.h>

#include <gtest/gtest.h>

#include "tests/readers/binary_dump.hpp"
#include "tests/readers/gzipped.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::BinaryFrame;
using test::contains;

const ColumnSet wanted{"id", "x", "y", "z", "fx"};

BinaryFrame frame(std::int64_t step) {
  BinaryFrame made;
  made.step = step;
  made.triclinic = 1;
  made.box = {-1, 9, 0, 8, 0, 10.25, 0.5, 0, -0.5};
  if (step == 100) made.units = "lj";
  made.time_flag = 1;
  made.time = 0.125 * static_cast<double>(step);
  made.columns = "id xs ys zs fx";
  const double x = 1e-3 * static_cast<double>(step);
  made.ranks = {
      {}, {12, x, 0.25, 0.5, -1.25e-3, 7, 0.75, x, 0.25, 123.456}, {}, {3, 0, 0, x, 1e10}, {}};
  return made;
}

struct Trajectory {
  std::string bytes;
  std::vector<std::size_t> ends;  ///< of the frames
};

Trajectory trajectory(std::endian order) {
  Trajectory made;
  for (const std::int64_t step : {100, 200, 300}) {
    made.bytes += frame(step).bytes(order);
    made.ends.push_back(made.bytes.size());
  }
  return made;
}

/// Whole frames of a cut dump are those of the original; nothing is made up.
void expect_beginning(const test::WholeTrajectory& cut, const test::WholeTrajectory& whole) {
  ASSERT_LE(cut.frames.size(), whole.frames.size());
  for (std::size_t i = 0; i < cut.frames.size(); ++i) {
    EXPECT_EQ(cut.frames[i].header.step, whole.frames[i].header.step);
    EXPECT_EQ(cut.frames[i].header.time, whole.frames[i].header.time);
    EXPECT_EQ(cut.frames[i].header.box.edges, whole.frames[i].header.box.edges);
    EXPECT_EQ(cut.frames[i].real, whole.frames[i].real);
    EXPECT_EQ(cut.frames[i].integer, whole.frames[i].integer);
  }
}

TEST(BinaryCut, AtEveryByteGivesWholeFramesOrSaysSo) {
  const test::TemporaryFolder folder;
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const Trajectory made = trajectory(order);
    const auto whole = test::read_all(folder.write("whole.bin", made.bytes), wanted);
    ASSERT_EQ(whole.error, "");
    ASSERT_EQ(whole.frames.size(), 3u);
    for (std::size_t bytes = 0; bytes < made.bytes.size(); ++bytes) {
      SCOPED_TRACE(bytes);
      const auto cut = test::read_all(folder.write("cut.bin", made.bytes.substr(0, bytes)), wanted);
      expect_beginning(cut, whole);
      const auto frames =
          std::count_if(made.ends.begin(), made.ends.end(), [&](auto e) { return e <= bytes; });
      const bool between_frames = std::count(made.ends.begin(), made.ends.end(), bytes) > 0;
      const bool recognised = bytes >= 12;  // "DUMP"
      EXPECT_EQ(cut.frames.size(), static_cast<std::size_t>(frames));
      EXPECT_EQ(cut.error.empty(), between_frames) << cut.error;
      EXPECT_EQ(cut.truncated, recognised && !between_frames) << cut.error;
    }
  }
}

TEST(BinaryCut, GzipCutAtEveryByteGivesWholeFramesAndSaysSo) {
  const test::TemporaryFolder folder;
  const std::string bytes = trajectory(std::endian::little).bytes;
  const auto whole = test::read_all(folder.write("whole.bin", bytes), wanted);
  for (const int level : {0, 6}) {
    const std::string packed = test::gzipped(bytes, level);
    for (std::size_t count = 0; count < packed.size(); ++count) {
      SCOPED_TRACE(count);
      const auto cut = test::read_all(folder.write("cut.bin.gz", packed.substr(0, count)), wanted);
      expect_beginning(cut, whole);
      EXPECT_FALSE(cut.error.empty());
    }
  }
}

// Any one byte may be wrong: an answer or an InputError, and the frames before it are right.
TEST(BinaryCut, AnyWrongByteIsSurvived) {
  const test::TemporaryFolder folder;
  const Trajectory made = trajectory(std::endian::little);
  const auto whole = test::read_all(folder.write("whole.bin", made.bytes), wanted);
  for (std::size_t byte = 0; byte < made.bytes.size(); ++byte)
    for (const int flip : {0x01, 0x40, 0x80, 0xff}) {
      SCOPED_TRACE(byte);
      std::string bytes = made.bytes;
      bytes[byte] = static_cast<char>(bytes[byte] ^ flip);
      const auto read = test::read_all(folder.write("wrong.bin", bytes), wanted);
      for (std::size_t i = 0; i < read.frames.size() && made.ends[i] <= byte; ++i)
        EXPECT_EQ(read.frames[i].real, whole.frames[i].real);
      if (byte >= made.ends[0]) {
        EXPECT_GE(read.frames.size(), 1u);
      }
    }
}

/// What is read of a second frame that lies; the first is right, and must come through.
test::WholeTrajectory read_lie(const test::TemporaryFolder& folder, const BinaryFrame& lie,
                               bool packed) {
  const std::string bytes = frame(100).bytes() + lie.bytes() + frame(300).bytes();
  const auto path =
      folder.write(packed ? "lie.bin.gz" : "lie.bin", packed ? test::gzipped(bytes) : bytes);
  const auto whole = test::read_all(path, wanted);
  EXPECT_EQ(whole.frames.size(), 1u) << whole.error;
  return whole;
}

TEST(BinaryLies, AboutNumbersOfAtomsAreTold) {
  const test::TemporaryFolder folder;
  const auto told = [&](const BinaryFrame& lie, bool truncated, const std::string& says) {
    for (const bool packed : {false, true}) {
      const auto whole = read_lie(folder, lie, packed);
      EXPECT_TRUE(contains(whole.error, says)) << whole.error;
      EXPECT_TRUE(contains(whole.error, "frame 1 (step 200)")) << whole.error;
      EXPECT_EQ(whole.truncated, truncated) << whole.error;
    }
  };
  BinaryFrame lie = frame(200);
  lie.natoms = 1'000'000'000'000'000;
  told(lie, false, "the blocks of its 5 ranks hold 3 atoms; the header says 1000000000000000");
  lie.lengths = {0, 2'000'000'000};
  told(lie, true, "of 1000000000000000 atoms at most");
  lie.natoms = 2;
  lie.lengths.clear();
  told(lie, false, "a rank's block of 1 atoms, but only 0 of the header's 2 are left");
  lie.natoms = 0;
  told(lie, false, "a rank's block of 2 atoms, but only 0 of the header's 0 are left");
  lie = frame(200);
  lie.lengths = {0, 9};
  told(lie, false, "a rank's block of 9 numbers, 5 an atom");
  lie.lengths = {-5};
  told(lie, false, "a rank's block of -5 numbers");
  lie.lengths = {0, 2'000'000'000};
  told(lie, false, "a rank's block of 400000000 atoms, but only 3");
  lie = frame(200);
  lie.nchunk = 4;  // the last rank is taken for the next header
  EXPECT_FALSE(test::read_all(folder.write("lie.bin", lie.bytes() + frame(300).bytes()), wanted)
                   .error.empty());
  lie = frame(200);
  lie.nchunk = 2'000'000'000;  // the next header is taken for ranks
  told(lie, false, "a rank's block of -10 numbers");
}

/// Memory held by this process at its greatest so far [bytes].
long greatest_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

// 20 million atoms with 4000 numbers each: 640 GB that are not there.
TEST(BinaryLies, CostNoMemory) {
  const test::TemporaryFolder folder;
  BinaryFrame lie = frame(200);
  lie.columns = "id xs ys zs fx";
  for (int i = 5; i < 4000; ++i) lie.columns += " c" + std::to_string(i);
  lie.natoms = 20'000'000;
  lie.ranks = {std::vector<double>(1000, 1.0)};
  lie.lengths = {2'147'448'000};
  const long before = greatest_memory();
  for (const bool packed : {false, true}) EXPECT_TRUE(read_lie(folder, lie, packed).truncated);
  EXPECT_LT(greatest_memory() - before, 100'000'000);
}

}  // namespace
}  // namespace mdana
