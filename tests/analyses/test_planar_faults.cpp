// SPDX-License-Identifier: GPL-3.0-or-later
// Faults and twins of known area in balls of close-packed layers.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/analyses/crystals.hpp"

namespace mdana {
namespace {

using test::look;
using test::Points;

constexpr double radius = 10;

/// Atoms of the layers at heights about zero, times the area of each.
double area_at(const Points& points, double lowest, double highest, double layers) {
  double count = 0;
  for (const auto& p : points) count += p.z() > lowest && p.z() < highest;
  return std::sqrt(3.0) / 2 * count / layers;
}

struct Case {
  const char* name;
  std::string stacking;
  PlanarFault kind;
  double lowest, highest, layers;  ///< of its hcp layers
};

// Rows of ABC... with the fault in the middle, long enough for the ball.
std::vector<Case> cases() {
  const double h = std::sqrt(2.0 / 3);
  return {{"intrinsic", "ABCABCABCABCABCBCABCABCABCABCA", PlanarFault::intrinsic, -0.6 * h, 0.6 * h, 2},
          {"extrinsic", "ABCABCABCABCABCBABCABCABCABCABC", PlanarFault::extrinsic, -1.1 * h, 1.1 * h, 3},
          {"twin", "ABCABCABCABCABCBACBACBACBACBA", PlanarFault::twin, -0.1 * h, 0.1 * h, 1}};
}

// Half a lattice spacing at the rim of the disc is what its edge can mean.
TEST(PlanarFaults, KnownAreas) {
  for (const Case& c : cases())
    for (const double noise : {0.0, 0.03, 0.045})
      for (const bool turned : {false, true}) {
        SCOPED_TRACE(std::string(c.name) + " noise " + std::to_string(noise));
        Points ball = test::stacked_ball(c.stacking, radius);
        test::add_noise(ball, noise);
        Eigen::Quaterniond q(0.3, -0.8, 0.5, 0.1);
        q.normalize();
        if (turned) test::turn(ball, q);
        test::scale(ball, 2.5);
        const auto seen = look(ball);
        const auto& planes = seen.found.planes;
        ASSERT_GE(planes.size(), 1u);
        const double disc = std::numbers::pi * radius * radius * 2.5 * 2.5;
        EXPECT_EQ(planes[0].kind, c.kind);
        EXPECT_EQ(planes[0].body, 1);
        EXPECT_NEAR(planes[0].area, disc, 0.07 * disc);
        EXPECT_GT(planes[0].error, 0);
        const Eigen::Vector3d normal = turned ? Eigen::Vector3d(q * Eigen::Vector3d::UnitZ())
                                              : Eigen::Vector3d::UnitZ();
        EXPECT_GT(std::abs(planes[0].normal.dot(normal)), 0.999);
        const bool twin = c.kind == PlanarFault::twin;
        EXPECT_NEAR(seen[twin ? "twin_area1" : "fault_area1"], disc, 0.08 * disc);
        EXPECT_LE(seen[twin ? "fault_area" : "twin_area"], 0.03 * disc);
        EXPECT_EQ(seen["fault_area2"], 0);
      }
}

TEST(PlanarFaults, CountsOfHcpAtomsAreThoseOfTheLayers) {
  for (const Case& c : cases()) {
    const Points ball = test::stacked_ball(c.stacking, radius);
    const auto seen = look(ball);
    EXPECT_NEAR(seen.found.planes.at(0).area, area_at(ball, c.lowest, c.highest, c.layers),
                0.05 * seen.found.planes[0].area) << c.name;
  }
}

TEST(PlanarFaults, NoneInAPerfectCrystal) {
  EXPECT_TRUE(look(test::fcc_ball(8)).found.planes.empty());
}

}  // namespace
}  // namespace mdana
