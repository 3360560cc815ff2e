// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analyses/defects/lattice.hpp"
#include "analyses/defects/lines/ideal.hpp"
#include "analyses/defects/lines/own_frames.hpp"
#include "analyses/defects/zone.hpp"

namespace mdana::defects {

inline constexpr std::uint32_t no_atom = ~0u;

/// What a crystalline atom says of a neighbour.
struct IdealBond {
  std::uint32_t atom = no_atom;  ///< of the zone; none if it is outside
  std::array<std::int8_t, 3> vector{};

  Ideal ideal() const { return {vector[0], vector[1], vector[2]}; }
};

/// Atoms whose lattices are known against each other: bonds lead from one to the next.
struct Grain {
  BodyIndex body = 0;
  bool aligned = false;  ///< its vectors are in the axes of the body's lattice, else in axes of its own
};

/// The ideal crystal about the atoms of a zone.
struct ZoneCrystal {
  static constexpr std::uint32_t no_grain = ~0u;
  std::vector<std::uint32_t> grain;              ///< of each atom; of those without structure the neighbours'
  std::vector<char> framed;                      ///< it has ideal bonds of its own
  std::vector<std::array<IdealBond, 12>> bonds;  ///< of framed atoms, in the axes of the grain
  std::vector<Eigen::Matrix3f> map;              ///< from ideal vectors to [spacings]; of those without structure a neighbour's
  std::vector<Eigen::Matrix3f> turn;             ///< of the cube about the atom against the axes of the grain
  std::vector<Grain> grains;
};

/// `own` of the zone's atoms; `lattices` of bodies 1 and 2. Atoms without structure are in no grain yet.
ZoneCrystal find_frames(const Zone& zone, std::span<const OwnFrame> own, std::span<const BodyLattice, 2> lattices);

}  // namespace mdana::defects
