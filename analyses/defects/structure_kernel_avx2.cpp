// SPDX-License-Identifier: GPL-3.0-or-later
//
// Eight candidates at once; the twelve bond masks are sixteen words of a register.
#if defined(__x86_64__)

#include "analyses/defects/structure_kernel.hpp"

#include <immintrin.h>

#include "analyses/defects.hpp"

// Only these functions may use the instructions: they run after `supported` has asked.
#define MDANA_TARGET __attribute__((target("avx2,bmi,bmi2,lzcnt,popcnt")))
#define MDANA_INLINE MDANA_TARGET inline __attribute__((always_inline))

namespace mdana::defects {
namespace {

MDANA_INLINE void copy_row(const CellGrid& grid, std::size_t first, std::size_t end,
                           const std::array<std::int32_t, 3>& middle, Candidates& to) {
  const __m256 unit = _mm256_set1_ps(static_cast<float>(1 / units_a_spacing));
  const std::int32_t* from[] = {grid.x.data(), grid.y.data(), grid.z.data()};
  float* out[] = {to.x + to.count, to.y + to.count, to.z + to.count};
  for (int k = 0; k < 3; ++k) {
    const __m256i m = _mm256_set1_epi32(middle[static_cast<std::size_t>(k)]);
    for (std::size_t s = first; s < end; s += 8) {
      const __m256i at = _mm256_sub_epi32(
          _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from[k] + s)), m);
      _mm256_storeu_ps(out[k] + (s - first), _mm256_mul_ps(unit, _mm256_cvtepi32_ps(at)));
    }
  }
  to.count += end - first;
}

MDANA_INLINE __m256 squared(__m256 dx, __m256 dy, __m256 dz) {
  return _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(dx, dx), _mm256_mul_ps(dy, dy)),
                       _mm256_mul_ps(dz, dz));
}

/// Lanes that bring the chosen ones of eight to the front, a nibble each.
MDANA_INLINE __m256i front(std::uint32_t found) {
  const std::uint64_t chosen = _pdep_u64(found, 0x1111111111111111) * 0xf;
  const std::uint64_t lanes = _pext_u64(0x76543210, chosen);
  const __m256i wide = _mm256_set1_epi32(static_cast<int>(lanes));
  return _mm256_srlv_epi32(wide, _mm256_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28));
}

MDANA_INLINE void find_near(const Candidates& all, std::size_t self, float limit, Near& near) {
  const __m256 x = _mm256_set1_ps(all.x[self]), y = _mm256_set1_ps(all.y[self]),
               z = _mm256_set1_ps(all.z[self]), cut = _mm256_set1_ps(limit);
  std::size_t n = 0;
  for (std::size_t i = 0; i < all.count; i += 8) {
    const __m256 dx = _mm256_sub_ps(_mm256_load_ps(all.x + i), x);
    const __m256 dy = _mm256_sub_ps(_mm256_load_ps(all.y + i), y);
    const __m256 dz = _mm256_sub_ps(_mm256_load_ps(all.z + i), z);
    const __m256 d2 = squared(dx, dy, dz);
    auto found = static_cast<std::uint32_t>(
        _mm256_movemask_ps(_mm256_cmp_ps(d2, cut, _CMP_LT_OQ)));
    if (self - i < 8) found &= ~(1u << (self - i));
    const __m256i lanes = front(found);
    _mm256_storeu_ps(near.x + n, _mm256_permutevar8x32_ps(dx, lanes));
    _mm256_storeu_ps(near.y + n, _mm256_permutevar8x32_ps(dy, lanes));
    _mm256_storeu_ps(near.z + n, _mm256_permutevar8x32_ps(dz, lanes));
    n += static_cast<std::size_t>(_mm_popcnt_u32(found));
  }
  near.count = n;
}

/// Sum of all sixteen, halves first, as the other kernels add.
MDANA_INLINE float sum(__m256 low, __m256 high) {
  const __m256 eight = _mm256_add_ps(low, high);
  const __m128 four = _mm_add_ps(_mm256_castps256_ps128(eight), _mm256_extractf128_ps(eight, 1));
  const __m128 two = _mm_add_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_add_ss(two, _mm_movehdup_ps(two)));
}

MDANA_INLINE float least(__m256 v) {
  const __m128 four = _mm_min_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
  const __m128 two = _mm_min_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)));
}

MDANA_INLINE __m256i without_lowest(__m256i v) {
  return _mm256_and_si256(v, _mm256_add_epi16(v, _mm256_set1_epi16(-1)));
}

