// SPDX-License-Identifier: GPL-3.0-or-later
// Every kernel that this processor supports finds the same columns and gives the bits of
// std::from_chars.
#include <gtest/gtest.h>

#include "tests/readers/number_lines.hpp"

namespace mdana {
namespace {

using test::lead;
using test::padded;
using test::same_bits;

class Kernels : public ::testing::TestWithParam<const LineKernel*> {
 protected:
  void SetUp() override {
    if (!GetParam()->supported()) GTEST_SKIP() << "this processor cannot run it";
  }
};

TEST_P(Kernels, GiveTheBitsOfFromChars) {
  std::mt19937_64 random(1);
  test::KernelScore score;
  for (int repeat = 0; repeat < 7000 && score.wrong.empty(); ++repeat)
    score.add(*GetParam(), test::NumberLines(random));
  EXPECT_EQ(score.wrong, "");
  EXPECT_GT(score.tried, 2'000'000u);
  EXPECT_TRUE(score.many_converted()) << score.left;
}

TEST_P(Kernels, RoundHalfwayCasesAndLimitsCorrectly) {
  for (const std::string t :
       {"9007199254740993", "9007199254740992.5", "0.1", "-0", "-0.0", "0", "1e22", "1e23", "1e-22",
        "1e-23", "9007199254740993e0", "9007199254740992e22", "9007199254740992e-22", "4.9e-324",
        "2.4703282292062327e-324", "1.7976931348623157e308", "0000000000000001", "5.", ".5", "-.5",
        "1.00000000000000011102230246251565404", "123456789012345678", "1E+05", "1e5", "1e+005"}) {
    const std::string text = padded(t, ' ');
    TokenBatch tokens;
    tokens.offset[0] = 0;
    tokens.length[0] = static_cast<std::uint8_t>(t.size());
    double value = 0;
    if (GetParam()->reals(text.data() + lead, tokens, 1, &value) != 0) {
      EXPECT_TRUE(parse_number(t, value)) << t;  // what the kernel leaves goes there
    }
    EXPECT_TRUE(same_bits(value, std::strtod(t.c_str(), nullptr))) << t << " " << value;
  }
}

TEST_P(Kernels, RefuseWhatIsNoNumber) {
  for (const std::string t : {"-", ".", "-.", "e5", "1e", "1e+", "--1", "1.2.3", "1-2", "0x10", "1,5",
                              "Cu", "1e5e5", "ITEM:", "1e-", "+"}) {
    const std::string text = padded(t, '7');
    TokenBatch tokens;
    tokens.offset[0] = 0;
    tokens.length[0] = static_cast<std::uint8_t>(t.size());
    double real = 0;
    std::int64_t integer = 0;
    EXPECT_EQ(GetParam()->reals(text.data() + lead, tokens, 1, &real), 1u) << t;
    EXPECT_EQ(GetParam()->integers(text.data() + lead, tokens, 1, &integer), 1u) << t;
  }
}

TEST_P(Kernels, ReadIntegersUpTo64Bits) {
  for (const std::string t : {"0", "-0", "7", "-12", "999999999999", "9999999999999999",
                              "9223372036854775807", "-9223372036854775808"}) {
    const std::string text = padded(t, '7');
    TokenBatch tokens;
    tokens.offset[0] = 0;
    tokens.length[0] = static_cast<std::uint8_t>(t.size());
    std::int64_t value = 0;
    if (GetParam()->integers(text.data() + lead, tokens, 1, &value) != 0) {
      EXPECT_TRUE(parse_number(t, value)) << t;
    }
    EXPECT_EQ(value, std::stoll(t));
  }
  for (const std::string t : {"1.0", "1.", "9223372036854775808", "1e3", "12a"}) {
    const std::string text = padded(t, ' ');
    TokenBatch tokens;
    tokens.offset[0] = 0;
    tokens.length[0] = static_cast<std::uint8_t>(t.size());
    std::int64_t value = 0;
    EXPECT_EQ(GetParam()->integers(text.data() + lead, tokens, 1, &value), 1u) << t;
  }
}

TEST_P(Kernels, FindColumnsInLinesOfAnyLengthAndBlanks) {
  const LineShape shape{3, {0, 2}};
  std::vector<TokenBatch> batches(2);
  for (std::size_t width = 1; width < 120; ++width) {
    for (const std::string gap : {" ", "\t", "   ", " \t "}) {
      for (const std::string end : {"\n", " \n", "\r\n", " \r\n"}) {
        const std::string a(width, '1'), b(width / 2 + 1, '2'), c(130 - width, '3');
        const std::string line = gap + a + gap + b + gap + c + end;
        const std::string text = padded(line + line, '9');
        const auto scanned = GetParam()->scan(text.data() + lead, 2, shape, batches.data());
        if (line.size() > 256) continue;  // may be left to the caller
        ASSERT_EQ(scanned.lines, 2u) << line;
        EXPECT_EQ(scanned.end, text.data() + lead + 2 * line.size());
        for (std::size_t i = 0; i < 2; ++i) {
          EXPECT_EQ(text.substr(lead + batches[0].offset[i], batches[0].length[i]), a);
          EXPECT_EQ(text.substr(lead + batches[1].offset[i], batches[1].length[i]), c);
        }
      }
    }
  }
}

TEST_P(Kernels, StopBeforeALineOfAnotherShape) {
  const LineShape shape{3, {1}};
  TokenBatch batch;
  for (const std::string odd : {"1 2\n", "1 2 3 4\n", "\n", "  \n", "1\n2 3 4\n"}) {
    const std::string text = padded("1 2 3\n4 5 6\n" + odd + "7 8 9\n", ' ');
    const auto scanned = GetParam()->scan(text.data() + lead, 4, shape, &batch);
    EXPECT_EQ(scanned.lines, 2u) << odd;
    EXPECT_EQ(scanned.end, text.data() + lead + 12) << odd;
  }
}

INSTANTIATE_TEST_SUITE_P(Line, Kernels, ::testing::ValuesIn(line_kernels().begin(), line_kernels().end()),
                         [](const auto& param) { return std::string(param.param->name); });

}  // namespace
}  // namespace mdana
