// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

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

constexpr std::endian orders[] = {std::endian::little, std::endian::big};
constexpr std::size_t capacity = AtomBlock::capacity;

/// Atoms 0, 1, 2 ... with q = 1e6 step + id, shared among ranks.
BinaryFrame numbered(std::int64_t step, const std::vector<std::size_t>& ranks) {
  BinaryFrame frame;
  frame.step = step;
  frame.columns = "id q";
  frame.ranks.clear();
  double id = 0;
  for (const std::size_t atoms : ranks) {
    auto& numbers = frame.ranks.emplace_back();
    for (std::size_t i = 0; i < atoms; ++i, ++id)
      numbers.insert(numbers.end(), {id, 1e6 * static_cast<double>(step) + id});
  }
  return frame;
}

void expect_numbered(const test::WholeFrame& frame, std::size_t atoms) {
  ASSERT_EQ(frame.integer.at("id").size(), atoms);
  for (std::size_t i = 0; i < atoms; ++i) {
    ASSERT_EQ(frame.integer.at("id")[i], static_cast<std::int64_t>(i));
    ASSERT_EQ(frame.real.at("q")[i],
              1e6 * static_cast<double>(frame.header.step) + static_cast<double>(i));
  }
}

TEST(BinaryAtoms, BlocksDoNotDependOnRanksByteOrderOrCompression) {
  const test::TemporaryFolder folder;
  const std::vector<std::size_t> shares[] = {{capacity + 5},
                                             {1, capacity + 4},
                                             {capacity, 5},
                                             {0, capacity - 1, 0, 6, 0},
                                             {3, 0, capacity - 7, 2, 0, 7}};
  for (const auto& ranks : shares)
    for (const std::endian order : orders) {
      const std::string bytes = numbered(3, ranks).bytes(order);
      for (const auto& path :
           {folder.write("dump.bin", bytes), folder.write("dump.bin.gz", test::gzipped(bytes))}) {
        const auto whole = test::read_all(path, {"id", "q"});
        ASSERT_EQ(whole.error, "");
        EXPECT_EQ(whole.frames.at(0).block_atoms, (std::vector<std::size_t>{capacity, 5}));
        expect_numbered(whole.frames[0], capacity + 5);
      }
    }
}

TEST(BinaryAtoms, ChunksAreNumberedAndCountAtoms) {
  const test::TemporaryFolder folder;
  const auto source =
      open_trajectory(folder.write("dump.bin", numbered(1, {2 * capacity, 9}).bytes()), {"q"});
  FrameHeader header;
  ASSERT_TRUE(source->next(header));
  Chunk chunk;
  for (std::uint64_t k = 0; source->cut(chunk); ++k) {
    EXPECT_EQ(chunk.number, k);
    EXPECT_EQ(chunk.first_line, 1 + k * capacity);
    EXPECT_TRUE(chunk.layout->printed_precision(chunk, "q").digits == 0);
  }
  EXPECT_FALSE(source->cut(chunk));
}

TEST(BinaryAtoms, ChunksMayBeSmaller) {
  const test::TemporaryFolder folder;
  const auto source =
      open_trajectory(folder.write("dump.bin", numbered(1, {7, 0, 4}).bytes()), {"q"});
  FrameHeader header;
  ASSERT_TRUE(source->next(header));
  Chunk chunk;
  std::vector<std::size_t> sizes;
  while (source->cut(chunk, 3)) sizes.push_back(chunk.atoms);
  EXPECT_EQ(sizes, (std::vector<std::size_t>{3, 3, 3, 2}));
}

/// Frames of different sizes; each is read, restarted at some block and read again.
void expect_same_after_restart(const std::filesystem::path& path) {
  const auto source = open_trajectory(path, {"id", "q"});
  FrameHeader header;
  int frames = 0;
  for (; source->next(header); ++frames) {
    for (const int blocks_before : {0, 1, 3}) {
      Chunk chunk;
      for (int i = 0; i < blocks_before; ++i) source->cut(chunk);
      source->restart_frame();
    }
    test::WholeFrame first, second;
    first.header = second.header = header;
    test::read_blocks(*source, {"id", "q"}, first);
    if (header.step != 2) source->restart_frame();
    test::read_blocks(*source, {"id", "q"}, second);
    expect_numbered(first, header.atoms);
    if (header.step != 2) expect_numbered(second, header.atoms);
  }
  EXPECT_EQ(frames, 3);
}

TEST(BinaryAtoms, RestartGivesTheSameBlocks) {
  const test::TemporaryFolder folder;
  const std::string bytes = numbered(1, {capacity - 2, capacity + 9}).bytes() +
                            numbered(2, {0, 3, 0}).bytes() + numbered(3, {capacity}).bytes();
  expect_same_after_restart(folder.write("dump.bin", bytes));
  expect_same_after_restart(folder.write("dump.bin.gz", test::gzipped(bytes)));
}

TEST(BinaryAtoms, WhatIsNotReadOfAFrameIsPassedOver) {
  const test::TemporaryFolder folder;
  const std::string bytes = numbered(1, {capacity, 7, capacity}).bytes() +
                            numbered(2, {5}).bytes() + numbered(3, {0, 1, 0}).bytes() +
                            numbered(4, {0}).bytes();
  for (const auto& path :
       {folder.write("dump.bin", bytes), folder.write("dump.bin.gz", test::gzipped(bytes))}) {
    const auto source = open_trajectory(path, {"q"});
    FrameHeader header;
    Chunk chunk;
    std::vector<std::int64_t> steps;
    while (source->next(header)) {
      steps.push_back(header.step);
      if (header.step != 2) source->cut(chunk);
      if (header.step == 3) source->restart_frame();
    }
    EXPECT_EQ(steps, (std::vector<std::int64_t>{1, 2, 3, 4}));
  }
}

