// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <utility>

#include <Eigen/Core>

#include "analyses/defects/crystal.hpp"

namespace mdana::defects {

/// A vector between atoms of ideal crystals, in whole parts of the lattice constant: exact also in twins
/// of twins, up to four times.
using Ideal = Eigen::Vector3i;
inline constexpr int ideal_parts = 162;  ///< of the edge of the cube: 2 x 3^4

/// A turn between the axes of two cubes that are twins of twins: a matrix of 81st parts.
struct LatticeTurn {
  static constexpr int parts = 81;
  Eigen::Matrix3i matrix = parts * Eigen::Matrix3i::Identity();

  /// Nothing if the vector has no whole components in the new axes.
  std::optional<Ideal> turned(const Ideal& v) const;
  Eigen::Matrix3d real() const { return matrix.cast<double>() / parts; }
};

/// The turn that makes `second` out of `first` for most of the pairs, and for how many.
struct Agreement {
  LatticeTurn turn;
  std::size_t pairs = 0;
};
using IdealPair = std::pair<Ideal, Ideal>;
Agreement best_turn(std::span<const IdealPair> pairs);

/// The turns between lattices that are the same up to a turn of the cube (order 0), twins (1) and twins of
/// twins (2).
struct OrderedTurn {
  LatticeTurn turn;
  int order;
};
std::span<const OrderedTurn> lattice_turns();

/// The neighbours in each of templates().
using IdealTwelve = std::array<Ideal, 12>;
std::span<const IdealTwelve> ideal_neighbours();

/// The vector between two places of a fcc lattice that is nearest to one in the axes of its cube
/// [neighbour distances].
Ideal nearest_lattice_vector(const Eigen::Vector3d& v);

}  // namespace mdana::defects
