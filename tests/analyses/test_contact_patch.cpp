// SPDX-License-Identifier: GPL-3.0-or-later
// The area of discs cut out of planes of crystals: the true one is known.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "analyses/contact_patch.hpp"
#include "analyses/motion.hpp"

namespace mdana {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// A periodic pattern in the plane: two edges of the cell, and what stands in it.
struct Plane {
  const char* name;
  Eigen::Vector2d a, b;
  Points sites;
};

const double h = std::sqrt(3.0) / 2;

/// Planes with nearest neighbours at 1; two stacked planes of fcc look denser from above.
const std::array<Plane, 5> planes{{
    {"square", {1, 0}, {0, 1}, {{0, 0}}},
    {"triangular", {1, 0}, {0.5, h}, {{0, 0}}},
    {"two fcc(100)", {1, 0}, {0, 1}, {{0, 0}, {0.5, 0.5}}},
    {"two fcc(111)", {1, 0}, {0.5, h}, {{0, 0}, {0.5, h / 3}}},
    {"three fcc(100)", {1, 0}, {0, 1}, {{0, 0}, {0.5, 0.5}, {0, 0}}},
}};

/// The atoms of a plane in a disc about the origin: any place, any direction, thermal parts.
Points disc(const Plane& plane, double radius, std::mt19937_64& random, double noise) {
  std::uniform_real_distribution<double> part(0, 1);
  std::normal_distribution<double> thermal(0, 1);
  const double angle = 2 * std::numbers::pi * part(random);
  const Eigen::Vector2d shift = part(random) * plane.a + part(random) * plane.b;
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  Points points;
  const int n = static_cast<int>(1.2 * radius) + 3;
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j)
      for (const Eigen::Vector2d& site : plane.sites) {
        const Eigen::Vector2d p = i * plane.a + j * plane.b + site + shift;
        if (p.norm() < radius)
          points.push_back(turn * p + noise * Eigen::Vector2d(thermal(random), thermal(random)));
      }
  return points;
}

/// How the radii of many discs fare: mean of a/R - 1, and the share within the error.
struct Score {
  double bias = 0, within = 0;
};

template <class Make>
Score score(Make&& make, double least, double greatest) {
  Score result;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> radius(least, greatest);
  const int discs = greatest > 12 ? 40 : 200;
  for (int i = 0; i < discs; ++i) {
    const double r = radius(random);
    const PatchArea patch = patch_area(make(r, random), 1);
    result.bias += (patch.radius() / r - 1) / discs;
    result.within += (std::abs(patch.radius() - r) <= patch.radius_error() ? 1.0 : 0.0) / discs;
  }
  return result;
}

struct Range {
  double least, greatest;
};
constexpr std::array<Range, 3> ranges{{{3, 6}, {6, 12}, {12, 30}}};

template <class Make>
void expect_good_score(const char* name, Make&& make) {
  for (const Range range : ranges) {
    const Score s = score(make, range.least, range.greatest);
    EXPECT_LT(std::abs(s.bias), 0.01) << name << " " << range.least;
    EXPECT_GE(s.within, 0.95) << name << " " << range.least;
    ::testing::Test::RecordProperty(std::string(name) + std::to_string(static_cast<int>(range.least)),
                   std::to_string(s.bias) + " " + std::to_string(s.within));
  }
}

TEST(PatchArea, DiscsOfOnePlane) {
  for (const Plane& plane : planes)
    for (const double noise : {0.0, 0.03})
      expect_good_score(plane.name, [&](double r, std::mt19937_64& random) {
        return disc(plane, r, random, noise);
      });
}

// Planes of two bodies, turned and shifted against each other.
TEST(PatchArea, DiscsOfTwoBodies) {
  for (const std::size_t other : {0, 1})
    expect_good_score(other ? "111 on 111" : "111 on 100", [&](double r, std::mt19937_64& random) {
      Points points = disc(planes[1], r, random, 0.03);
      const Points second = disc(planes[other], r, random, 0.03);
      points.insert(points.end(), second.begin(), second.end());
      return points;
    });
}

// The hull of the atoms' centres lacks half a cell an atom at the edge: the correction is needed.
TEST(PatchArea, ErrorsAreNotIdle) {
  std::mt19937_64 random(3);
  const PatchArea patch = patch_area(disc(planes[1], 10, random, 0), 1);
  EXPECT_GT(patch.radius_error(), 0.001 * patch.radius());
  EXPECT_LT(patch.radius_error(), 0.05 * patch.radius());
}

