// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

namespace mdana {

/// The simulation box: a parallelepiped of any shape and any length scale.
struct Box {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();      ///< corner [length]
  Eigen::Matrix3d edges = Eigen::Matrix3d::Identity();  ///< edge vectors as columns [length]
  std::array<bool, 3> periodic{false, false, false};

  /// The bounds that the edges were rounded from, if a dump stated them: for writing them again.
  struct Bounds {
    Eigen::Vector3d lo, hi;

    template <class P>
    void pass(P& parcel) {
      parcel(lo, hi);
    }
  };
  std::optional<Bounds> stated;

  bool any_periodic() const { return periodic[0] || periodic[1] || periodic[2]; }

  /// Position [length] of scaled coordinates (0..1 inside the box).
  Eigen::Vector3d position(const Eigen::Vector3d& scaled) const { return origin + edges * scaled; }

  /// The members, for other ranks; see analyses/parcel.hpp.
  template <class P>
  void pass(P& parcel) {
    parcel(origin, edges, periodic, stated);
  }
};

/// Box from LAMMPS' bounds and tilt factors: `lo`, `hi` are those of the dump's ITEM: BOX BOUNDS,
/// which for a tilted box bound the whole parallelepiped (LAMMPS manual, Howto triclinic).
Box box_from_bounds(Eigen::Vector3d lo, Eigen::Vector3d hi, double xy, double xz, double yz);

}  // namespace mdana
