// SPDX-License-Identifier: GPL-3.0-or-later
//
// Eight numbers at once. The 16 bytes before the end of each token are its digits, aligned; where
// there is a point, the bytes up to it are taken from one byte earlier, which drops it. Multiplied
// out in four steps they are integers; the quotient of an integer below 2^53 and a power of ten up
// to 10^22 is correctly rounded (Clinger 1990).
#if defined(__x86_64__)

#include "readers/line_kernel.hpp"

// GCC 12 warns of its own header (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#include <immintrin.h>

// Only these functions may use the instructions: they run after `supported` has asked.
#define MDANA_TARGET \
  __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,avx512cd,avx2,bmi,bmi2,lzcnt,popcnt")))
#define MDANA_INLINE MDANA_TARGET inline __attribute__((always_inline))

namespace mdana {
namespace {

/// A bit for each of 64 bytes.
struct Masks {
  std::uint64_t blank, newline;  ///< blanks include line ends
};

MDANA_INLINE Masks masks_of(const char* text) {
  const __m512i bytes = _mm512_loadu_si512(text);
  return {_mm512_cmple_epu8_mask(bytes, _mm512_set1_epi8(' ')),
          _mm512_cmpeq_epi8_mask(bytes, _mm512_set1_epi8('\n'))};
}

}  // namespace
}  // namespace mdana

#include "readers/line_scan.hpp"

namespace mdana {
namespace {

constexpr std::size_t at_once = 8;

/// Eight tokens, in 16-bit lanes where not said otherwise.
struct Tokens {
  const char* ends[at_once];
  __m128i length;      ///< without the sign
  __mmask8 negative;
};

MDANA_INLINE Tokens tokens_of(const char* text, const std::uint32_t* offset,
                              const std::uint8_t* length) {
  Tokens t;
  std::uint32_t negative = 0;
  for (std::size_t i = 0; i < at_once; ++i) {
    const char* start = text + offset[i];
    negative |= static_cast<std::uint32_t>(*start == '-') << i;
    t.ends[i] = start + length[i];
  }
  t.negative = static_cast<__mmask8>(negative);
  const __m128i all =
      _mm_cvtepu8_epi16(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(length)));
  t.length = _mm_add_epi16(all, _mm_movm_epi16(t.negative));  // minus one
  return t;
}

/// 16 bytes of each of four tokens, up to `before` bytes before their ends.
MDANA_INLINE __m512i four(const char* const* ends, std::ptrdiff_t before) {
  const auto bytes = [&](int i) MDANA_TARGET {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(ends[2 * i] - 16 - before));
  };
  const __m256i low = _mm256_inserti128_si256(_mm256_castsi128_si256(bytes(0)), bytes(1), 1);
  const __m256i high = _mm256_inserti128_si256(_mm256_castsi128_si256(bytes(2)), bytes(3), 1);
  return _mm512_inserti64x4(_mm512_castsi256_si512(low), high, 1);
}

/// The last n of 16 bits, for n up to 16 and beyond.
MDANA_INLINE __m128i last_bits(__m128i n) {
  return _mm_sllv_epi16(_mm_set1_epi16(-1), _mm_subs_epu16(_mm_set1_epi16(16), n));
}

/// Lanes 0 2 4 6 and lanes 1 3 5 7 as masks of the bytes of four tokens each, and back.
struct ByteMasks {
  __mmask64 even, odd;
};
MDANA_INLINE ByteMasks bytes_of(__m128i lanes) {
  const __m128i order = _mm_setr_epi8(0, 1, 4, 5, 8, 9, 12, 13, 2, 3, 6, 7, 10, 11, 14, 15);
  const __m128i sorted = _mm_shuffle_epi8(lanes, order);
  return {static_cast<__mmask64>(_mm_cvtsi128_si64(sorted)),
          static_cast<__mmask64>(_mm_extract_epi64(sorted, 1))};
}
MDANA_INLINE __m128i lanes_of(const ByteMasks& masks) {
  return _mm_unpacklo_epi16(_mm_cvtsi64_si128(static_cast<long long>(masks.even)),
                            _mm_cvtsi64_si128(static_cast<long long>(masks.odd)));
}

/// Decimal numbers without sign and exponent.
struct Decimals {
  __m512i digits;     ///< all of each as one integer
  __m128i point;      ///< bit of the point among the last 16 bytes; 0 if there is none
  __mmask8 valid;     ///< 1 to 16 digits and at most one point
};