MDANA_INLINE __m256i is_zero(__m256i v) { return _mm256_cmpeq_epi16(v, _mm256_setzero_si256()); }

/// Words with exactly one bit.
MDANA_INLINE __m256i single(__m256i v) {
  return _mm256_andnot_si256(is_zero(v), is_zero(without_lowest(v)));
}

/// How many of the first twelve words are set.
MDANA_INLINE int count(__m256i words) {
  return _mm_popcnt_u32(static_cast<std::uint32_t>(_mm256_movemask_epi8(words)) & 0xffffffu) / 2;
}

/// The first eight, and the last four with nothing behind them.
struct TwelveLanes {
  __m256 half[2];
};
MDANA_INLINE TwelveLanes twelve(const float* values) {
  const __m128 none = _mm_set1_ps(far_away);
  return {{_mm256_loadu_ps(values), _mm256_set_m128(none, _mm_loadu_ps(values + 8))}};
}

MDANA_INLINE std::uint8_t structure(const Near& t, float* margin) {
  const TwelveLanes x = twelve(t.x), y = twelve(t.y), z = twelve(t.z);
  __m256 distance[2];
  for (int h = 0; h < 2; ++h)
    distance[h] = _mm256_sqrt_ps(squared(x.half[h], y.half[h], z.half[h]));
  distance[1] = _mm256_blend_ps(distance[1], _mm256_setzero_ps(), 0xf0);
  const float cutoff =
      static_cast<float>(between_shells) * (sum(distance[0], distance[1]) / 12.0f);
  const float cut2 = cutoff * cutoff;
  const __m256 cut = _mm256_set1_ps(cut2), sign = _mm256_set1_ps(-0.0f);
  __m256 gap = _mm256_set1_ps(far_away);
  alignas(32) std::uint16_t bonded[16] = {};
  for (int k = 0; k < 12; ++k) {
    std::uint32_t mask = 0;
    for (int h = 0; h < 2; ++h) {
      const __m256 d2 = squared(_mm256_sub_ps(x.half[h], _mm256_set1_ps(t.x[k])),
                                _mm256_sub_ps(y.half[h], _mm256_set1_ps(t.y[k])),
                                _mm256_sub_ps(z.half[h], _mm256_set1_ps(t.z[k])));
      if (margin) gap = _mm256_min_ps(gap, _mm256_andnot_ps(sign, _mm256_sub_ps(d2, cut)));
      mask |= static_cast<std::uint32_t>(
                  _mm256_movemask_ps(_mm256_cmp_ps(d2, cut, _CMP_LT_OQ))) << (8 * h);
    }
    bonded[k] = static_cast<std::uint16_t>(mask & ~(1u << k));
  }
  const __m256i all = _mm256_load_si256(reinterpret_cast<const __m256i*>(bonded));
  __m256i once = _mm256_setzero_si256(), twice = once;
  for (int m = 0; m < 12; ++m) {
    const __m256i bit = _mm256_set1_epi16(static_cast<short>(1 << m));
    const __m256i with = _mm256_cmpeq_epi16(_mm256_and_si256(all, bit), bit);
    const __m256i theirs = _mm256_and_si256(
        with, _mm256_and_si256(all, _mm256_set1_epi16(static_cast<short>(bonded[m]))));
    twice = _mm256_or_si256(twice, _mm256_and_si256(once, theirs));
    once = _mm256_or_si256(once, theirs);
  }
  const __m256i four = single(without_lowest(without_lowest(without_lowest(all))));
  const __m256i p421 = _mm256_and_si256(
      four, _mm256_and_si256(_mm256_cmpeq_epi16(once, all), is_zero(twice)));
  const __m256i p422 = _mm256_and_si256(
      four, _mm256_and_si256(single(_mm256_xor_si256(all, once)), single(twice)));
  if (margin) *margin = std::min(1.0f, least(gap) / cut2 / perfect_gap);
  const int n421 = count(p421), n422 = count(p422);
  if (n421 == 12) return static_cast<std::uint8_t>(Structure::fcc);
  if (n421 == 6 && n422 == 6) return static_cast<std::uint8_t>(Structure::hcp);
  if (margin) *margin = 0;
  return static_cast<std::uint8_t>(Structure::other);
}

}  // namespace
}  // namespace mdana::defects

#include "analyses/defects/cell_labels.hpp"

namespace mdana::defects {

extern const StructureKernel avx2_structure_kernel;
const StructureKernel avx2_structure_kernel{
    "avx2",
    [] {
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2") &&
             __builtin_cpu_supports("popcnt");
    },
    label};

}  // namespace mdana::defects

#endif
