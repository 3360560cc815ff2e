// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of made-up particles: known areas and volumes, voids, and two bodies in contact.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "tests/analyses/crystals.hpp"

namespace mdana {
namespace {

using test::Points;

const double edge = std::sqrt(2.0);  // of the cube of fcc, nearest neighbours 1 apart

/// n cubes of fcc along each edge, all faces full.
Points fcc_cube(int n, const Eigen::Vector3d& at = Eigen::Vector3d::Zero()) {
  Points points;
  for (int i = 0; i <= 2 * n; ++i)
    for (int j = 0; j <= 2 * n; ++j)
      for (int k = 0; k <= 2 * n; ++k)
        if ((i + j + k) % 2 == 0) points.push_back(edge / 2 * Eigen::Vector3d(i, j, k) + at);
  return points;
}

DefectSettings surfaces() {
  DefectSettings settings;
  settings.surface = true;
  return settings;
}

std::shared_ptr<FrameAtoms> two(const Points& first, const Points& second) {
  const auto atoms = test::atoms_of(first);
  const auto more = test::atoms_of(second, 2);
  for (std::size_t i = 0; i < second.size(); ++i) {
    atoms->x.push_back(more->x[i]);
    atoms->y.push_back(more->y[i]);
    atoms->z.push_back(more->z[i]);
    atoms->body.push_back(2);
    atoms->id.push_back(static_cast<std::int64_t>(atoms->id.size() + 1));
  }
  return atoms;
}

// Through the centres of its outer atoms: the cube itself. 1e-8 for the points that are moved by 1e-9.
TEST(Surfaces, OfACubeAreExact) {
  for (const auto& [n, unit] : {std::pair(6, 1.0), {6, 1.5428e-9}, {6, 300.0}, {3, 1.0}, {5, 1.0}}) {
    Points points = fcc_cube(n);
    if (n == 6) test::turn(points, Eigen::Quaterniond(0.3, 0.5, -0.2, 0.7).normalized());
    test::scale(points, unit);
    const auto looked = test::look(points, surfaces());
    const double side = n * edge * unit;
    EXPECT_NEAR(looked["surface_area1"], 6 * side * side, 1e-7 * side * side) << unit;
    EXPECT_NEAR(looked["surface_volume1"], side * side * side, 1e-7 * side * side * side) << unit;
    EXPECT_NEAR(looked["surface_area_error1"], 0, 1e-7 * side * side) << unit;  // full faces: nothing is doubtful
    EXPECT_NEAR(looked["surface_volume_error1"], 0, 1e-7 * side * side * side) << unit;
    EXPECT_NEAR(looked["surface_radius_error1"], 0.1 * unit, 1e-6 * unit) << unit;
    EXPECT_EQ(looked["voids1"], 0);
    EXPECT_EQ(looked["surface_area2"], 0);
    EXPECT_EQ(looked["patch_area"], 0);
  }
}

/// Each edge of a closed surface has a triangle on either side, in opposite senses.
TEST(Surfaces, AreClosed) {
  Points points = test::fcc_ball(8);
  test::add_noise(points, 0.04);
  const auto looked = test::look(points, surfaces());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sense;
  const SurfaceMesh& mesh = looked.found.surfaces.body[0];
  ASSERT_GT(mesh.triangles.size(), 500u);
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = t[k], b = t[(k + 1) % 3];
      sense[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  for (const auto& [e, sum] : sense) EXPECT_EQ(sum, 0);
  EXPECT_EQ(mesh.parts.size(), 1u);
}

// The mesh of a cut ball has steps (area 3 to 16 % high); its radius with half a layer more is that of N a^3/4.
TEST(Surfaces, OfABall) {
  for (const double radius : {8.0, 14.0}) {
    const Points points = test::fcc_ball(radius);
    const auto looked = test::look(points, surfaces());
    const double by_atoms = std::cbrt(3.0 / 16 / std::numbers::pi * static_cast<double>(points.size())) * edge;
    EXPECT_NEAR(looked["surface_radius1"], by_atoms, 0.02 * by_atoms) << radius;
    EXPECT_NEAR(looked["radius_atoms1"], by_atoms, 1e-9 * by_atoms);
    EXPECT_NEAR(looked["radius_gyration1"], radius, 0.01 * radius);  // as rough as a ball of so few atoms is
    EXPECT_EQ(looked["radius_atoms2"], 0);
    const double sphere = 4 * std::numbers::pi * by_atoms * by_atoms;
    EXPECT_GT(looked["surface_area1"], 1.03 * sphere);
    EXPECT_LT(looked["surface_area1"], 1.16 * sphere);
  }
}

// Of hot balls, too. No limit changes the steps of a perfect crystal; those of a hot one it does, by less than half a
// layer on each face.
TEST(Surfaces, OfAHotBall) {
  for (const double noise : {0.0, 0.03, 0.06}) {
    Points ball = test::fcc_ball(10);
    test::add_noise(ball, noise);
    test::scale(ball, 3);
    const auto looked = test::look(ball, surfaces());
    const double by_atoms = 3 * edge * std::cbrt(3.0 / 16 / std::numbers::pi * static_cast<double>(ball.size()));
    EXPECT_NEAR(looked["surface_radius1"], by_atoms, 2 * looked["surface_radius_error1"]) << noise;
    EXPECT_NEAR(looked["surface_radius1"], by_atoms, 0.02 * by_atoms) << noise;
    EXPECT_GT(looked["surface_area1"], 4 * std::numbers::pi * std::pow(by_atoms - 2.5, 2)) << noise;
    EXPECT_EQ(looked["surface_area_error1"] > 1e-6, noise > 0) << noise;
    EXPECT_LT(looked["surface_area_error1"], 0.1 * looked["surface_area1"]) << noise;
    EXPECT_EQ(looked["surface_volume_error1"] > 1e-6, noise > 0) << noise;
    EXPECT_LT(looked["surface_volume_error1"], 0.5 * 3 * looked["surface_area1"]) << noise;
  }
}

// A vacancy leaves a hole whose wall is a cuboctahedron of edge 1: volume 5 sqrt(2)/3, area 6 + 2 sqrt 3.
TEST(Surfaces, VacanciesAreVoids) {
  Points points = test::fcc_ball(7);
  const auto whole = test::look(points, surfaces());
  std::erase_if(points, [](const Eigen::Vector3d& p) { return p.norm() < 0.1; });
  const auto looked = test::look(points, surfaces());
  EXPECT_EQ(looked["voids1"], 1);
  const SurfacePart& wall = looked.found.surfaces.body[0].parts.back();
  EXPECT_NEAR(wall.volume, -5 * edge / 3, 1e-7);
  EXPECT_NEAR(wall.area, 6 + 2 * std::sqrt(3.0), 1e-7);
  EXPECT_NEAR(looked["void_volume1"], 5 * edge / 3, 1e-7);
  EXPECT_NEAR(looked["surface_volume1"], whole["surface_volume1"], 1e-6);
}

// Face to face, as the crystal would go on (one row of atoms has nothing before it), and atom on atom: the
// patch is the face.
TEST(Surfaces, ThePatchOfTwoCubes) {
  const double side = 6 * edge;
  for (const Eigen::Vector3d& at : {Eigen::Vector3d(side + edge / 2, edge / 2, 0), Eigen::Vector3d(side + 1, 0, 0)}) {
    const auto looked = test::look(two(fcc_cube(6), fcc_cube(6, at)), surfaces());
    const double face = side * (side - at.y());
    EXPECT_NEAR(looked["surface_area1"], 6 * side * side, 1e-6 * side * side);
    EXPECT_NEAR(looked["surface_area2"], 6 * side * side, 1e-6 * side * side);
    EXPECT_NEAR(looked["patch_area"], face, looked["patch_area_error"] + 1e-6) << at.transpose();
    EXPECT_NEAR(looked["patch_area"], face, 0.13 * face) << at.transpose();  // half a row at the rim
  }
  const auto apart = test::look(two(fcc_cube(6), fcc_cube(6, {side + 3, 0, 0})), surfaces());
  EXPECT_EQ(apart["patch_area"], 0);
}

// Each body of a pair in contact has the surface that it has alone, also where the lattices match.
TEST(Surfaces, OfBodiesInContactAreTheirOwn) {
  const Points ball = test::fcc_ball(6);
  const auto atoms = test::atoms_of(ball);
  Points lower, upper;
  for (std::size_t i = 0; i < ball.size(); ++i) {
    atoms->body[i] = ball[i].x() < 0.1 ? 1 : 2;
    (atoms->body[i] == 1 ? lower : upper).push_back(ball[i]);
  }
  const auto both = test::look(atoms, surfaces());
  for (const std::string part : {"surface_area", "surface_volume", "voids"}) {
    EXPECT_NEAR(both[part + "1"], test::look(lower, surfaces())[part + "1"], 1e-6);
    EXPECT_NEAR(both[part + "2"], test::look(upper, surfaces())[part + "1"], 1e-6);
  }
}

// More atoms than a slab holds, in one thread and in two, and turned so that slabs cut elsewhere.
TEST(Surfaces, SlabsAndThreadsChangeNothing) {
  Points points = test::fcc_ball(26);
  test::add_noise(points, 0.03);
  const auto one = test::look(test::atoms_of(points), surfaces(), 1), more = test::look(test::atoms_of(points), surfaces(), 3);
  EXPECT_EQ(one.found.surfaces.body[0].triangles, more.found.surfaces.body[0].triangles);
  EXPECT_EQ(one["surface_area1"], more["surface_area1"]);
  for (auto& p : points) p = Eigen::Vector3d(p.y(), p.z(), p.x());
  const auto other = test::look(points, surfaces());
  EXPECT_EQ(one.found.surfaces.body[0].triangles.size(), other.found.surfaces.body[0].triangles.size());
  EXPECT_NEAR(one["surface_area1"], other["surface_area1"], 1e-7 * one["surface_area1"]);
  EXPECT_EQ(one.found.surfaces.body[0].parts.size(), 1u);
}

TEST(Surfaces, OfNextToNothing) {
  for (const std::size_t count : {1u, 3u, 4u}) {
    const Points all{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    DefectSettings settings = surfaces();
    settings.spacing = 1;
    const auto looked = test::look(Points(all.begin(), all.begin() + static_cast<long>(count)), settings);
    EXPECT_NEAR(looked["surface_volume1"], 0, 1e-8) << count;
  }
  const auto square = test::look(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, surfaces());
  EXPECT_EQ(square["surface_area1"], 0);
  EXPECT_EQ(square["surface_radius_error1"], 0);
}

}  // namespace
}  // namespace mdana
