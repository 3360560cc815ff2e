// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "readers/bodies.hpp"
#include "readers/local_dump.hpp"

namespace mdana {

/// A spherical grain of one of the bodies.
struct Grain {
  Eigen::Vector3d position;  ///< [length]
  double radius;             ///< [length]
  BodyIndex body;            ///< 1 or 2
  std::int64_t id = 0;       ///< only where grains are followed

  template <class P>
  void pass(P& parcel) {
    parcel(position, radius, body, id);
  }
};

/// Two grains that touch, or that are so near that they may hold each other.
struct GrainContact {
  std::uint32_t a, b;                                       ///< indices of the grains, a < b
  double overlap;                                           ///< r_a + r_b - distance [length]
  Eigen::Vector3d normal;                                   ///< unit vector from a to b
  bool touching;                                            ///< overlaps, or is known to hold
  double force = std::numeric_limits<double>::quiet_NaN();  ///< if a list tells it [force]
};

/// What a law says of the contact of two grains of the reduced radius R*, 1/R* = 1/r_a + 1/r_b.
struct GrainLaw {
  std::function<double(double overlap, double reduced_radius)> force;  ///< repulsive > 0 [force]
  std::function<double(double reduced_radius)>
      least_overlap;  ///< at pull-off [length], not above 0
};

double reduced_radius(const Grain& a, const Grain& b);

/// All pairs that overlap; with a law also those apart up to pull-off (overlap < 0), whose contact
/// holds only if they have touched before. Sorted by (a, b); the time is that of the
/// number of grains, times (largest/smallest radius)^3 at worst. Throws InputError at grains
/// whose position is not finite, whose radius is not positive, or that coincide, and at more
/// contacts than grains can have.
std::vector<GrainContact> find_contacts(std::span<const Grain> grains, const GrainLaw& law = {});

/// What a list of contacts tells of these.
struct ListedShare {
  std::size_t listed = 0;     ///< contacts that have their force from it
  std::size_t unmatched = 0;  ///< pairs with a force that are too far apart for any contact
};

/// Pairs that the list gives a force are touching, with that force; what others are does not
/// change.
ListedShare decide_by_list(std::span<const Grain> grains, std::span<GrainContact> contacts,
                           std::span<const ListedContact> list);

/// Pairs of ids, the smaller one first, sorted.
using IdPairs = std::vector<std::pair<std::int64_t, std::int64_t>>;

/// Of those that touch.
IdPairs touching_pairs(std::span<const Grain> grains, std::span<const GrainContact> contacts);

}  // namespace mdana
