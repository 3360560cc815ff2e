// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/frame_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <fmt/format.h>

#include "analyses/defects/labels.hpp"
#include "readers/input_error.hpp"

namespace mdana::defects {
namespace {

Eigen::Vector3d position(const FrameAtoms& atoms, std::size_t i) { return {atoms.x[i], atoms.y[i], atoms.z[i]}; }

/// Smallest and greatest of some numbers.
struct Extent {
  double lo = HUGE_VAL, hi = -HUGE_VAL;
};

/// Of each body along an axis of the box, in parts of it.
std::array<Extent, 3> extents(const FrameStore& frame, const Eigen::Vector3d& across) {
  std::array<Extent, 3> found;
  frame.for_blocks([&](const FrameAtoms& atoms, std::size_t) {
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      const double s = across.dot(position(atoms, i));
      Extent& extent = found[atoms.body[i]];
      extent = {std::min(extent.lo, s), std::max(extent.hi, s)};
    }
  });
  return found;
}

}  // namespace

FrameShape shape_of(const FrameStore& frame, bool moments) {
  FrameShape shape;
  frame.for_blocks([&](const FrameAtoms& atoms, std::size_t first) {
    shape.box.extend(box_of(atoms, first));
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      shape.of_body[atoms.body[i]].extend(position(atoms, i));
      if (moments) shape.moments[atoms.body[i]].merge({1, 1, position(atoms, i), 0});
    }
  });
  return shape;
}

Eigen::AlignedBox3d FrameShape::overlap(double distance) const {
  if (of_body[1].isEmpty() || of_body[2].isEmpty()) return {};
  const Eigen::Vector3d rim = Eigen::Vector3d::Constant(distance);
  const auto widened = [&](const Eigen::AlignedBox3d& b) { return Eigen::AlignedBox3d(b.min() - rim, b.max() + rim); };
  return widened(of_body[1]).intersection(widened(of_body[2]));
}

std::array<double, 2> FrameShape::ball_radii(BodyIndex body, double spacing) const {
  const Moments<3>& all = moments[body];
  if (all.count == 0) return {};
  return {spacing * std::cbrt(3 * all.weight / (4 * std::numbers::pi * std::numbers::sqrt2)),
          std::sqrt(5.0 / 3 * (all.spread / all.weight))};
}

void refuse_wrapped(const FrameStore& frame, const Box& box, double spacing) {
  if (!box.any_periodic()) return;
  const Eigen::Matrix3d scaling = box.edges.inverse();
  for (const int k : {0, 1, 2}) {
    if (!box.periodic[static_cast<std::size_t>(k)]) continue;
    const Eigen::Vector3d across = scaling.row(k);
    const auto of_body = extents(frame, across);
    for (const std::size_t body : {1u, 2u})
      if (of_body[body].hi - of_body[body].lo > 1 - touching * spacing * across.norm())
        throw InputError(fmt::format(
            "body {} fills the periodic box along {}: it has no surface there, and atoms at the faces "
            "would be taken for one; leave them out by --select, or simulate a particle", body,
            "xyz"[k]));
  }
}

}  // namespace mdana::defects
