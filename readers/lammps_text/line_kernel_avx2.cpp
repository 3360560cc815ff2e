// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines by masks: a comparison of 64 bytes gives a bit for every blank and line end, from which the
// starts and ends of all columns follow without a loop over bytes. Numbers by shuffles: up to 16
// digits are aligned by a table, the point dropped, and multiplied out in four steps; the quotient of
// an integer below 2^53 and a power of ten up to 10^22 is correctly rounded (Clinger 1990).
#if defined(__x86_64__)

#include "readers/lammps_text/line_kernel.hpp"

#include <cstring>

#include <immintrin.h>

// Only these functions may use the instructions: they run after `supported` has asked.
#define MDANA_TARGET __attribute__((target("avx2,bmi,bmi2,lzcnt,popcnt")))
#define MDANA_INLINE MDANA_TARGET inline __attribute__((always_inline))

namespace mdana::lammps_text {
namespace {

constexpr std::uint32_t most_digits = 16;
constexpr std::uint64_t exact_integers = std::uint64_t{1} << 53;

/// For a token of `length` bytes with its point at `point` (at `length` if it has none): where the
/// digits go, last digit last, zeros before.
struct AlignTable {
  alignas(16) std::uint8_t from[32][32][16];  // rows beyond 16 stay empty

  constexpr AlignTable() : from() {
    for (std::uint32_t length = 0; length <= most_digits; ++length)
      for (std::uint32_t point = 0; point <= most_digits; ++point) fill(length, point);
  }
  constexpr void fill(std::uint32_t length, std::uint32_t point) {
    for (std::uint8_t& b : from[length][point]) b = 0x80;  // a shuffled-in zero
    std::uint32_t to = 16;
    for (std::uint32_t i = length; i-- > 0;)
      if (i != point) from[length][point][--to] = static_cast<std::uint8_t>(i);
  }
};
constexpr AlignTable align;

constexpr double powers_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// A decimal number without sign and exponent.
struct Decimal {
  std::uint64_t digits;    ///< all of them as one integer
  std::uint32_t decimals;  ///< behind the point
  bool point;              ///< there is one
  bool valid;              ///< 1 to 16 bytes, digits and at most one point
};

MDANA_INLINE std::uint64_t multiply_out(__m128i aligned_digits) {
  __m128i d = _mm_maddubs_epi16(aligned_digits, _mm_set1_epi16(0x010a));  // pairs
  d = _mm_madd_epi16(d, _mm_set1_epi32(0x00010064));                      // fours
  d = _mm_packus_epi32(d, d);
  d = _mm_madd_epi16(d, _mm_set1_epi32(0x00012710));  // eights
  const auto halves = static_cast<std::uint64_t>(_mm_cvtsi128_si64(d));
  return (halves & 0xffffffff) * 100000000 + (halves >> 32);
}

MDANA_INLINE Decimal read_decimal(const char* text, std::uint32_t length) {
  const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(text));
  const __m128i digits = _mm_sub_epi8(bytes, _mm_set1_epi8('0'));
  const std::uint32_t inside = _bzhi_u32(0xffff, length);
  const auto points = static_cast<std::uint32_t>(
      _mm_movemask_epi8(_mm_cmpeq_epi8(bytes, _mm_set1_epi8('.')))) & inside;
  const auto others = ~static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_cmpeq_epi8(
      _mm_min_epu8(digits, _mm_set1_epi8(9)), digits))) & inside;
  const bool valid = (others == points) & (length <= most_digits) & ((points & (points - 1)) == 0) &
                     (inside != points);
  const std::uint32_t n = length & 31;
  const std::uint32_t point = _tzcnt_u32(points | 1u << n);
  const std::uint8_t* order = align.from[n][point];
  const __m128i aligned =
      _mm_shuffle_epi8(digits, _mm_load_si128(reinterpret_cast<const __m128i*>(order)));
  return {multiply_out(aligned), n - point - (points != 0), points != 0, valid};
}

/// Numbers with an exponent, and whatever else is rare.
MDANA_TARGET __attribute__((noinline)) bool read_rare(std::string_view token, double& value) {
  const bool negative = token.front() == '-';
  const std::size_t e = token.find_first_of("eE");
  std::int64_t exponent = 0;
  if (e != std::string_view::npos && e + 1 < token.size()) {
    const std::string_view power = token.substr(e + 1 + (token[e + 1] == '+'));
    const Decimal d = read_decimal(token.data() + negative, static_cast<std::uint32_t>(e - negative));
    if (d.valid && d.digits <= exact_integers && power.size() <= 4 && parse_number(power, exponent)) {
      exponent -= d.decimals;
      if (exponent >= -22 && exponent <= 22) {
        const auto digits = static_cast<double>(d.digits);
        value = exponent < 0 ? digits / powers_of_ten[-exponent] : digits * powers_of_ten[exponent];
        if (negative) value = -value;
        return true;
      }
    }
  }
  return parse_number(token, value);
}

MDANA_INLINE bool read_real(const char* text, std::uint32_t length, double& value) {
  const bool negative = *text == '-';
  const Decimal d = read_decimal(text + negative, length - negative);
  if (__builtin_expect(!d.valid || d.digits > exact_integers, 0))
    return read_rare({text, length}, value);
  value = static_cast<double>(static_cast<std::int64_t>(d.digits)) / powers_of_ten[d.decimals];
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  bits |= static_cast<std::uint64_t>(negative) << 63;
  std::memcpy(&value, &bits, sizeof bits);
  return true;
}

