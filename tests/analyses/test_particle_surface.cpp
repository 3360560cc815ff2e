// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of made-up particles: known volumes, voids, and two bodies in contact.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/analyses/crystals.hpp"

namespace mdana {
namespace {

using test::look;
using test::Points;

DefectSettings with_surface() {
  DefectSettings settings;
  settings.surface = true;
  return settings;
}

/// A cube of fcc, `n` lattice edges a side, neighbours 1 apart.
Points cube(int n) {
  Points points;
  for (int i = 0; i <= 2 * n; ++i)
    for (int j = 0; j <= 2 * n; ++j)
      for (int k = 0; k <= 2 * n; ++k)
        if ((i + j + k) % 2 == 0) points.push_back(std::sqrt(0.5) * Eigen::Vector3d(i, j, k));
  return points;
}

// Its surface runs through the outermost atoms: a cube of n edges of length sqrt 2.
TEST(ParticleSurface, OfACube) {
  for (const int n : {3, 5}) {
    const double side = n * std::sqrt(2.0);
    const auto seen = look(cube(n), with_surface());
    EXPECT_NEAR(seen["surface_area1"], 6 * side * side, 1e-6);
    EXPECT_NEAR(seen["surface_volume1"], side * side * side, 1e-6);
    EXPECT_EQ(seen["voids1"], 0);
    EXPECT_EQ(seen["surface_area2"], 0);
  }
}

// The volume of N atoms of sqrt(1/2) each, less half a layer.
TEST(ParticleSurface, RadiusOfABall) {
  for (const double noise : {0.0, 0.03}) {
    Points ball = test::fcc_ball(10);
    test::add_noise(ball, noise);
    test::scale(ball, 3);
    const auto seen = look(ball, with_surface());
    const double of_atoms = 3 * std::cbrt(3 * static_cast<double>(ball.size()) * std::sqrt(0.5) /
                                          (4 * std::numbers::pi));
    EXPECT_NEAR(seen["surface_radius1"], of_atoms, 0.02 * of_atoms);
    EXPECT_GT(seen["surface_area1"], 4 * std::numbers::pi * std::pow(of_atoms - 2.5, 2));
  }
}

// A vacancy leaves a cuboctahedron of edge 1: volume 5/3 sqrt 2.
TEST(ParticleSurface, AVacancyIsAVoid) {
  Points ball = test::fcc_ball(8);
  const double solid = look(ball, with_surface())["surface_volume1"];
  std::erase_if(ball, [](const auto& p) { return p.norm() < 0.1; });
  const auto seen = look(ball, with_surface());
  EXPECT_EQ(seen["voids1"], 1);
  EXPECT_NEAR(seen["void_volume1"], 5.0 / 3 * std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(seen["surface_volume1"], solid, 1e-9 * solid);
}

// Each body of a pair in contact has the surface that it has alone, also where the lattices match.
TEST(ParticleSurface, BodiesInContactHaveTheirOwn) {
  const Points ball = test::fcc_ball(6);
  const auto atoms = std::make_shared<FrameAtoms>(*test::atoms_of(ball));
  Points lower, upper;
  for (std::size_t i = 0; i < ball.size(); ++i) {
    atoms->body[i] = ball[i].x() < 0.1 ? 1 : 2;
    (atoms->body[i] == 1 ? lower : upper).push_back(ball[i]);
  }
  const auto both = look(atoms, with_surface());
  for (const char* part : {"surface_area", "surface_volume", "voids"}) {
    EXPECT_NEAR(both[std::string(part) + "1"], look(lower, with_surface())[std::string(part) + "1"], 1e-6);
    EXPECT_NEAR(both[std::string(part) + "2"], look(upper, with_surface())[std::string(part) + "1"], 1e-6);
  }
}

TEST(ParticleSurface, FewAtomsHaveNone) {
  const auto seen = look(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, with_surface());
  EXPECT_EQ(seen["surface_area1"], 0);
}

}  // namespace
}  // namespace mdana