MDANA_INLINE Decimals decimals_of(const Tokens& t) {
  const __m512i even = four(t.ends, 0), odd = four(t.ends + 1, 0);
  const ByteMasks inside = bytes_of(last_bits(t.length));
  const __m512i point = _mm512_set1_epi8('.');
  Decimals d;
  d.point = lanes_of({_mm512_mask_cmpeq_epi8_mask(inside.even, even, point),
                      _mm512_mask_cmpeq_epi8_mask(inside.odd, odd, point)});
  const __m128i none = _mm_cmpeq_epi16(d.point, _mm_setzero_si128());
  const __m128i up_to_point = _mm_andnot_si128(
      none, _mm_sub_epi16(_mm_add_epi16(d.point, d.point), _mm_set1_epi16(1)));
  const __m128i count =
      _mm_sub_epi16(_mm_sub_epi16(t.length, _mm_set1_epi16(1)), none);  // without the point
  const ByteMasks earlier = bytes_of(up_to_point), digits = bytes_of(last_bits(count));
  const __m512i zero = _mm512_set1_epi8('0');
  const __m512i a = _mm512_maskz_sub_epi8(
      digits.even, _mm512_mask_blend_epi8(earlier.even, even, four(t.ends, 1)), zero);
  const __m512i b = _mm512_maskz_sub_epi8(
      digits.odd, _mm512_mask_blend_epi8(earlier.odd, odd, four(t.ends + 1, 1)), zero);
  const __m128i wrong = lanes_of({_mm512_cmpgt_epu8_mask(a, _mm512_set1_epi8(9)),
                                  _mm512_cmpgt_epu8_mask(b, _mm512_set1_epi8(9))});
  d.valid = static_cast<__mmask8>(
      _mm_testn_epi16_mask(wrong, wrong) &
      _mm_cmplt_epu16_mask(_mm_sub_epi16(count, _mm_set1_epi16(1)), _mm_set1_epi16(16)));
  const __m512i pair = _mm512_set1_epi16(0x010a), square = _mm512_set1_epi32(0x00010064);
  const __m512i fours =
      _mm512_packus_epi32(_mm512_madd_epi16(_mm512_maddubs_epi16(a, pair), square),
                          _mm512_madd_epi16(_mm512_maddubs_epi16(b, pair), square));
  const __m512i eights = _mm512_madd_epi16(fours, _mm512_set1_epi32(0x00012710));
  d.digits = _mm512_add_epi64(_mm512_mul_epu32(eights, _mm512_set1_epi64(100000000)),
                              _mm512_srli_epi64(eights, 32));
  return d;
}

/// 10 to the number of digits behind the point, of which `point` is the bit.
MDANA_INLINE __m512d scale_of(__m128i point) {
  const __m512d low = _mm512_setr_pd(1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7);
  const __m512d high = _mm512_setr_pd(1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15);
  // Leading zeros of 64 bits: 48 + (15 - position); 64 if there is no point. Four bits count.
  const __m512i power = _mm512_lzcnt_epi64(_mm512_cvtepu16_epi64(point));
  return _mm512_permutex2var_pd(low, power, high);
}

/// Bits of the tokens that are no numbers in reach.
MDANA_INLINE std::uint64_t reals_of(const char* text, const std::uint32_t* offset,
                                   const std::uint8_t* length, double* values) {
  const Tokens t = tokens_of(text, offset, length);
  const Decimals d = decimals_of(t);
  const __m512d quotient = _mm512_div_pd(_mm512_cvtepu64_pd(d.digits), scale_of(d.point));
  const __m512i sign = _mm512_maskz_set1_epi64(t.negative, static_cast<long long>(1ull << 63));
  _mm512_storeu_pd(values,
                   _mm512_castsi512_pd(_mm512_or_si512(_mm512_castpd_si512(quotient), sign)));
  const __mmask8 large = _mm512_cmpgt_epu64_mask(d.digits, _mm512_set1_epi64(1ll << 53));
  return static_cast<std::uint8_t>(~d.valid | large);
}

MDANA_INLINE std::uint64_t integers_of(const char* text, const std::uint32_t* offset,
                                      const std::uint8_t* length, std::int64_t* values) {
  const Tokens t = tokens_of(text, offset, length);
  const Decimals d = decimals_of(t);
  const __m512i value =
      _mm512_mask_sub_epi64(d.digits, t.negative, _mm512_setzero_si512(), d.digits);
  _mm512_storeu_si512(values, value);
  const __mmask8 fraction = _mm_test_epi16_mask(d.point, d.point);
  return static_cast<std::uint8_t>(~d.valid | fraction);
}

}  // namespace
}  // namespace mdana

#include "readers/line_groups.hpp"

namespace mdana {
namespace {

bool supported() {
  return __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512cd") &&
         __builtin_cpu_supports("bmi2");
}

}  // namespace

extern const LineKernel avx512_kernel;
const LineKernel avx512_kernel{"avx512", supported, scan, reals, integers};

}  // namespace mdana

#endif
