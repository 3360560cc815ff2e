// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "readers/line_reader.hpp"
#include "tests/readers/gzipped.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana {
namespace {

/// Plain text, which is mapped into memory, and compressed text, which is streamed.
class Lines : public ::testing::TestWithParam<bool> {
 protected:
  LineReader open(const std::string& text) {
    return LineReader(
        open_bytes(folder_.write("lines", GetParam() ? test::gzipped(text) : text)));
  }
  std::vector<std::string> all(LineReader& reader) {
    std::vector<std::string> lines;
    while (const auto line = reader.line()) lines.emplace_back(*line);
    return lines;
  }
  test::TemporaryFolder folder_;
};

TEST_P(Lines, LfAndCrlfEndALine) {
  auto reader = open("one\ntwo\r\n\r\n\nfive\r\r\n");
  EXPECT_EQ(all(reader), (std::vector<std::string>{"one", "two", "", "", "five\r"}));
  EXPECT_EQ(reader.number(), 5u);
  EXPECT_FALSE(reader.unfinished());
}

TEST_P(Lines, LastLineWithoutEndIsCutOff) {
  auto reader = open("whole\n12.34");
  EXPECT_EQ(all(reader), (std::vector<std::string>{"whole"}));
  EXPECT_TRUE(reader.unfinished());
}

TEST_P(Lines, EmptyTextHasNoLines) {
  auto reader = open("");
  EXPECT_FALSE(reader.line().has_value());
  EXPECT_FALSE(reader.unfinished());
  EXPECT_EQ(reader.number(), 0u);
}

// The buffer holds 256 KiB: lines that are longer, and that begin in one filling and end in
// another.
TEST_P(Lines, LongerThanTheBuffer) {
  const std::vector<std::string> lines{std::string(1000, 'a'),    std::string(700'000, 'b'), "c",
                                       std::string(262'143, 'd'), std::string(262'144, 'e'), "f"};
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  auto reader = open(text);
  EXPECT_EQ(all(reader), lines);
}

TEST_P(Lines, TakeMovesWholeLinesWithTheirEnds) {
  auto reader = open("a\nbb\r\nccc\nrest");
  std::vector<char> storage{'?'};
  LineReader::Lines lines = reader.take(2, storage);
  EXPECT_EQ(lines.count, 2u);
  EXPECT_EQ(lines.text, "a\nbb\r\n");
  EXPECT_EQ(reader.number(), 2u);
  lines = reader.take(2, storage, 1000);  // more than is left: copied, with padding
  EXPECT_EQ(lines.count, 1u);
  EXPECT_EQ(lines.text, "ccc\n");
  EXPECT_EQ(lines.text.data(), storage.data() + LineReader::lead);
  EXPECT_GE(storage.size(), lines.text.size() + 1000);
  EXPECT_TRUE(reader.unfinished());
}

TEST_P(Lines, SkipPassesOverAndCounts) {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += std::to_string(i) + "\n";
  auto reader = open(text);
  EXPECT_EQ(reader.skip(0), 0u);
  EXPECT_EQ(reader.skip(150'000), 150'000u);
  EXPECT_EQ(*reader.line(), "150000");
  EXPECT_EQ(reader.skip(1'000'000), 49'999u);
  EXPECT_EQ(reader.number(), 200'000u);
}

TEST_P(Lines, ResetGoesBackToTheMark) {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += std::to_string(i) + "\n";
  auto reader = open(text);
  reader.skip(70'000);
  reader.mark();
  std::vector<char> storage;
  const std::string first(reader.take(100'000, storage).text);
  reader.reset();
  EXPECT_EQ(reader.number(), 70'000u);
  EXPECT_EQ(reader.take(100'000, storage).text, first);
  EXPECT_EQ(*reader.line(), "170000");
  reader.reset();
  EXPECT_EQ(*reader.line(), "70000");
}

TEST_P(Lines, ResetAfterTheCutOffEnd) {
  auto reader = open("a\nb\ncut");
  reader.line();
  reader.mark();
  while (reader.line()) continue;
  reader.reset();
  EXPECT_FALSE(reader.unfinished());
  EXPECT_EQ(*reader.line(), "b");
}

INSTANTIATE_TEST_SUITE_P(Of, Lines, ::testing::Values(false, true), [](const auto& param) {
  return param.param ? "CompressedFile" : "MappedFile";
});

}  // namespace
}  // namespace mdana
