// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace mdana {

/// A mean with what rounding takes of it: of a drift of 1e7 thermal speeds a double keeps the thermal
/// part to 1e-9, and differences of such means go into second moments.
struct MeanVector {
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  Eigen::Vector3d low = Eigen::Vector3d::Zero();  ///< to be added to `high`

  Eigen::Vector3d minus(const MeanVector& other) const {
    return (high - other.high) + (low - other.low);
  }

  void move(const Eigen::Vector3d& by) {  // Knuth's two-sum
    const Eigen::Vector3d step = low + by, moved = high + step, added = moved - high;
    low = (high - (moved - added)) + (step - added);
    high = moved;
  }

  template <class P>
  void pass(P& parcel) {
    parcel(high, low);
  }
};

}  // namespace mdana
