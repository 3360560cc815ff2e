// SPDX-License-Identifier: GPL-3.0-or-later
// Every kernel that this processor supports finds the same columns and gives the bits of
// std::from_chars.
#include <bit>
#include <charconv>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "readers/frame.hpp"
#include "readers/line_kernel.hpp"
#include "readers/line_reader.hpp"

namespace mdana {
namespace {

class Kernels : public ::testing::TestWithParam<const LineKernel*> {
 protected:
  void SetUp() override {
    if (!GetParam()->supported()) GTEST_SKIP() << "this processor cannot run it";
  }
};

/// Kinds of numbers that dumps hold, and some that try the limits of exact conversion.
std::string token(std::mt19937_64& random) {
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const double any = std::bit_cast<double>(random());
  switch (random() % 12) {
    case 0: return fmt::format("{:.10g}", uniform(-100, 100));
    case 1: return fmt::format("{:.10g}", uniform(-1e-3, 1e-3));
    case 2: return fmt::format("{:.6g}", uniform(-1, 1));
    case 3: return fmt::format("{:.8f}", uniform(-1e4, 1e4));
    case 4: return fmt::format("{:.17g}", uniform(-30, 30));
    case 5: return fmt::format("{:.16g}", any);
    case 6: return fmt::format("{:.17g}", any);
    case 7: return fmt::format("{}", static_cast<std::int64_t>(random() >> (random() % 60 + 4)));
    case 8: return fmt::format("{:e}", any);
    case 9: return fmt::format("{}.{}", random() % 100000000, random() % 10000000);
    case 10: return fmt::format("{}e{}", random() % (1ull << 54), static_cast<int>(random() % 60) - 30);
    default: return fmt::format("{:.0f}.", uniform(-1e15, 1e15));
  }
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// The text with the bytes before and behind that kernels may read; begins at `lead`.
constexpr std::size_t lead = LineReader::lead;
std::string padded(const std::string& text, char filling) {
  return std::string(lead, filling) + text + std::string(Chunk::padding, filling);
}

/// Lines of numbers with the padding that kernels may read.
struct Text {
  std::vector<std::string> tokens;
  std::string text;

  Text(std::mt19937_64& random, std::size_t lines, std::size_t columns) {
    for (std::size_t i = 0; i < lines; ++i) {
      for (std::size_t k = 0; k < columns; ++k) {
        tokens.push_back(token(random));
        text += tokens.back() + " ";
      }
      text += "\n";
    }
    text = padded(text, 'x');
  }
};

TEST_P(Kernels, GiveTheBitsOfFromChars) {
  std::mt19937_64 random(1);
  const LineKernel& kernel = *GetParam();
  constexpr std::size_t columns = 5;
  const LineShape shape{columns, {0, 1, 2, 3, 4}};
  std::vector<TokenBatch> batches(columns);
  std::array<double, TokenBatch::capacity> values;
  std::size_t tried = 0, left = 0;
  for (int repeat = 0; repeat < 7000; ++repeat) {
    const Text text(random, TokenBatch::capacity, columns);
    const auto scanned = kernel.scan(text.text.data() + lead, TokenBatch::capacity, shape, batches.data());
    ASSERT_EQ(scanned.lines, TokenBatch::capacity) << text.text;
    for (std::size_t k = 0; k < columns; ++k) {
      const std::uint64_t failed =
          kernel.reals(text.text.data() + lead, batches[k], scanned.lines, values.data());
      for (std::size_t i = 0; i < scanned.lines; ++i, ++tried) {
        const std::string& t = text.tokens[i * columns + k];
        double expected = 0;
        const auto [stop, error] = std::from_chars(t.data(), t.data() + t.size(), expected);
        if (error == std::errc::result_out_of_range) expected = std::strtod(t.c_str(), nullptr);
        if (std::isnan(expected)) continue;  // nan has many bits
        if (failed >> i & 1) {  // left to the exact fallback
          ++left;
          continue;
        }
        ASSERT_TRUE(same_bits(values[i], expected)) << t << " " << values[i] << " " << expected;
      }
    }
  }
  EXPECT_GT(tried, 2'000'000u);
  EXPECT_LT(left, tried / 2);
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
    if (GetParam()->reals(text.data() + lead, tokens, 1, &value) == 0) {
      EXPECT_TRUE(same_bits(value, std::strtod(t.c_str(), nullptr))) << t << " " << value;
    }
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
    if (GetParam()->integers(text.data() + lead, tokens, 1, &value) == 0) {
      EXPECT_EQ(value, std::stoll(t));
    }
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
