// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/readers/gzipped.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana {
namespace {

std::string frame(std::int64_t step, std::size_t atoms) {
  std::string text = "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ATOMS\n" +
                     std::to_string(atoms) +
                     "\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id q\n";
  for (std::size_t i = 0; i < atoms; ++i)
    text +=
        std::to_string(i) + " " + std::to_string(step * 1'000'000 + static_cast<long>(i)) + "\n";
  return text;
}

constexpr std::size_t capacity = AtomBlock::capacity;

TEST(DumpBlocks, AreCutAtTheirCapacity) {
  const test::TemporaryFolder folder;
  using Sizes = std::vector<std::size_t>;
  const struct {
    std::size_t atoms;
    Sizes blocks;
  } cases[] = {
      {1, {1}},
      {capacity - 1, {capacity - 1}},
      {capacity, {capacity}},
      {capacity + 1, {capacity, 1}},
      {3 * capacity, {capacity, capacity, capacity}},
  };
  for (const auto& c : cases) {
    const auto whole = test::read_all(folder.write("dump", frame(1, c.atoms)), {"id", "q"});
    ASSERT_EQ(whole.error, "");
    EXPECT_EQ(whole.frames[0].block_atoms, c.blocks);
    for (std::size_t i = 0; i < c.atoms; ++i)
      ASSERT_EQ(whole.frames[0].integer.at("id")[i], static_cast<std::int64_t>(i));
  }
}

TEST(DumpBlocks, AreNumberedAndKnowTheirFirstLine) {
  const test::TemporaryFolder folder;
  const auto source = open_trajectory(folder.write("dump", frame(0, 2 * capacity + 5)), {"q"});
  FrameHeader header;
  ASSERT_TRUE(source->next(header));
  Chunk chunk;
  for (std::uint64_t k = 0; source->cut(chunk); ++k) {
    EXPECT_EQ(chunk.number, k);
    EXPECT_EQ(chunk.first_line, 10 + k * capacity);
  }
  EXPECT_FALSE(source->cut(chunk));
}

/// Frames of different sizes, plain or packed; each is read, restarted at some block and read
/// again.
void expect_same_after_restart(const std::filesystem::path& path) {
  const auto source = open_trajectory(path, {"id", "q"});
  FrameHeader header;
  for (int frames = 0; source->next(header); ++frames) {
    for (const int blocks_before : {0, 1, 3}) {
      Chunk chunk;
      for (int i = 0; i < blocks_before; ++i) source->cut(chunk);
      source->restart_frame();
    }
    test::WholeFrame first, second;
    test::read_blocks(*source, {"id", "q"}, first);
    source->restart_frame();
    test::read_blocks(*source, {"id", "q"}, second);
    EXPECT_EQ(first.real, second.real);
    EXPECT_EQ(first.integer, second.integer);
    EXPECT_EQ(first.integer.at("id").size(), header.atoms);
    EXPECT_EQ(first.real.at("q")[1], static_cast<double>(header.step) * 1e6 + 1);
  }
}

TEST(DumpBlocks, RestartGivesTheSameBlocks) {
  const test::TemporaryFolder folder;
  const std::string text = frame(1, 2 * capacity + 7) + frame(2, 3) + frame(3, capacity);
  expect_same_after_restart(folder.write("dump", text));
  expect_same_after_restart(folder.write("dump.gz", test::gzipped(text)));
  expect_same_after_restart(folder.write(
      "parts.gz", test::gzipped(text.substr(0, 300'001)) + test::gzipped(text.substr(300'001))));
}

TEST(DumpBlocks, WhatIsNotReadOfAFrameIsPassedOver) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("dump", frame(1, 2 * capacity) + frame(2, 5) + frame(3, 1));
  const auto source = open_trajectory(path, {"q"});
  FrameHeader header;
  Chunk chunk;
  std::vector<std::int64_t> steps;
  while (source->next(header)) {
    steps.push_back(header.step);
    source->cut(chunk);
    if (header.step == 1) source->restart_frame();
  }
  EXPECT_EQ(steps, (std::vector<std::int64_t>{1, 2, 3}));
}

}  // namespace
}  // namespace mdana
