// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include <gtest/gtest.h>

#include "readers/frame_choice.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

/// All chosen ones of the frames 0, 1, ... 9.
std::vector<std::uint64_t> chosen(const std::string& text) {
  const FrameChoice choice = parse_frame_choice(text);
  std::vector<std::uint64_t> frames;
  for (auto k = choice.at_or_after(0); k && *k < 10; k = choice.at_or_after(*k + 1))
    frames.push_back(*k);
  return frames;
}

using Frames = std::vector<std::uint64_t>;

TEST(FrameChoice, IsASliceAsInPython) {
  EXPECT_EQ(chosen(":"), (Frames{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(chosen("7:"), (Frames{7, 8, 9}));
  EXPECT_EQ(chosen(":3"), (Frames{0, 1, 2}));
  EXPECT_EQ(chosen("2:9:3"), (Frames{2, 5, 8}));
  EXPECT_EQ(chosen("2:8:3"), (Frames{2, 5}));
  EXPECT_EQ(chosen("::4"), (Frames{0, 4, 8}));
  EXPECT_EQ(chosen("4:5"), (Frames{4}));
}

TEST(FrameChoice, FindsTheNextOneFromAnyFrame) {
  const FrameChoice choice{5, 20, 7};  // 5, 12, 19
  EXPECT_EQ(choice.at_or_after(0), 5u);
  EXPECT_EQ(choice.at_or_after(5), 5u);
  EXPECT_EQ(choice.at_or_after(6), 12u);
  EXPECT_EQ(choice.at_or_after(19), 19u);
  EXPECT_EQ(choice.at_or_after(20), std::nullopt);
  EXPECT_EQ((FrameChoice{0, {}, 2}).at_or_after(~std::uint64_t{0}), std::nullopt);  // no overflow
}

TEST(FrameChoice, RefusesWhatIsNoChoice) {
  for (const char* text : {"", "5", "a:b", "1:2:3:4", "1:1", "5:2", "::0", "-1:", "1.5:", "1:99999999999999999999"})
    EXPECT_INPUT_ERROR(parse_frame_choice(text), text, "FIRST:END");
}

}  // namespace
}  // namespace mdana
