// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "readers/line_reader.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana {
namespace {

class Lines : public ::testing::Test {
 protected:
  LineReader open(const std::string& text) {
    return LineReader(open_bytes(folder_.write("lines.txt", text)));
  }
  std::vector<std::string> all(LineReader& reader) {
    std::vector<std::string> lines;
    while (const auto line = reader.line()) lines.emplace_back(*line);
    return lines;
  }
  test::TemporaryFolder folder_;
};

TEST_F(Lines, LfAndCrlfEndALine) {
  auto reader = open("one\ntwo\r\n\r\n\nfive\r\r\n");
  EXPECT_EQ(all(reader), (std::vector<std::string>{"one", "two", "", "", "five\r"}));
  EXPECT_EQ(reader.number(), 5u);
  EXPECT_FALSE(reader.unfinished());
}

TEST_F(Lines, LastLineWithoutEndIsCutOff) {
  auto reader = open("whole\n12.34");
  EXPECT_EQ(all(reader), (std::vector<std::string>{"whole"}));
  EXPECT_TRUE(reader.unfinished());
}

TEST_F(Lines, EmptyTextHasNoLines) {
  auto reader = open("");
  EXPECT_FALSE(reader.line().has_value());
  EXPECT_FALSE(reader.unfinished());
  EXPECT_EQ(reader.number(), 0u);
}

// The buffer holds 256 KiB: lines that are longer, and that begin in one filling and end in
// another.
TEST_F(Lines, LongerThanTheBuffer) {
  const std::vector<std::string> lines{std::string(1000, 'a'),    std::string(700'000, 'b'), "c",
                                       std::string(262'143, 'd'), std::string(262'144, 'e'), "f"};
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  auto reader = open(text);
  EXPECT_EQ(all(reader), lines);
}

TEST_F(Lines, TakeMovesWholeLinesWithTheirEnds) {
  auto reader = open("a\nbb\r\nccc\nrest");
  std::vector<char> into{'?'};
  EXPECT_EQ(reader.take(2, into), 2u);
  EXPECT_EQ(std::string(into.begin(), into.end()), "a\nbb\r\n");
  EXPECT_EQ(reader.number(), 2u);
  EXPECT_EQ(reader.take(2, into), 1u);
  EXPECT_EQ(std::string(into.begin(), into.end()), "ccc\n");
  EXPECT_TRUE(reader.unfinished());
}

TEST_F(Lines, SkipPassesOverAndCounts) {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += std::to_string(i) + "\n";
  auto reader = open(text);
  EXPECT_EQ(reader.skip(0), 0u);
  EXPECT_EQ(reader.skip(150'000), 150'000u);
  EXPECT_EQ(*reader.line(), "150000");
  EXPECT_EQ(reader.skip(1'000'000), 49'999u);
  EXPECT_EQ(reader.number(), 200'000u);
}

TEST_F(Lines, ResetGoesBackToTheMark) {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += std::to_string(i) + "\n";
  auto reader = open(text);
  reader.skip(70'000);
  reader.mark();
  std::vector<char> first, second;
  reader.take(100'000, first);
  reader.reset();
  EXPECT_EQ(reader.number(), 70'000u);
  reader.take(100'000, second);
  EXPECT_EQ(first, second);
  EXPECT_EQ(*reader.line(), "170000");
  reader.reset();
  EXPECT_EQ(*reader.line(), "70000");
}

TEST_F(Lines, ResetAfterTheCutOffEnd) {
  auto reader = open("a\nb\ncut");
  reader.line();
  reader.mark();
  while (reader.line()) continue;
  reader.reset();
  EXPECT_FALSE(reader.unfinished());
  EXPECT_EQ(*reader.line(), "b");
}

}  // namespace
}  // namespace mdana
