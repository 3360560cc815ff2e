// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "readers/bodies.hpp"

namespace mdana {

/// A spherical grain of one of the bodies.
struct Grain {
  Eigen::Vector3d position;  ///< [length]
  double radius;             ///< [length]
  BodyIndex body;            ///< 1 or 2
  std::int64_t id = 0;       ///< only where grains are followed
};

/// Two grains that touch, or that are so near that they may hold each other.
struct GrainContact {
  std::uint32_t a, b;      ///< indices of the grains, a < b
  double overlap;          ///< r_a + r_b - distance [length]
  Eigen::Vector3d normal;  ///< unit vector from a to b
};

/// What a law says of the contact of two grains of the reduced radius R*, 1/R* = 1/r_a + 1/r_b.
struct GrainLaw {
  std::function<double(double overlap, double reduced_radius)> force;  ///< repulsive > 0 [force]
  std::function<double(double reduced_radius)> least_overlap;  ///< at pull-off [length], not above 0
};

double reduced_radius(const Grain& a, const Grain& b);

/// All pairs that overlap; with a law also those apart up to pull-off (overlap < 0), whose contact
/// holds only if they have touched before. Sorted by (a, b); the time is that of the
/// number of grains, times (largest/smallest radius)^3 at worst. Throws InputError at grains
/// whose position is not finite, whose radius is not positive, or that coincide.
std::vector<GrainContact> find_contacts(std::span<const Grain> grains, const GrainLaw& law = {});

/// Pairs of ids, the smaller one first, sorted.
using IdPairs = std::vector<std::pair<std::int64_t, std::int64_t>>;

/// Of those contacts that overlap.
IdPairs touching_pairs(std::span<const Grain> grains, std::span<const GrainContact> contacts);

}  // namespace mdana
