// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "readers/selection.hpp"
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

}  // namespace
}  // namespace mdana
