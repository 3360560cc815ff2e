// SPDX-License-Identifier: GPL-3.0-or-later
//
// Four numbers at once. The 16 bytes before the end of each token are its digits, aligned; where
// there is a point, the bytes up to it are taken from one byte earlier, which drops it. Multiplied
// out in four steps they are integers; the quotient of an integer below 2^53 and a power of ten up
// to 10^22 is correctly rounded (Clinger 1990).
#if defined(__x86_64__)

#include "readers/line_kernel.hpp"

#include <immintrin.h>

// Only these functions may use the instructions: they run after `supported` has asked.
#define MDANA_TARGET __attribute__((target("avx2,bmi,bmi2,lzcnt,popcnt")))
#define MDANA_INLINE MDANA_TARGET inline __attribute__((always_inline))

namespace mdana {
namespace {

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

}  // namespace
}  // namespace mdana

#include "readers/line_scan.hpp"

namespace mdana {
namespace {

constexpr std::size_t at_once = 4;
constexpr std::uint64_t two_52 = std::uint64_t{1} << 52;

/// 16 bytes from the n-th on have their last n bytes set (all of them beyond 16).
alignas(64) constexpr std::uint8_t last_bytes[64] = {
    0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,
    255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255,
    255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255,
    255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255};

/// 16 bytes from the q-th on have their first 16 - q bytes set.
alignas(32) constexpr std::uint8_t first_bytes[32] = {
    255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255,
    0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0};

/// By the number of digits behind the point; 16 stands for no point.
constexpr double scales[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7, 1e8,
                             1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e0};

MDANA_INLINE __m128i load(const void* from) {
  return _mm_loadu_si128(static_cast<const __m128i*>(from));
}

/// A decimal number without sign and exponent.
struct Aligned {
  __m128i digits;          ///< 0 to 9, the last one last
  std::uint32_t decimals;  ///< behind the point; 16 if there is none
  bool negative;
  bool countable;          ///< 1 to 16 digits
};

MDANA_INLINE Aligned aligned(const char* start, std::uint32_t length) {
  Aligned a;
  a.negative = *start == '-';
  const char* end = start + length;
  const std::uint32_t n = length - a.negative;
  const std::uint32_t most = n < 32 ? n : 32;
  const __m128i bytes = load(end - 16);
  const __m128i points =
      _mm_and_si128(_mm_cmpeq_epi8(bytes, _mm_set1_epi8('.')), load(last_bytes + most));
  // The last point counts; one before it is a wrong digit.
  a.decimals = _lzcnt_u32(static_cast<std::uint32_t>(_mm_movemask_epi8(points))) - 16;
  const __m128i joined = _mm_blendv_epi8(bytes, load(end - 17), load(first_bytes + a.decimals));
  const std::uint32_t digits = most - (a.decimals < 16);
  a.digits = _mm_and_si128(_mm_sub_epi8(joined, _mm_set1_epi8('0')), load(last_bytes + digits));
  a.countable = digits - 1 < 16;
  return a;
}

/// Decimal numbers of four tokens.
struct Decimals {
  __m256i digits;  ///< all of each as one integer
  __m256d scale;   ///< 10 to the number of digits behind the point
  __m256i sign;    ///< its bit
  std::uint32_t negative, fraction, wrong;  ///< a bit each
};

MDANA_INLINE Decimals decimals_of(const char* text, const std::uint32_t* offset,
                                  const std::uint8_t* length) {
  const Aligned t0 = aligned(text + offset[0], length[0]), t1 = aligned(text + offset[1], length[1]),
                t2 = aligned(text + offset[2], length[2]), t3 = aligned(text + offset[3], length[3]);
  const __m256i even = _mm256_set_m128i(t2.digits, t0.digits);
  const __m256i odd = _mm256_set_m128i(t3.digits, t1.digits);
  const __m256i pair = _mm256_set1_epi16(0x010a), square = _mm256_set1_epi32(0x00010064);
  const __m256i fours =
      _mm256_packus_epi32(_mm256_madd_epi16(_mm256_maddubs_epi16(even, pair), square),
                          _mm256_madd_epi16(_mm256_maddubs_epi16(odd, pair), square));
  const __m256i eights = _mm256_madd_epi16(fours, _mm256_set1_epi32(0x00012710));
  Decimals d;
  d.digits = _mm256_add_epi64(_mm256_mul_epu32(eights, _mm256_set1_epi64x(100000000)),
                              _mm256_srli_epi64(eights, 32));
  d.scale = _mm256_setr_pd(scales[t0.decimals], scales[t1.decimals], scales[t2.decimals],
                           scales[t3.decimals]);
  d.negative = t0.negative | t1.negative << 1 | t2.negative << 2 | t3.negative << 3;
  d.fraction = (t0.decimals < 16) | (t1.decimals < 16) << 1 | (t2.decimals < 16) << 2 |
               (t3.decimals < 16) << 3;
  // Whether all 16 bytes of a token are within 0 to 9; packing puts the tokens in their order.
  const __m256i nine = _mm256_set1_epi8(9);
  const __m256i zero = _mm256_setzero_si256();
  const __m256i within =
      _mm256_packs_epi16(_mm256_cmpeq_epi16(_mm256_subs_epu8(even, nine), zero),
                         _mm256_cmpeq_epi16(_mm256_subs_epu8(odd, nine), zero));
  const __m256i all = _mm256_cmpeq_epi64(within, _mm256_set1_epi64x(-1));
  const auto right = static_cast<std::uint32_t>(_mm256_movemask_pd(_mm256_castsi256_pd(all)));
  const std::uint32_t countable =
      t0.countable | t1.countable << 1 | t2.countable << 2 | t3.countable << 3;
  d.wrong = ~(right & countable) & 15;
  return d;
}

/// Bits of the tokens that are no numbers in reach.
MDANA_INLINE std::uint64_t reals_of(const char* text, const std::uint32_t* offset,
                                   const std::uint8_t* length, double* values) {
  const Decimals d = decimals_of(text, offset, length);
  // Exact below 2^52: the bits of 2^52 + digits, less 2^52.
  const __m256i magic = _mm256_set1_epi64x(0x4330000000000000);
  const __m256d digits = _mm256_sub_pd(_mm256_castsi256_pd(_mm256_or_si256(d.digits, magic)),
                                       _mm256_castsi256_pd(magic));
  const __m256i bit = _mm256_setr_epi64x(1, 2, 4, 8);
  const __m256i negative = _mm256_cmpeq_epi64(
      _mm256_and_si256(_mm256_set1_epi64x(static_cast<long long>(d.negative)), bit), bit);
  const __m256d sign = _mm256_castsi256_pd(_mm256_slli_epi64(negative, 63));
  _mm256_storeu_pd(values, _mm256_or_pd(_mm256_div_pd(digits, d.scale), sign));
  const __m256i large = _mm256_cmpgt_epi64(d.digits, _mm256_set1_epi64x(two_52 - 1));
  return d.wrong | static_cast<std::uint32_t>(_mm256_movemask_pd(_mm256_castsi256_pd(large)));
}

MDANA_INLINE std::uint64_t integers_of(const char* text, const std::uint32_t* offset,
                                      const std::uint8_t* length, std::int64_t* values) {
  const Decimals d = decimals_of(text, offset, length);
  const __m256i bit = _mm256_setr_epi64x(1, 2, 4, 8);
  const __m256i negative = _mm256_cmpeq_epi64(
      _mm256_and_si256(_mm256_set1_epi64x(static_cast<long long>(d.negative)), bit), bit);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(values),
                      _mm256_sub_epi64(_mm256_xor_si256(d.digits, negative), negative));
  return d.wrong | d.fraction;
}

}  // namespace
}  // namespace mdana

#include "readers/line_groups.hpp"

namespace mdana {
namespace {

bool supported() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2"); }

}  // namespace

extern const LineKernel avx2_kernel;
const LineKernel avx2_kernel{"avx2", supported, scan, reals, integers};

}  // namespace mdana

#endif
