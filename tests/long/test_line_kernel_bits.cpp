// SPDX-License-Identifier: GPL-3.0-or-later
// Forty million numbers of all kinds: every kernel that this processor supports gives the bits of
// std::from_chars.
#include <iostream>

#include <gtest/gtest.h>

#include "tests/readers/number_lines.hpp"

namespace mdana {
namespace {

TEST(LineKernelBits, OfFortyMillionNumbers) {
  constexpr std::size_t numbers = 40'000'000;
  std::mt19937_64 random(20);
  std::vector<const LineKernel*> kernels;
  for (const LineKernel* kernel : line_kernels())
    if (kernel->supported()) kernels.push_back(kernel);
  ASSERT_FALSE(kernels.empty());
  std::vector<test::KernelScore> scores(kernels.size());
  while (scores.front().tried < numbers) {
    const test::NumberLines lines(random);
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      scores[k].add(*kernels[k], lines);
      ASSERT_EQ(scores[k].wrong, "") << kernels[k]->name;
    }
  }
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    std::cout << fmt::format("{}: {} numbers, {} of them left to the fallback\n", kernels[k]->name,
                             scores[k].tried, scores[k].left);
    EXPECT_TRUE(scores[k].many_converted()) << kernels[k]->name;
  }
}

}  // namespace
}  // namespace mdana
