// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "readers/bodies.hpp"

namespace mdana {

/// An atom near the contact plane.
struct ZoneAtom {
  Eigen::Vector2d position;  ///< in the plane [length]
  double height;             ///< above it, towards body 2 [length]
  BodyIndex body;            ///< 1 or 2

  template <class P>
  void pass(P& parcel) {
    parcel(position, height, body);
  }
};

/// Distance of each atom to the nearest one of the other body [length]; infinity if that is more
/// than `reach`. Below `enough` any distance that is less will do.
std::vector<double> distance_to_other_body(const std::vector<ZoneAtom>& atoms, double reach,
                                           double enough);

}  // namespace mdana
