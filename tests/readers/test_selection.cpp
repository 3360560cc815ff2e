// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "readers/line_reader.hpp"
#include "readers/selection.hpp"
#include "readers/word_lines.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

/// A block of ids, and reals and words that tell the same.
AtomBlock block_of(const std::vector<std::int64_t>& ids) {
  AtomBlock block;
  block.reset(0, ids.size());
  std::ranges::copy(ids, block.make_integer("id").begin());
  const auto x = block.make_real("x");
  const auto words = block.make_text("element");
  for (std::size_t i = 0; i < ids.size(); ++i) {
    x[i] = static_cast<double>(ids[i]) / 2;
    words[i] = "E" + std::to_string(ids[i]);
  }
  return block;
}

std::vector<std::int64_t> selected(const std::string& text, const std::vector<std::int64_t>& ids) {
  AtomBlock block = block_of(ids);
  Selection(text).apply(block);
  const auto left = block.integer("id");
  EXPECT_EQ(block.atoms(), left.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_EQ(block.real("x")[i], static_cast<double>(left[i]) / 2);
    EXPECT_EQ(block.text("element")[i], "E" + std::to_string(left[i]));
  }
  return {left.begin(), left.end()};
}

using Ids = std::vector<std::int64_t>;

TEST(Selection, KeepsAtomsInTheRangesInTheirOrder) {
  EXPECT_EQ(selected("id:2-4", {5, 4, 1, 2, 9}), (Ids{4, 2}));
  EXPECT_EQ(selected("id:9,1-2", {5, 4, 1, 2, 9}), (Ids{1, 2, 9}));
  EXPECT_EQ(selected("id:-3--1,0", {-2, 0, 3, -3, -4}), (Ids{-2, 0, -3}));
  EXPECT_EQ(selected("id:7", {1, 2}), Ids{});
  EXPECT_EQ(selected("id:-9223372036854775808-9223372036854775807", {1, -2}), (Ids{1, -2}));
}

TEST(Selection, RefusesWhatIsNone) {
  for (const char* text : {"", "id", "id:", "id:a", "id:1-", "id:4-2", "id:1,,2", "x:1-2", "element:1",
                           "id:99999999999999999999", "id:1-2-3"})
    EXPECT_INPUT_ERROR(Selection{text}, std::string("'") + text + "'", "COLUMN:RANGES");
}

/// Lines of one chunk, some of which no kernel of vectors takes: blanks in front, tabs, words of
/// over 128 characters, CRLF.
std::string odd_lines(std::size_t atoms) {
  std::mt19937_64 random(3);
  std::string text(LineReader::lead, ' ');
  for (std::size_t i = 0; i < atoms; ++i) {
    const std::uint64_t r = random();
    const std::string x = fmt::format("{:.{}f}", 1e-9 * static_cast<double>(r % 1'000'000'000),
                                      r % 17 == 0 ? 300 : 9);
    text += fmt::format("{}{} {}{}E{} {}{}\n", r % 5 == 0 ? "  " : "", i + 1, r % 4,
                        r % 7 == 0 ? "\t" : " ", r % 9, x, r % 3 == 0 ? "\r" : "");
  }
  return text + std::string(Chunk::padding, ' ');
}

AtomBlock read_lines(const std::string& text, std::size_t atoms, const LineKernel& kernel,
                     const ColumnSet& wanted) {
  FrameHeader header;
  header.columns = {"id", "type", "element", "c_x"};
  Chunk chunk;
  chunk.atoms = atoms;
  chunk.bytes = std::string_view(text).substr(
      LineReader::lead, text.size() - LineReader::lead - Chunk::padding);
  AtomBlock block;
  WordLines(header, wanted, "lines", kernel).convert(chunk, block);
  return block;
}

// Selecting while lines are read gives what selecting afterwards gives, whatever the kernel, and
// wherever among 64 lines of a batch the selected and the odd ones are.
TEST(Selection, OfLinesIsThatOfTheirBlock) {
  constexpr std::size_t atoms = 1000;
  const std::string text = odd_lines(atoms);
  for (const LineKernel* kernel : line_kernels()) {
    if (!kernel->supported()) continue;
    for (const char* rule : {"type:2", "type:0,3", "id:500-1000", "id:65-128", "type:9", "id:1-1000"}) {
      ColumnSet wanted{"id", "element", "c_x"};
      if (std::string_view(rule).starts_with("type")) wanted.add("type");
      AtomBlock expected = read_lines(text, atoms, *kernel, wanted);
      Selection(rule).apply(expected);
      wanted.select(Selection(rule));
      const AtomBlock block = read_lines(text, atoms, *kernel, wanted);
      EXPECT_EQ(block.atoms(), expected.atoms());
      EXPECT_TRUE(std::ranges::equal(block.integer("id"), expected.integer("id"))) << rule;
      EXPECT_TRUE(std::ranges::equal(block.text("element"), expected.text("element"))) << rule;
      EXPECT_TRUE(std::ranges::equal(block.real("c_x"), expected.real("c_x"))) << rule;
    }
  }
}

// The numbers of other atoms are not looked at; those by which they are told apart are.
TEST(Selection, OtherAtomsAreNotParsed) {
  const std::string start = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS ff ff ff\n"
                            "0 1\n0 1\n0 1\nITEM: ATOMS id type vx\n";
  test::TemporaryFolder folder;
  ColumnSet wanted{"id", "vx"};
  wanted.select(Selection("type:1"));
  const auto read = test::read_all(folder.write("a", start + "1 1 0.5\n2 2 what\n3 1 1.5\n"), wanted);
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(read.frames.at(0).integer.at("id"), (Ids{1, 3}));
  EXPECT_EQ(read.frames.at(0).real.at("vx"), (std::vector<double>{0.5, 1.5}));
  const auto wrong = test::read_all(folder.write("b", start + "1 1 0.5\n2 2.5 0\n3 1 1.5\n"), wanted);
  EXPECT_NE(wrong.error.find("b:11: '2.5' in column type"), std::string::npos) << wrong.error;
  const auto later = test::read_all(folder.write("c", start + "1 2 0.5\n2 2 0\n3 1 what\n"), wanted);
  EXPECT_NE(later.error.find("c:12: 'what' in column vx"), std::string::npos) << later.error;
}

}  // namespace
}  // namespace mdana
