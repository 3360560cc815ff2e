// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/structure_kernel.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>

#include "analyses/defects.hpp"

#define MDANA_TARGET
#define MDANA_INLINE inline

namespace mdana::defects {

extern const StructureKernel avx512_structure_kernel;
extern const StructureKernel avx2_structure_kernel;

namespace {

using Mask = std::uint16_t;  ///< a bit for each of the twelve

MDANA_INLINE void copy_row(const CellGrid& grid, std::size_t first, std::size_t end,
                           const std::array<std::int32_t, 3>& middle, Candidates& to) {
  constexpr float unit = static_cast<float>(1 / units_a_spacing);
  const auto relative = [&](std::int32_t at, std::size_t k) {
    return unit * static_cast<float>(static_cast<std::int32_t>(static_cast<std::uint32_t>(at) -
                                                               static_cast<std::uint32_t>(middle[k])));
  };
  for (std::size_t s = first; s < end; ++s) {
    const std::size_t i = to.count + (s - first);
    to.x[i] = relative(grid.x[s], 0);
    to.y[i] = relative(grid.y[s], 1);
    to.z[i] = relative(grid.z[s], 2);
  }
  to.count += end - first;
}

float distance2(const Near& near, std::size_t i) {
  return near.x[i] * near.x[i] + near.y[i] * near.y[i] + near.z[i] * near.z[i];
}

MDANA_INLINE void find_near(const Candidates& all, std::size_t self, float limit, Near& near) {
  const float x = all.x[self], y = all.y[self], z = all.z[self];
  near.count = 0;
  for (std::size_t i = 0; i < all.count; ++i) {
    const float dx = all.x[i] - x, dy = all.y[i] - y, dz = all.z[i] - z;
    const float d2 = dx * dx + dy * dy + dz * dz;
    if (!(d2 < limit) || i == self) continue;
    near.x[near.count] = dx;
    near.y[near.count] = dy;
    near.z[near.count++] = dz;
  }
}

/// Square of the local cutoff of twelve.
float cutoff2(const Near& near) {
  float sum[16] = {};
  for (std::size_t i = 0; i < 12; ++i) sum[i] = std::sqrt(distance2(near, i));
  for (int half = 8; half > 0; half /= 2)
    for (int i = 0; i < half; ++i) sum[i] += sum[i + half];
  const float cutoff = static_cast<float>(between_shells) * (sum[0] / 12.0f);
  return cutoff * cutoff;
}

/// Which of the twelve are bonded to each; the least gap to the cutoff.
float bonds(const Near& t, float cut2, Mask* bonded) {
  float gap = far_away;
  for (int k = 0; k < 12; ++k) {
    Mask mask = 0;
    for (int i = 0; i < 12; ++i) {
      const float dx = t.x[i] - t.x[k], dy = t.y[i] - t.y[k], dz = t.z[i] - t.z[k];
      const float d2 = dx * dx + dy * dy + dz * dz;
      gap = std::min(gap, std::abs(d2 - cut2));
      if (d2 < cut2 && i != k) mask = static_cast<Mask>(mask | 1u << i);
    }
    bonded[k] = mask;
  }
  return gap;
}

bool is_single(Mask mask) { return std::popcount(mask) == 1; }

/// Four common neighbours with two bonds among them: apart (421) or with an atom in common (422).
enum class Pair { other, p421, p422 };

Pair pair_of(const Mask* bonded, int k) {
  const Mask common = bonded[k];
  if (std::popcount(common) != 4) return Pair::other;
  Mask once = 0, twice = 0;  // common neighbours with at least one bond, two bonds
  for (int m = 0; m < 12; ++m) {
    if (!(common >> m & 1)) continue;
    const Mask theirs = common & bonded[m];
    twice = static_cast<Mask>(twice | (once & theirs));
    once = static_cast<Mask>(once | theirs);
  }
  if (once == common && twice == 0) return Pair::p421;
  return is_single(common ^ once) && is_single(twice) ? Pair::p422 : Pair::other;
}

MDANA_INLINE std::uint8_t structure(const Near& twelve, float* margin) {
  const float cut2 = cutoff2(twelve);
  Mask bonded[12];
  const float gap = bonds(twelve, cut2, bonded);
  if (margin) *margin = std::min(1.0f, gap / cut2 / perfect_gap);
  int p421 = 0, p422 = 0;
  for (int k = 0; k < 12; ++k) {
    const Pair pair = pair_of(bonded, k);
    p421 += pair == Pair::p421;
    p422 += pair == Pair::p422;
  }
  if (p421 == 12) return static_cast<std::uint8_t>(Structure::fcc);
  if (p421 == 6 && p422 == 6) return static_cast<std::uint8_t>(Structure::hcp);
  if (margin) *margin = 0;
  return static_cast<std::uint8_t>(Structure::other);
}

}  // namespace
}  // namespace mdana::defects

#include "analyses/defects/cell_labels.hpp"

namespace mdana::defects {
namespace {

const StructureKernel portable_kernel{"portable", [] { return true; }, label};

}  // namespace

void keep_nearest(Near& near) {
  std::array<std::pair<float, std::size_t>, 12> nearest;
  nearest.fill({far_away * far_away, 0});
  for (std::size_t i = 0; i < near.count; ++i) {
    const float d2 = distance2(near, i);
    if (!(d2 < nearest[11].first)) continue;
    std::size_t at = 11;
    for (; at > 0 && d2 < nearest[at - 1].first; --at) nearest[at] = nearest[at - 1];
    nearest[at] = {d2, i};
  }
  std::array<std::size_t, 12> order;
  for (std::size_t k = 0; k < 12; ++k) order[k] = nearest[k].second;
  std::sort(order.begin(), order.end());
  for (std::size_t k = 0; k < 12; ++k)
    for (float* values : {near.x, near.y, near.z}) values[k] = values[order[k]];
  near.count = 12;
}

Structure structure_of(const Neighbours& all, float* margin) {
  constexpr float shell = static_cast<float>(between_shells * between_shells);
  const auto near = std::make_unique_for_overwrite<Near>();
  const auto within = [&](float limit) {
    near->count = 0;
    for (const Neighbour& n : all) {
      if (!(n.d2 < limit)) continue;
      near->x[near->count] = n.offset.x();
      near->y[near->count] = n.offset.y();
      near->z[near->count++] = n.offset.z();
    }
  };
  within(shell);
  if (near->count != 12) {
    within(far_away * far_away);
    keep_nearest(*near);
  }
  return static_cast<Structure>(structure(*near, margin));
}

std::span<const StructureKernel* const> structure_kernels() {
#if defined(__x86_64__)
  static constexpr const StructureKernel* kernels[] = {&avx512_structure_kernel,
                                                       &avx2_structure_kernel, &portable_kernel};
#else
  static constexpr const StructureKernel* kernels[] = {&portable_kernel};
#endif
  return kernels;
}

const StructureKernel& best_structure_kernel() {
  static const StructureKernel& best = []() -> const StructureKernel& {
    for (const StructureKernel* kernel : structure_kernels())
      if (kernel->supported()) return *kernel;
    return portable_kernel;
  }();
  return best;
}

}  // namespace mdana::defects
