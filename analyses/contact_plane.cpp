// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_plane.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {

ContactPlane::ContactPlane(const BodyMotion& body1, const BodyMotion& body2,
                           const std::array<double, 2>& radius, const std::string& place) {
  const Eigen::Vector3d line = body2.position - body1.position;
  const double x = line.norm();
  if (!(x > 0)) throw InputError(fmt::format("{}: the bodies' centres coincide", place));
  normal = line / x;
  const double from_body1 = 0.5 * (x + (radius[0] - radius[1]) * ((radius[0] + radius[1]) / x));
  point = body1.position + from_body1 * normal;
  u = normal.unitOrthogonal();
  v = normal.cross(u);
}

}  // namespace mdana