TEST(PatchArea, StrayAtomsChangeNothing) {
  std::mt19937_64 random(3);
  Points points = disc(planes[0], 5, random, 0);
  const double area = patch_area(points, 1).area;
  for (const double x : {9.0, 20.0, 1e6, 1e18, 1e100}) points.emplace_back(x, 0.5);
  EXPECT_NEAR(patch_area(points, 1).area, area, 1e-12 * area);
}

// As everything else, cells of the search are counted in numbers that may be as large as they like.
TEST(ContactPatch, NeighboursFarFromTheMiddle) {
  for (const double far : {0.0, 1e6, 1e18, 1e100}) {
    AtomBlock block;
    block.reset(0, 8);
    const auto x = block.make_real("x"), y = block.make_real("y"), z = block.make_real("z");
    std::vector<BodyIndex> body;
    for (std::size_t i = 0; i < 8; ++i) {
      x[i] = (i % 2 ? 1 : 0) + far;
      y[i] = i % 4 / 2 ? 1 : 0;
      z[i] = i < 4 ? -0.5 : 0.5;
      body.push_back(i < 4 ? 1 : 2);
    }
    std::array<BodyMotion, 2> motion;
    motion[0].position = {0, 0, -4};
    motion[1].position = {0, 0, 4};
    const FrameHeader header;
    const auto partial = make_contact_patch({{5, 5}, 0.5, 1, 1.2})->begin({header, motion});
    partial->add({block, body, std::vector<double>(8, 1.0)});
    std::array<double, 6> row{};
    partial->close(row);
    EXPECT_EQ(row[4], 4) << far;
    EXPECT_EQ(row[5], 4) << far;
    if (far < 1e7) {
      EXPECT_NEAR(row[0], std::sqrt(4 / std::numbers::pi), 1e-9) << far;
    }
  }
}

// Too few for a triangle: no area, and the atoms' own as its error.
TEST(PatchArea, NoTriangle) {
  EXPECT_EQ(patch_area({}, 1).area, 0);
  EXPECT_EQ(patch_area({}, 1).error, 0);
  EXPECT_EQ(patch_area({}, 1).radius_error(), 0);
  for (const Points& points :
       {Points{{1, 2}}, Points{{1, 2}, {2, 2}}, Points{{0, 0}, {1, 1}, {2, 2}, {4, 4}},
        Points{{0, 0}, {9, 0}, {0, 9}}}) {
    const PatchArea patch = patch_area(points, 1);
    EXPECT_EQ(patch.area, 0);
    EXPECT_NEAR(patch.error, h * static_cast<double>(points.size()), 1e-14);
    EXPECT_GT(patch.radius_error(), 0);
  }
}

TEST(PatchArea, CoincidentAtomsCountOnce) {
  const Points one(1000, Eigen::Vector2d(3, 4));
  EXPECT_EQ(patch_area(one, 1).area, 0);
  EXPECT_NEAR(patch_area(one, 1).error, h, 1e-15);
  std::mt19937_64 random(3);
  Points points = disc(planes[1], 6, random, 0);
  const double area = patch_area(points, 1).area;
  const Points again = points;
  points.insert(points.end(), again.begin(), again.end());
  EXPECT_NEAR(patch_area(points, 1).area, area, 1e-12 * area);
}

TEST(PatchArea, PowersOfTwoScaleExactlyAndTensNearly) {
  std::mt19937_64 random(3);
  const Points points = disc(planes[1], 12, random, 0.05);
  const PatchArea plain = patch_area(points, 1.0);
  for (const double factor : {0x1p-100, 0x1p-33, 0x1p+40, 0x1p+200, 1e-10, 1e10}) {
    Points scaled = points;
    for (Eigen::Vector2d& p : scaled) p *= factor;
    const PatchArea patch = patch_area(scaled, factor);
    const bool exact = std::frexp(factor, std::array<int, 1>{}.data()) == 0.5;
    const double unit = factor * factor;
    EXPECT_NEAR(patch.area / unit, plain.area, exact ? 0 : 1e-12 * plain.area) << factor;
    EXPECT_NEAR(patch.error / unit, plain.error, exact ? 0 : 1e-12 * plain.error) << factor;
    EXPECT_EQ(patch.atoms, plain.atoms);
  }
}

TEST(PatchArea, OrderTurnAndShiftChangeNothing) {
  std::mt19937_64 random(3);
  Points points = disc(planes[1], 12, random, 0.05);
  const double area = patch_area(points, 1).area;
  std::shuffle(points.begin(), points.end(), random);
  EXPECT_NEAR(patch_area(points, 1).area, area, 1e-13 * area);
  for (Eigen::Vector2d& p : points) p = Eigen::Rotation2Dd(0.7) * p + Eigen::Vector2d(30, -50);
  EXPECT_NEAR(patch_area(points, 1).area, area, 1e-12 * area);
}

}  // namespace
}  // namespace mdana
