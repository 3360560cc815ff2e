// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "readers/frame.hpp"
#include "readers/line_kernel.hpp"
#include "readers/line_reader.hpp"

namespace mdana::test {

/// The text with the bytes before and behind that kernels may read; begins at `lead`.
constexpr std::size_t lead = LineReader::lead;
inline std::string padded(const std::string& text, char filling) {
  return std::string(lead, filling) + text + std::string(Chunk::padding, filling);
}

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Decimals in the middle between two doubles, where rounding is decided by the last digit: half of
/// them exactly there, the others next to it.
inline std::string halfway(std::mt19937_64& random) {
  const std::uint64_t odd = (std::uint64_t{1} << 53) + (random() >> 12 << 1) % (std::uint64_t{1} << 53) + 1;
  const int exponent = static_cast<int>(random() % 10) - 6;  // at most 6 digits behind the point
  const std::string text = fmt::format("{:.{}f}", std::ldexp(static_cast<long double>(odd), exponent),
                                       exponent < 0 ? -exponent : 0);
  if (random() % 2) return text;
  return text + (exponent < 0 ? "" : ".") + fmt::format("{:0{}}", 1, 1 + random() % 8);
}

/// The same at any exponent: 17 to 19 digits of such a number.
inline std::string near_halfway(std::mt19937_64& random) {
  const std::uint64_t odd = (random() >> 11 | std::uint64_t{1} << 52) * 2 + 1;
  const int exponent = static_cast<int>(random() % 600) - 350;
  return fmt::format("{:.{}e}", std::ldexp(static_cast<long double>(odd), exponent),
                     16 + static_cast<int>(random() % 3));
}

/// Below 2^-1022, where doubles have fewer digits.
inline std::string denormal(std::mt19937_64& random) {
  const std::uint64_t mantissa = (random() >> 12) >> (random() % 52);
  const double value = std::bit_cast<double>(mantissa | random() << 63);
  return fmt::format("{:.{}g}", value, 1 + static_cast<int>(random() % 17));
}

/// Kinds of numbers that dumps hold, and some that try the limits of exact conversion.
inline std::string number(std::mt19937_64& random) {
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const double any = std::bit_cast<double>(random());
  switch (random() % 18) {
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
    case 11: return fmt::format("{:.0f}.", uniform(-1e15, 1e15));
    case 12: return halfway(random);
    case 13: return near_halfway(random);
    case 14: return denormal(random);
    case 15: return fmt::format("{:g}", std::ldexp(uniform(-1, 1), static_cast<int>(random() % 80) - 40));
    case 16: return fmt::format("{:f}", uniform(-1e3, 1e3));
    default: return fmt::format("{:.16e}", uniform(-200, 200));
  }
}

/// What std::from_chars makes of a number; beyond the doubles, where it gives none, strtod.
inline double real_of(const std::string& t) {
  double value = 0;
  const auto [stop, error] = std::from_chars(t.data(), t.data() + t.size(), value);
  return error == std::errc::result_out_of_range ? std::strtod(t.c_str(), nullptr) : value;
}

/// One batch of lines of numbers with the padding that kernels may read.
struct NumberLines {
  static constexpr std::size_t columns = 5;
  static constexpr std::size_t lines = TokenBatch::capacity;

  std::vector<std::string> numbers;  ///< line by line
  std::vector<double> reals;         ///< by real_of
  std::string text;

  explicit NumberLines(std::mt19937_64& random) {
    for (std::size_t k = 0; k < lines * columns; ++k) {
      numbers.push_back(number(random));
      reals.push_back(real_of(numbers.back()));
      text += numbers.back() + (k % columns + 1 == columns ? " \n" : " ");
    }
    text = padded(text, 'x');
  }
};

/// What a kernel made of numbers, and the exact fallback of those that were left to it: all have the
/// bits that they must have, but for the `wrong` one.
struct KernelScore {
  std::size_t tried = 0;
  std::size_t left = 0;
  std::string wrong;  ///< empty: none

  /// Many of the kinds of numbers are beyond a kernel, but a third at least must be within.
  bool many_converted() const { return left < tried - tried / 3; }

  void add(const LineKernel& kernel, const NumberLines& lines) {
    const LineShape shape{NumberLines::columns, {0, 1, 2, 3, 4}};
    std::array<TokenBatch, NumberLines::columns> batches;
    const char* text = lines.text.data() + lead;
    for (std::size_t line = 0; line < NumberLines::lines && wrong.empty();) {
      const auto scanned = kernel.scan(text, NumberLines::lines - line, shape, batches.data());
      if (scanned.lines == 0) wrong = fmt::format("line {} of\n{}", line, lines.text);
      for (std::size_t k = 0; k < batches.size() && wrong.empty(); ++k)
        add_column(kernel, text, batches[k], scanned.lines, lines, line * NumberLines::columns + k);
      text = scanned.end;
      line += scanned.lines;
    }
  }

  /// One column of a batch, whose first number is number `first` of the lines.
  void add_column(const LineKernel& kernel, const char* text, const TokenBatch& batch,
                  std::size_t count, const NumberLines& lines, std::size_t first) {
    std::array<double, NumberLines::lines> values;
    const std::uint64_t failed = kernel.reals(text, batch, count, values.data());
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = first + i * NumberLines::columns;
      if (std::isnan(lines.reals[at])) continue;  // nan has many bits
      ++tried;
      if (failed >> i & 1) {
        ++left;
        if (!parse_number(lines.numbers[at], values[i])) wrong = lines.numbers[at];
      }
      if (!same_bits(values[i], lines.reals[at]))
        wrong = fmt::format("{} became {}, not {}", lines.numbers[at], values[i], lines.reals[at]);
    }
  }
};

}  // namespace mdana::test
