// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of contacts as `dump local` writes them: any order of columns and items, and what is wrong
// with a list.
#include <gtest/gtest.h>

#include "readers/local_dump.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

const LocalDump::Columns columns{"a", "b", "f"};

std::string frame(const std::string& step, const std::string& count, const std::string& rows,
                  const std::string& head = "index a b d f ") {
  return "ITEM: UNITS\nnano\nITEM: TIME\n1.5\nITEM: TIMESTEP\n" + step +
         "\nITEM: NUMBER OF ENTRIES\n" + count +
         "\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ENTRIES " + head + "\n" + rows;
}

/// All frames of a file with this text.
std::vector<LocalFrame> read(const std::string& text) {
  const test::TemporaryFolder folder;
  LocalDump dump(folder.write("list", text), columns);
  std::vector<LocalFrame> frames;
  while (auto frame = dump.next()) frames.push_back(std::move(*frame));
  return frames;
}

TEST(LocalDump, FramesAndColumnsInAnyOrder) {
  const auto frames = read(frame("7", "2", "1 9 3 0.1 -2.5\n2 1 5000000000 0.2 4e3 \n") +
                           frame("9", "0", "") + frame("10", "1", "1.25 4 2\n", "f b a"));
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[0].step, 7);
  ASSERT_EQ(frames[0].contacts.size(), 2u);
  EXPECT_EQ(frames[0].contacts[0].id1, 1);
  EXPECT_EQ(frames[0].contacts[0].id2, 5000000000);
  EXPECT_EQ(frames[0].contacts[0].force, 4000);
  EXPECT_EQ(frames[0].contacts[1].id1, 3);
  EXPECT_EQ(frames[0].contacts[1].id2, 9);
  EXPECT_EQ(frames[0].contacts[1].force, -2.5);
  EXPECT_TRUE(frames[1].contacts.empty());
  EXPECT_EQ(frames[2].contacts.at(0).force, 1.25);
  EXPECT_TRUE(read("").empty());
  EXPECT_EQ(read("\n" + frame("7", "0", "") + "\n\n").size(), 1u);
}

TEST(LocalDump, WhatIsWrongIsTold) {
  EXPECT_INPUT_ERROR(read("hello\n"), "list:1", "no part of a local dump");
  EXPECT_INPUT_ERROR(read(frame("7", "1", "1 2 3 0 x\n")), "list:14", "force");
  EXPECT_INPUT_ERROR(read(frame("7", "1", "1 2 3 0 nan\n")), "list:14", "finite");
  EXPECT_INPUT_ERROR(read(frame("7", "1", "1 2 2 0 1\n")), "list:14", "two different");
  EXPECT_INPUT_ERROR(read(frame("7", "1", "1 2.5 2 0 1\n")), "whole numbers");
  EXPECT_INPUT_ERROR(read(frame("7", "1", "1 2 3 0\n")), "list:14", "4 columns", "5");
  EXPECT_INPUT_ERROR(read(frame("7", "2", "1 2 3 0 1\n2 3 2 0 1\n")), "2 3 twice");
  EXPECT_INPUT_ERROR(read(frame("7", "1", "2 3\n", "a b")), "no column 'f'", "--contact-columns");
  EXPECT_INPUT_ERROR(read(frame("x", "1", "")), "list:6", "whole number");
  EXPECT_INPUT_ERROR(read(frame("7", "-1", "")), "negative");
  EXPECT_INPUT_ERROR(read(frame("7", "0", "") + frame("7", "0", "")), "does not come after");
  EXPECT_INPUT_ERROR(read(frame("7", "1", "1 2 3 0 1\n2 4 5 0 1\n")), "list:15", "no part");
}

// A count that no file could hold makes nothing but this message.
TEST(LocalDump, CutOff) {
  EXPECT_THROW(read(frame("7", "9000000000000000000", "1 2 3 0 1\n")), TruncatedInput);
  const std::string whole = frame("7", "2", "1 2 3 0.5 1\n2 3 4 0.5 1\n");
  for (std::size_t size = 1; size < whole.size(); ++size)
    EXPECT_THROW(read(whole.substr(0, size)), TruncatedInput) << size;
}

}  // namespace
}  // namespace mdana
