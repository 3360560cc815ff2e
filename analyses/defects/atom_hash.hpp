// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace mdana::defects {

/// A number that looks drawn by chance but depends on another alone (Vigna's splitmix64).
constexpr std::uint64_t hash_of(std::uint64_t number) {
  std::uint64_t z = number * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace mdana::defects
