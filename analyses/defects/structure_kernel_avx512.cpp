// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sixteen candidates at once; the twelve bond masks are sixteen words of a register.
#if defined(__x86_64__)

#include "analyses/defects/structure_kernel.hpp"

// GCC 12 warns of its own header (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#include <immintrin.h>

#include "analyses/defects.hpp"

// Only these functions may use the instructions: they run after `supported` has asked.
#define MDANA_TARGET \
  __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,avx2,bmi,bmi2,lzcnt,popcnt")))
#define MDANA_INLINE MDANA_TARGET inline __attribute__((always_inline))

namespace mdana::defects {
namespace {

MDANA_INLINE void copy_row(const CellGrid& grid, std::size_t first, std::size_t end,
                           const std::array<std::int32_t, 3>& middle, Candidates& to) {
  const __m512 unit = _mm512_set1_ps(static_cast<float>(1 / units_a_spacing));
  const std::int32_t* from[] = {grid.x.data(), grid.y.data(), grid.z.data()};
  float* out[] = {to.x + to.count, to.y + to.count, to.z + to.count};
  for (int k = 0; k < 3; ++k) {
    const __m512i m = _mm512_set1_epi32(middle[static_cast<std::size_t>(k)]);
    for (std::size_t s = first; s < end; s += 16) {
      const __m512i at = _mm512_sub_epi32(_mm512_loadu_si512(from[k] + s), m);
      _mm512_storeu_ps(out[k] + (s - first), _mm512_mul_ps(unit, _mm512_cvtepi32_ps(at)));
    }
  }
  to.count += end - first;
}

MDANA_INLINE __m512 squared(__m512 dx, __m512 dy, __m512 dz) {
  return _mm512_add_ps(_mm512_add_ps(_mm512_mul_ps(dx, dx), _mm512_mul_ps(dy, dy)),
                       _mm512_mul_ps(dz, dz));
}

MDANA_INLINE void find_near(const Candidates& all, std::size_t self, float limit, Near& near) {
  const __m512 x = _mm512_set1_ps(all.x[self]), y = _mm512_set1_ps(all.y[self]),
               z = _mm512_set1_ps(all.z[self]), cut = _mm512_set1_ps(limit);
  std::size_t n = 0;
  for (std::size_t i = 0; i < all.count; i += 16) {
    const __m512 dx = _mm512_sub_ps(_mm512_load_ps(all.x + i), x);
    const __m512 dy = _mm512_sub_ps(_mm512_load_ps(all.y + i), y);
    const __m512 dz = _mm512_sub_ps(_mm512_load_ps(all.z + i), z);
    const __m512 d2 = squared(dx, dy, dz);
    std::uint32_t found = _mm512_cmp_ps_mask(d2, cut, _CMP_LT_OQ);
    if (self - i < 16) found &= ~(1u << (self - i));
    const auto mask = static_cast<__mmask16>(found);
    _mm512_storeu_ps(near.x + n, _mm512_maskz_compress_ps(mask, dx));
    _mm512_storeu_ps(near.y + n, _mm512_maskz_compress_ps(mask, dy));
    _mm512_storeu_ps(near.z + n, _mm512_maskz_compress_ps(mask, dz));
    n += static_cast<std::size_t>(_mm_popcnt_u32(found));
  }
  near.count = n;
}

/// Sum of all, halves first, as the other kernels add.
MDANA_INLINE float sum(__m512 v) {
  const __m256 eight = _mm256_add_ps(_mm512_castps512_ps256(v), _mm512_extractf32x8_ps(v, 1));
  const __m128 four = _mm_add_ps(_mm256_castps256_ps128(eight), _mm256_extractf128_ps(eight, 1));
  const __m128 two = _mm_add_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_add_ss(two, _mm_movehdup_ps(two)));
}

/// Words with exactly one bit.
MDANA_INLINE std::uint32_t single(__m256i v) {
  const __m256i rest = _mm256_and_si256(v, _mm256_add_epi16(v, _mm256_set1_epi16(-1)));
  return _mm256_testn_epi16_mask(rest, rest) & _mm256_test_epi16_mask(v, v);
}

MDANA_INLINE __m256i without_lowest(__m256i v) {
  return _mm256_and_si256(v, _mm256_add_epi16(v, _mm256_set1_epi16(-1)));
}

MDANA_INLINE __m512 twelve(const float* values, __m512 behind) {
  return _mm512_mask_loadu_ps(behind, 0xfff, values);
}

MDANA_INLINE std::uint8_t structure(const Near& t, float* margin) {
  const __m512 none = _mm512_set1_ps(far_away);
  const __m512 x = twelve(t.x, none), y = twelve(t.y, none), z = twelve(t.z, none);
  const __m512 distance = _mm512_maskz_sqrt_ps(0xfff, squared(x, y, z));
  const float cutoff = static_cast<float>(between_shells) * (sum(distance) / 12.0f);
  const float cut2 = cutoff * cutoff;
  const __m512 cut = _mm512_set1_ps(cut2);
  __m512 gap = none;
  alignas(32) std::uint16_t bonded[16] = {};
  for (int k = 0; k < 12; ++k) {
    const __m512 d2 = squared(_mm512_sub_ps(x, _mm512_set1_ps(t.x[k])),
                              _mm512_sub_ps(y, _mm512_set1_ps(t.y[k])),
                              _mm512_sub_ps(z, _mm512_set1_ps(t.z[k])));
    if (margin) gap = _mm512_min_ps(gap, _mm512_abs_ps(_mm512_sub_ps(d2, cut)));
    bonded[k] = static_cast<std::uint16_t>(_mm512_cmp_ps_mask(d2, cut, _CMP_LT_OQ) & ~(1u << k));
  }
  const __m256i all = _mm256_load_si256(reinterpret_cast<const __m256i*>(bonded));
  __m256i once = _mm256_setzero_si256(), twice = once;
  for (int m = 0; m < 12; ++m) {
    const __m256i theirs = _mm256_and_si256(
        all, _mm256_maskz_set1_epi16(bonded[m], static_cast<short>(bonded[m])));
    twice = _mm256_or_si256(twice, _mm256_and_si256(once, theirs));
    once = _mm256_or_si256(once, theirs);
  }
  const std::uint32_t four =
      single(without_lowest(without_lowest(without_lowest(all)))) & 0xfffu;
  const std::uint32_t p421 =
      four & _mm256_cmpeq_epi16_mask(once, all) & _mm256_testn_epi16_mask(twice, twice);
  const std::uint32_t p422 = four & single(_mm256_xor_si256(all, once)) & single(twice);
  if (margin) *margin = std::min(1.0f, _mm512_reduce_min_ps(gap) / cut2 / perfect_gap);
  if (p421 == 0xfff) return static_cast<std::uint8_t>(Structure::fcc);
  if (_mm_popcnt_u32(p421) == 6 && _mm_popcnt_u32(p422) == 6)
    return static_cast<std::uint8_t>(Structure::hcp);
  if (margin) *margin = 0;
  return static_cast<std::uint8_t>(Structure::other);
}

}  // namespace
}  // namespace mdana::defects

#include "analyses/defects/cell_labels.hpp"

namespace mdana::defects {

extern const StructureKernel avx512_structure_kernel;
const StructureKernel avx512_structure_kernel{
    "avx512",
    [] {
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
             __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("popcnt");
    },
    label};

}  // namespace mdana::defects

#endif
