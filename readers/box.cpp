// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/box.hpp"

#include <algorithm>

namespace mdana {

Box box_from_bounds(Eigen::Vector3d lo, Eigen::Vector3d hi, double xy, double xz, double yz) {
  Box box;
  box.stated = {lo, hi};
  lo.x() -= std::min({0.0, xy, xz, xy + xz});
  hi.x() -= std::max({0.0, xy, xz, xy + xz});
  lo.y() -= std::min(0.0, yz);
  hi.y() -= std::max(0.0, yz);
  const Eigen::Vector3d size = hi - lo;
  box.origin = lo;
  box.edges << size.x(), xy, xz,  //
      0.0, size.y(), yz,          //
      0.0, 0.0, size.z();
  return box;
}

}  // namespace mdana
