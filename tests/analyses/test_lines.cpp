// SPDX-License-Identifier: GPL-3.0-or-later
// Dislocation lines of known Burgers vector and length in displaced lattices; those that LAMMPS relaxed are in
// tests/dislocations.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analyses/line_tracks.hpp"
#include "tests/analyses/crystals.hpp"

namespace mdana {
namespace {

using test::Points;
using Vector = Eigen::Vector3d;

const double a = std::sqrt(2.0);                                    // edge of the cube
const Vector normal = Vector(1, 1, 1).normalized();                 // of the glide plane
const Vector shockley = Vector(1, 1, -2) / 6;                       // [lattice constants]
const Vector along = Vector(1, -1, 0).normalized(), across = normal.cross(along);
const double layer = std::sqrt(2.0 / 3);

DefectSettings lines_only() {
  DefectSettings settings;
  settings.lines = true;
  return settings;
}

DislocationLines lines_of(const Points& points, DefectSettings settings = lines_only()) {
  return test::look(points, std::move(settings)).found.lines;
}

/// A ball sheared on one side of the line through its middle, by an arc tangent of width 1 (Peierls).
Points ball_with_partial(double radius) {
  Points points = test::fcc_ball(radius);
  for (auto& p : points) {
    const double slip = 0.5 + std::atan(p.dot(across)) / std::numbers::pi;
    p += (p.dot(normal) > 0.5 * layer ? 0.5 : -0.5) * slip * a * shockley;
  }
  return points;
}

/// The solid angle of a triangle seen from the origin (van Oosterom & Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125).
double solid_angle(const Vector& u, const Vector& v, const Vector& w) {
  const double x = u.norm(), y = v.norm(), z = w.norm();
  return 2 * std::atan2(u.dot(v.cross(w)), x * y * z + u.dot(v) * z + u.dot(w) * y + v.dot(w) * x);
}

/// A ball with a closed line: the displacement is b times the solid angle of a disc, over 4 pi; it jumps by b on the
/// disc, what is above it moves by +b/2.
Points ball_with_loop(double ball, double radius, const Vector& place = Vector::Zero()) {
  constexpr int sides = 90;
  const Vector centre = 0.5 * layer * normal + place;
  std::vector<Vector> ring;
  for (int k = 0; k <= sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    ring.push_back(centre + radius * (std::cos(angle) * along + std::sin(angle) * across));
  }
  Points points = test::fcc_ball(ball);
  for (auto& p : points) {
    double angle = 0;
    for (std::size_t k = 0; k < sides; ++k) angle += solid_angle(centre - p, ring[k] - p, ring[k + 1] - p);
    p -= angle / (4 * std::numbers::pi) * a * shockley;
  }
  return points;
}

/// Equal up to the sign and to how the axes of the cube are named.
void expect_burgers(const DislocationSegment& s, Vector wanted) {
  Vector found = s.burgers.cwiseAbs();
  wanted = wanted.cwiseAbs();
  std::sort(found.begin(), found.end());
  std::sort(wanted.begin(), wanted.end());
  EXPECT_LT((found - wanted).norm(), 1e-12);
}

TEST(Lines, NoneInPerfectCrystals) {
  for (const double noise : {0.0, 0.01, 0.03, 0.05, 0.08})  // sigma of LJ: 1.0911 a neighbour
    for (const double scale : {1e-9, 1.0, 1e3}) {
      Points ball = test::fcc_ball(10);
      test::add_noise(ball, noise / 1.0911, 7);
      test::turn(ball, Eigen::Quaterniond(0.3, -0.8, 0.5, 0.1 + noise).normalized());
      test::scale(ball, scale);
      const DislocationLines lines = lines_of(ball);
      EXPECT_TRUE(lines.segments.empty()) << "noise " << noise << ", scale " << scale;
      EXPECT_EQ(lines.residual, 0);
    }
}

// A line through the ball ends at its surface; there each end is within half a spacing.
TEST(Lines, PartialThroughABall) {
  constexpr double radius = 16;
  for (const double noise : {0.0, 1e-3, 0.046}) {
    Points ball = ball_with_partial(radius);
    test::add_noise(ball, noise);
    test::turn(ball, Eigen::Quaterniond(0.5, 0.1, -0.7, 0.4).normalized());
    const DislocationLines lines = lines_of(ball);
    ASSERT_EQ(lines.segments.size(), 1u) << noise;
    const DislocationSegment& s = lines.segments[0];
    expect_burgers(s, shockley);
    EXPECT_EQ(s.family, LineFamily::shockley);
    EXPECT_EQ(s.ends[0], LineEnd::surface);
    EXPECT_EQ(s.ends[1], LineEnd::surface);
    EXPECT_NEAR(s.length.value, 2 * radius - 1, 0.05 * radius + 3 * *s.length.error) << noise;
    EXPECT_NEAR(s.character, std::numbers::pi / 2, 0.4);  // b is normal to the line
    ASSERT_TRUE(s.slip_plane);
    EXPECT_EQ(lines.residual, 0);
  }
}

TEST(Lines, LoopKeepsItsLength) {
  constexpr double radius = 12.8;
  for (const double noise : {0.0, 0.046}) {
    Points ball = ball_with_loop(18, radius);
    test::add_noise(ball, noise);
    const DislocationLines lines = lines_of(ball);
    ASSERT_EQ(lines.segments.size(), 1u);
    const DislocationSegment& s = lines.segments[0];
    expect_burgers(s, shockley);
    EXPECT_EQ(s.ends[0], LineEnd::closed);
    EXPECT_NEAR(s.length.value, 2 * std::numbers::pi * radius, 0.02 * 2 * std::numbers::pi * radius);
    EXPECT_EQ(s.points.front(), s.points.back());
  }
}

// The sign of a Burgers vector follows from how its line runs: the area vector of the loop and b.
TEST(Lines, BurgersVectorIsThatOfTheSlip) {
  const DislocationLines lines = lines_of(ball_with_loop(12, 7));
  ASSERT_EQ(lines.segments.size(), 1u);
  const DislocationSegment& s = lines.segments[0];
  Vector area = Vector::Zero();
  for (std::size_t k = 1; k < s.points.size(); ++k) area += s.points[k - 1].cross(s.points[k]) / 2;
  EXPECT_NEAR(std::abs(area.normalized().dot(normal)), 1, 0.02);
  // What is above the disc moved by the slip against what is below. A line about that normal has the opposite b
  // (FS/RH: an edge along z with b along x has its half plane at +y, what is above moved by b where x < 0).
  const Vector b = s.crystal * s.burgers_here;
  const double above = area.dot(normal) > 0 ? 1 : -1;
  EXPECT_LT((above * b + a * shockley).norm(), 0.1 * a * shockley.norm());
}

TEST(Lines, TheSameAmongAllAtoms) {
  Points ball = ball_with_loop(14, 9);
  test::add_noise(ball, 0.03);
  DefectSettings all = lines_only();
  all.lines_everywhere = true;
  const double some = lines_of(ball).length(0).value, whole = lines_of(ball, all).length(0).value;
  EXPECT_GT(some, 50);
  EXPECT_NEAR(some, whole, 0.01 * whole);
}

TEST(Lines, ScaleAndTurnChangeNothing) {
  Points ball = ball_with_partial(12);
  test::add_noise(ball, 0.03);
  const DislocationLines once = lines_of(ball);
  ASSERT_EQ(once.segments.size(), 1u);
  for (const double scale : {1e-9, 0x1p10}) {
    Points other = ball;
    test::scale(other, scale);
    test::turn(other, Eigen::Quaterniond(0.2, 0.6, -0.7, 0.3).normalized());
    const DislocationLines lines = lines_of(other);
    ASSERT_EQ(lines.segments.size(), 1u) << scale;
    expect_burgers(lines.segments[0], once.segments[0].burgers);
    // Turned, atoms are rounded anew to 2^-22 spacings: ties between guesses may come out otherwise, by a zigzag.
    EXPECT_NEAR(lines.segments[0].length.value / scale, once.segments[0].length.value, 0.02 * once.segments[0].length.value);
  }
}

// A loop that grows from one frame to the next has swept the ring between.
TEST(Lines, TracksSweepTheAreaBetween) {
  LineTracks tracks;
  const double volume = 1000, before = 7, after = 8.5;
  std::vector<std::uint32_t> found[2];
  for (const int frame : {0, 1}) {
    const auto looked = test::look(ball_with_loop(14, frame == 0 ? before : after), lines_only());
    const DislocationLines& lines = looked.found.lines;
    ASSERT_EQ(lines.segments.size(), 1u);
    found[frame] = tracks.add({lines, looked.found.lattice, looked.found.centre, {volume, 0}, looked.found.spacing});
  }
  EXPECT_EQ(found[0], found[1]);
  ASSERT_EQ(tracks.tracks().size(), 1u);
  EXPECT_EQ(tracks.tracks()[0].last, 1u);
  ASSERT_EQ(tracks.slip().size(), 1u);
  const double ring = std::numbers::pi * (after * after - before * before);
  const double shear = a * shockley.norm() * ring / volume;
  EXPECT_NEAR(tracks.slip()[0].shear, shear, 0.15 * shear);  // radii are within 0.1 of 1.5
  EXPECT_NEAR(tracks.distortion(1).norm(), shear, 0.15 * shear);
  // What is above the growing disc moved by +b.
  const Vector slip = tracks.distortion(1) * normal;
  EXPECT_LT((slip - shear * shockley.normalized()).norm(), 0.2 * shear);
}

TEST(Lines, FamiliesAddUp) {
  const auto looked = test::look(ball_with_partial(10), lines_only());
  double sum = 0;
  for (std::size_t f = 0; f < line_families; ++f)
    sum += looked[std::string(name(static_cast<LineFamily>(f))) + "_length"];
  EXPECT_NEAR(sum, looked["line_length"], 1e-12 * sum);
  EXPECT_EQ(looked["shockley_length"], looked["shockley_length1"]);
  EXPECT_EQ(looked["shockley_length2"], 0);
  EXPECT_NEAR(looked["line_density1"], looked["line_length"] / looked.found.volume[0], 1e-12);
}

TEST(Lines, NothingWhereThereIsNoCrystal) {
  EXPECT_TRUE(lines_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).segments.empty());
  Points gas;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(0, 9);
  for (int k = 0; k < 900; ++k) gas.push_back({place(random), place(random), place(random)});
  const DislocationLines lines = lines_of(gas);
  EXPECT_TRUE(lines.segments.empty());
}

}  // namespace
}  // namespace mdana