// The hash is that of the whole file, however little of it was converted.
TEST(BinaryAtoms, RecordIsOfTheWholeFile) {
  const test::TemporaryFolder folder;
  const auto path =
      folder.write("dump.bin", numbered(1, {capacity, 7}).bytes() + numbered(2, {5}).bytes());
  std::vector<std::string> hashes;
  for (const int frames : {0, 1, 2}) {
    const auto source = open_trajectory(path, {"q"});
    FrameHeader header;
    Chunk chunk;
    for (int i = 0; i < frames && source->next(header); ++i) {
      source->cut(chunk);
      source->restart_frame();
    }
    const InputRecord record = source->records().at(0);
    EXPECT_EQ(record.size, std::filesystem::file_size(path));
    hashes.push_back(record.hash);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(BinaryAtoms, RealNumbersKeepTheirBits) {
  const test::TemporaryFolder folder;
  const double infinity = std::numeric_limits<double>::infinity();
  BinaryFrame frame;
  frame.columns = "fx";
  frame.ranks = {{0.1, -0.0, 5e-324, 1e308, infinity, 1.0 / 3}};
  for (const std::endian order : orders) {
    const auto whole = test::read_all(folder.write("dump.bin", frame.bytes(order)), {"fx"});
    ASSERT_EQ(whole.error, "");
    const auto& fx = whole.frames.at(0).real.at("fx");
    ASSERT_EQ(fx.size(), frame.ranks[0].size());
    for (std::size_t i = 0; i < fx.size(); ++i)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(fx[i]),
                std::bit_cast<std::uint64_t>(frame.ranks[0][i]));
  }
}

TEST(BinaryAtoms, PositionsFollowFromWhatThereIs) {
  const test::TemporaryFolder folder;
  BinaryFrame frame;
  frame.triclinic = 1;
  frame.boundary = {0, 0, 0, 0, 1, 1};
  frame.box = {-5, 6, -2, 3, 0, 16, 2, -1, 1};  // edges (8 0 0) (2 4 0) (-1 1 16) from (-4 -2 0)
  frame.columns = "type iz iy ix zs ys xs";
  frame.ranks = {{1, 0, 0, 0, 0.125, 0.25, 0.5}, {2, -2, 0, 1, 1, 1, 1}};
  for (const std::endian order : orders) {
    const auto whole =
        test::read_all(folder.write("dump.bin", frame.bytes(order)), {"x", "y", "z", "type"});
    ASSERT_EQ(whole.error, "");
    EXPECT_EQ(whole.frames.at(0).real.at("x"), (std::vector<double>{0.375, 15}));
    EXPECT_EQ(whole.frames.at(0).real.at("y"), (std::vector<double>{-0.875, 1}));
    EXPECT_EQ(whole.frames.at(0).real.at("z"), (std::vector<double>{2, -16}));
    EXPECT_EQ(whole.frames.at(0).integer.at("type"), (std::vector<std::int64_t>{1, 2}));
  }
}

TEST(BinaryAtoms, MissingColumnsAreTold) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("dump.bin", numbered(8, {1}).bytes());
  EXPECT_TRUE(contains(test::read_all(path, {"x"}).error, "no position columns"));
  EXPECT_TRUE(contains(test::read_all(path, {"fx"}).error,
                       "(frame 0, step 8): this frame has no column 'fx'"));
}

TEST(BinaryAtoms, WholeNumbersMustBeWhole) {
  const test::TemporaryFolder folder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {0.5, -1e-300, 0x1p53 + 2, -1e19, 1e300, nan, -1 / 0.0}) {
    BinaryFrame frame = numbered(8, {300, 400});
    frame.ranks[1][2 * 33] = wrong;
    for (const std::endian order : orders) {
      const auto path =
          folder.write("dump.bin", numbered(7, {1}).bytes(order) + frame.bytes(order));
      const auto whole = test::read_all(path, {"id"});
      EXPECT_EQ(whole.frames.size(), 1u);
      EXPECT_TRUE(contains(whole.error, "dump.bin (frame 1, step 8): atom 334: ")) << whole.error;
      EXPECT_TRUE(contains(whole.error, "in column id is not a whole number in range"))
          << whole.error;
      EXPECT_FALSE(whole.truncated);
      EXPECT_EQ(test::read_all(path, {"q"}).error, "");  // what is not wanted is not validated
    }
  }
}

TEST(BinaryAtoms, WholeNumbersReachTwoToThe53) {
  const test::TemporaryFolder folder;
  BinaryFrame frame;
  frame.columns = "id";
  frame.ranks = {{0x1p53, -0x1p53, -0.0, 2147483648.0}};
  const auto whole = test::read_all(folder.write("dump.bin", frame.bytes()), {"id"});
  ASSERT_EQ(whole.error, "");
  EXPECT_EQ(whole.frames.at(0).integer.at("id"),
            (std::vector<std::int64_t>{std::int64_t{1} << 53, -(std::int64_t{1} << 53), 0,
                                       std::int64_t{1} << 31}));
}

}  // namespace
}  // namespace mdana
