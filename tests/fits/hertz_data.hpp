// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "fits/hertz.hpp"

namespace mdana::test {

/// Two equal spheres pressed together and drawn apart again by F = 4/3 E* sqrt(R/2) (2R - X)^1.5.
struct Spheres {
  double radius, modulus;

  double force(double x) const {
    const double delta = std::max(0.0, 2 * radius - x);
    return 4.0 / 3 * modulus * std::sqrt(0.5 * radius) * delta * std::sqrt(delta);
  }

  /// `frames` each way, from before touch to delta = depth R.
  HertzData collision(int frames, double depth) const {
    HertzData data;
    data.turn = static_cast<std::size_t>(frames);
    for (int i = 0; i <= 2 * frames; ++i) {
      const double part = 1 - std::abs(i - frames) / static_cast<double>(frames);  // 0 to 1 to 0
      const double x =
          2 * radius - depth * radius * (1.2 * std::sin(0.5 * std::numbers::pi * part) - 0.2);
      data.distance.push_back(x);
      data.force.push_back(force(x));
    }
    return data;
  }
};

inline HertzData noisy(HertzData data, double part_of_maximum, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const double f_max = *std::max_element(data.force.begin(), data.force.end());
  std::normal_distribution<double> noise(0, part_of_maximum * f_max);
  for (double& f : data.force) f += noise(random);
  return data;
}

inline constexpr Spheres lj_spheres{29.6, 53.2};  // P1, Table II, first row
inline constexpr Spheres si_spheres{1e-7, 7e9};   // grains of ice
inline constexpr Spheres huge_spheres{1e6, 1e-12};

}  // namespace mdana::test
