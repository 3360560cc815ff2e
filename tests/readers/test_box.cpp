// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "readers/box.hpp"

namespace mdana {
namespace {

using Eigen::Vector3d;

/// Bounds of a parallelepiped: least and greatest coordinate of its eight corners.
std::pair<Vector3d, Vector3d> bounds_of(const Box& box) {
  Vector3d lo = box.origin, hi = box.origin;
  for (int i = 0; i < 8; ++i) {
    const Vector3d corner = box.position({i & 1 ? 1. : 0., i & 2 ? 1. : 0., i & 4 ? 1. : 0.});
    lo = lo.cwiseMin(corner);
    hi = hi.cwiseMax(corner);
  }
  return {lo, hi};
}

Box tilted(double xy, double xz, double yz, double scale) {
  Box box;
  box.origin = scale * Vector3d(-3, 5, 0.5);
  box.edges << 16, xy, xz, 0, 8, yz, 0, 0, 4;
  box.edges *= scale;
  return box;
}

// All signs of the tilts; powers of two, so that the round trip is exact at any length scale.
TEST(Box, TiltedBoxIsRecoveredFromItsBounds) {
  for (const double scale : {0x1p-30, 1.0, 0x1p+30})
    for (const double xy : {-4.0, 0.0, 2.0})
      for (const double xz : {-8.0, 0.0, 0.5})
        for (const double yz : {-1.0, 0.0, 4.0}) {
          const Box box = tilted(xy, xz, yz, scale);
          const auto [lo, hi] = bounds_of(box);
          const Box found = box_from_bounds(lo, hi, scale * xy, scale * xz, scale * yz);
          EXPECT_EQ(found.origin, box.origin) << xy << " " << xz << " " << yz;
          EXPECT_EQ(found.edges, box.edges) << xy << " " << xz << " " << yz;
        }
}

TEST(Box, OrthogonalBoxIsItsBounds) {
  const Box box = box_from_bounds({-1, -2, -3}, {1, 5, 9}, 0, 0, 0);
  EXPECT_EQ(box.position({0, 0, 0}), Vector3d(-1, -2, -3));
  EXPECT_EQ(box.position({1, 1, 1}), Vector3d(1, 5, 9));
}

TEST(Box, ScaledPositionsFollowTheEdges) {
  const Box box = tilted(-4, 0.5, 2, 1);
  EXPECT_EQ(box.position({0.5, 0.25, 2}), Vector3d(-3 + 8 - 1 + 1, 5 + 2 + 4, 0.5 + 8));
}

TEST(Box, PeriodicInAnyDirection) {
  Box box;
  EXPECT_FALSE(box.any_periodic());
  box.periodic[2] = true;
  EXPECT_TRUE(box.any_periodic());
}

}  // namespace
}  // namespace mdana
