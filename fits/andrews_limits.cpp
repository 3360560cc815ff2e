// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/andrews_limits.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "fits/elastoplastic.hpp"

namespace mdana {
namespace {

using std::numbers::pi;

constexpr double least_share = 1e-4;  ///< E* is within 1e-4 of delta_max of infinite there

/// Y from m* v^2/2 = pi R* Y delta_max^2 (1/2 - s/3 + s^2/10), E* from s = (pi/2 Y/E*)^2 R*/delta_max.
DegeneratePair pair_of(const Impact& i, double delta_max, double share) {
  const double work = 0.5 - share / 3 + share * (share / 10);
  const double strength = i.mass * (i.velocity / delta_max) * (i.velocity / delta_max) / (2 * pi * i.radius * work);
  if (share == 0) return {0, std::numeric_limits<double>::infinity(), strength};
  return {share, pi / 2 * strength * std::sqrt(i.radius / (share * delta_max)), strength};
}

}  // namespace

Compressed elastic_limit(const Impact& i) {
  const double energy = i.mass / (i.radius * i.radius * i.radius) * (i.velocity * (i.velocity / i.modulus));
  const double delta = std::pow(15.0 / 16 * energy, 0.4) * i.radius;
  return {delta, elastic_compression_time() * delta / i.velocity};
}

Compressed rigid_plastic_limit(const Impact& i, double yield_strength) {
  const double time = std::sqrt(i.mass / (pi * i.radius * yield_strength));
  return {i.velocity * time, pi / 2 * time};
}

std::vector<DegeneratePair> degenerate_pairs(const Impact& impact, double delta_max, std::size_t count) {
  std::vector<DegeneratePair> pairs;
  for (std::size_t k = 0; k + 1 < count; ++k)
    pairs.push_back(pair_of(impact, delta_max,
                            std::pow(least_share, static_cast<double>(k) / static_cast<double>(count - 2))));
  pairs.push_back(pair_of(impact, delta_max, 0));
  return pairs;
}

}  // namespace mdana
