// SPDX-License-Identifier: GPL-3.0-or-later
// The area of shapes other than those that the error of the patch was set by: ellipses and polygons out
// of planes, and what a thin layer about the contact plane holds of two crystals of any orientation.
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "analyses/contact_patch.hpp"
#include "analyses/contact_patch/neighbour_offset.hpp"

namespace mdana {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Random = std::mt19937_64;

constexpr double pi = std::numbers::pi;

/// A figure in the plane: whether a point lies in it, its area, and the radius that holds it.
struct Figure {
  std::function<bool(const Vector2d&)> holds;
  double area, reach;
};

Figure ellipse(double a, double b) {
  return {[=](const Vector2d& p) {
            return (p.x() / a) * (p.x() / a) + (p.y() / b) * (p.y() / b) < 1;
          },
          pi * a * b, std::max(a, b)};
}

/// Regular, with n corners at radius r.
Figure polygon(int n, double r) {
  const double inner = r * std::cos(pi / n);
  return {[=](const Vector2d& p) {
            for (int k = 0; k < n; ++k) {
              const double angle = 2 * pi * (k + 0.5) / n;
              if (p.x() * std::cos(angle) + p.y() * std::sin(angle) > inner) return false;
            }
            return true;
          },
          0.5 * n * r * r * std::sin(2 * pi / n), r};
}

Figure figure(int kind, double size) {
  switch (kind) {
    case 0: return ellipse(1.5 * size, size / 1.5);
    case 1: return ellipse(2 * size, size / 2);
    case 2: return polygon(3, 1.4 * size);
    case 3: return polygon(4, 1.2 * size);
    default: return polygon(6, 1.1 * size);
  }
}

Eigen::Matrix3d orientation(Random& random) {
  std::normal_distribution<double> normal(0, 1);
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

/// Atoms of an fcc crystal (nearest neighbours at 1) of any orientation between two heights, seen from
/// above, as far as the figure holds them.
void add_slice(const Figure& figure, double low, double high, double noise, Random& random,
               std::vector<Vector2d>& points) {
  std::uniform_real_distribution<double> part(0, 1);
  std::normal_distribution<double> thermal(0, noise);
  const double a = std::numbers::sqrt2;  // edge of the cubic cell
  const Eigen::Matrix3d turn = orientation(random);
  const Vector3d shift = a * Vector3d(part(random), part(random), part(random));
  const int n = static_cast<int>((figure.reach + 2) / a) + 2;
  const Vector3d basis[] = {{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}};
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j)
      for (int k = -n; k <= n; ++k)
        for (const Vector3d& site : basis) {
          const Vector3d p = turn * (a * (Vector3d(i, j, k) + site) + shift);
          if (p.z() > low && p.z() < high && figure.holds(p.head<2>()))
            points.emplace_back(p.x() + thermal(random), p.y() + thermal(random));
        }
}

/// Atoms of the planes (111) or (100), turned and shifted anyhow.
void add_plane(const Figure& figure, bool triangular, double noise, Random& random,
               std::vector<Vector2d>& points) {
  std::uniform_real_distribution<double> part(0, 1);
  std::normal_distribution<double> thermal(0, noise);
  const Vector2d a(1, 0), b = triangular ? Vector2d(0.5, std::sqrt(3) / 2) : Vector2d(0, 1);
  const Vector2d shift(part(random), part(random));
  const Eigen::Rotation2Dd turn(2 * pi * part(random));
  const int n = static_cast<int>(1.3 * figure.reach) + 3;
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j) {
      const Vector2d p = turn * Vector2d(i * a + j * b + shift);
      if (figure.holds(p)) points.emplace_back(p.x() + thermal(random), p.y() + thermal(random));
    }
}

struct Score {
  double bias = 0, within = 0;
};

template <class Fill>
Score score(Fill&& fill, int trials, unsigned seed) {
  Score result;
  Random random(seed);
  std::uniform_real_distribution<double> size(3, 12);
  for (int i = 0; i < trials; ++i) {
    const Figure shape = figure(i % 5, size(random));
    std::vector<Vector2d> points;
    fill(shape, random, points);
    const PatchArea patch = patch_area(points, 1);
    const double r = std::sqrt(shape.area / pi);
    result.bias += (patch.radius() / r - 1) / trials;
    result.within += (std::abs(patch.radius() - r) <= patch.radius_error() ? 1.0 : 0.0) / trials;
  }
  return result;
}

// 500 shapes a row; that 475 or more of them lie within the error is asked of every kind of points.
void expect_covered(const char* name, const Score& s, double bias) {
  std::printf("%s: bias %.4f, within the error %.3f\n", name, s.bias, s.within);
  EXPECT_LT(std::abs(s.bias), bias) << name;
  EXPECT_GE(s.within, 0.95) << name;
}

TEST(PatchShapes, PlanesOfOneBody) {
  for (const bool triangular : {false, true})
    expect_covered(triangular ? "(111)" : "(100)",
                   score([&](const Figure& f, Random& random, std::vector<Vector2d>& points) {
                     add_plane(f, triangular, 0.03, random, points);
                   }, 500, 11), 0.01);
}

TEST(PatchShapes, PlanesOfTwoBodies) {
  expect_covered("(111) on (100)",
                 score([&](const Figure& f, Random& random, std::vector<Vector2d>& points) {
                   add_plane(f, true, 0.03, random, points);
                   add_plane(f, false, 0.03, random, points);
                 }, 500, 12), 0.01);
}

// Half a sigma (0.46 d) of each body about the contact plane, as the layer of P1.
TEST(PatchShapes, LayersOfCrystalsOfAnyOrientation) {
  expect_covered("fcc, any orientation",
                 score([&](const Figure& f, Random& random, std::vector<Vector2d>& points) {
                   add_slice(f, -0.46, 0, 0.03, random, points);
                   add_slice(f, 0, 0.46, 0.03, random, points);
                 }, 500, 13), 0.02);
}

// A Hertz contact of a = 3 between spheres with R* = 10 has the gap of its formula at r = 5.
TEST(NeighbourOffset, BringsBackTheRadiusOfHertz) {
  const double a = 3, r = 5, reduced = 10;
  const double gap =
      (a * std::sqrt(r * r - a * a) + (r * r - 2 * a * a) * std::acos(a / r)) / (pi * reduced);
  EXPECT_NEAR(r - neighbour_offset(r, reduced, gap), a, 1e-12);
  EXPECT_EQ(neighbour_offset(r, reduced, r * r / (2 * reduced)), r);  // rigid spheres in touch
  EXPECT_EQ(neighbour_offset(0, reduced, 1), 0);
  EXPECT_LT(neighbour_offset(100, reduced, 0.8), 0.05 * 100);  // small beside a large contact
}

}  // namespace
}  // namespace mdana