MDANA_INLINE bool read_integer(const char* text, std::uint32_t length, std::int64_t& value) {
  const bool negative = *text == '-';
  const Decimal d = read_decimal(text + negative, length - negative);
  if (__builtin_expect(!d.valid || d.point, 0)) return parse_number({text, length}, value);
  value = static_cast<std::int64_t>(d.digits);
  if (negative) value = -value;
  return true;
}

/// A bit for each of 64 bytes.
struct Masks {
  std::uint64_t blank, newline;  ///< blanks include line ends
};

MDANA_INLINE std::uint64_t bits(__m256i low, __m256i high) {
  return static_cast<std::uint32_t>(_mm256_movemask_epi8(low)) |
         static_cast<std::uint64_t>(static_cast<std::uint32_t>(_mm256_movemask_epi8(high))) << 32;
}

MDANA_INLINE Masks masks_of(const char* text) {
  const __m256i low = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(text));
  const __m256i high = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(text + 32));
  const __m256i space = _mm256_set1_epi8(' '), newline = _mm256_set1_epi8('\n');
  return {bits(_mm256_cmpeq_epi8(_mm256_max_epu8(low, space), space),
               _mm256_cmpeq_epi8(_mm256_max_epu8(high, space), space)),
          bits(_mm256_cmpeq_epi8(low, newline), _mm256_cmpeq_epi8(high, newline))};
}

/// Starts and ends of the columns of one line within Words * 64 bytes.
template <int Words>
struct LineMasks {
  std::uint64_t starts[Words], ends[Words];
  std::uint32_t length;   ///< without the line end; Words * 64 if there is none
  std::uint32_t columns;  ///< that begin before the line end

  MDANA_INLINE explicit LineMasks(const char* text) : length(Words * 64), columns(0) {
    std::uint64_t before = 1;  // the line begins behind a blank
    for (int w = 0; w < Words; ++w) {
      const Masks m = masks_of(text + 64 * w);
      const std::uint64_t behind_blank = m.blank << 1 | before;
      starts[w] = ~m.blank & behind_blank;
      ends[w] = m.blank & ~behind_blank;
      before = m.blank >> 63;
      if (length < static_cast<std::uint32_t>(64 * w)) continue;
      const std::uint64_t in_line = m.newline ? _blsmsk_u64(m.newline) : ~std::uint64_t{0};
      columns += static_cast<std::uint32_t>(_mm_popcnt_u64(starts[w] & in_line));
      if (m.newline) length = static_cast<std::uint32_t>(64 * w + _tzcnt_u64(m.newline));
    }
  }

  /// Position of the k-th set bit.
  MDANA_INLINE static std::uint32_t select(const std::uint64_t (&words)[Words], std::uint32_t k) {
    for (int w = 0; w < Words - 1; ++w) {
      const auto count = static_cast<std::uint32_t>(_mm_popcnt_u64(words[w]));
      if (k < count) return static_cast<std::uint32_t>(64 * w) + nth(words[w], k);
      k -= count;
    }
    return 64 * (Words - 1) + nth(words[Words - 1], k);
  }
  MDANA_INLINE static std::uint32_t nth(std::uint64_t word, std::uint32_t k) {
    return static_cast<std::uint32_t>(_tzcnt_u64(_pdep_u64(std::uint64_t{1} << k, word)));
  }
};

template <int Words>
MDANA_TARGET LineKernel::Scanned scan_lines(const char* text, std::size_t lines,
                                            const LineShape& shape, TokenBatch* batches) {
  const char* at = text;
  const std::size_t wanted = shape.wanted.size();
  for (std::size_t i = 0; i < lines; ++i) {
    const LineMasks<Words> line(at);
    if (line.columns != shape.columns || line.length >= Words * 64) return {i, at};
    const auto offset = static_cast<std::uint32_t>(at - text);
    for (std::size_t k = 0; k < wanted; ++k) {
      const std::uint32_t start = LineMasks<Words>::select(line.starts, shape.wanted[k]);
      const std::uint32_t end = LineMasks<Words>::select(line.ends, shape.wanted[k]);
      batches[k].offset[i] = offset + start;
      batches[k].length[i] = static_cast<std::uint8_t>(end - start);
    }
    at += line.length + 1;
  }
  return {lines, at};
}

/// Short lines first; where they are longer, twice as many bytes a line.
MDANA_TARGET LineKernel::Scanned scan(const char* text, std::size_t lines, const LineShape& shape,
                                      TokenBatch* batches) {
  if (shape.columns > 64) return {0, text};
  const LineKernel::Scanned scanned = scan_lines<2>(text, lines, shape, batches);
  return scanned.lines > 0 ? scanned : scan_lines<4>(text, lines, shape, batches);
}

MDANA_TARGET std::uint64_t reals(const char* text, const TokenBatch& tokens, std::size_t lines,
                                 double* values) {
  std::uint64_t failed = 0;
  for (std::size_t i = 0; i < lines; ++i)
    if (!read_real(text + tokens.offset[i], tokens.length[i], values[i]))
      failed |= std::uint64_t{1} << i;
  return failed;
}

MDANA_TARGET std::uint64_t integers(const char* text, const TokenBatch& tokens, std::size_t lines,
                                    std::int64_t* values) {
  std::uint64_t failed = 0;
  for (std::size_t i = 0; i < lines; ++i)
    if (!read_integer(text + tokens.offset[i], tokens.length[i], values[i]))
      failed |= std::uint64_t{1} << i;
  return failed;
}

bool supported() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2"); }

}  // namespace

extern const LineKernel avx2_kernel;
const LineKernel avx2_kernel{"avx2", supported, scan, reals, integers};

}  // namespace mdana::lammps_text

#endif
