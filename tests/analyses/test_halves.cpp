// SPDX-License-Identifier: GPL-3.0-or-later
// The two sides of the contact plane against the bodies themselves.
#include <gtest/gtest.h>

#include "analyses/halves.hpp"
#include "analyses/motion.hpp"
#include "tests/contracts/catalogue.hpp"

namespace mdana {
namespace {

using test::MadeUpAtom;
using test::MadeUpFrame;

struct Measured {
  double by_membership, by_sign, speed_by_membership, speed_by_sign, below, above;
};

Measured measure(const MadeUpFrame& frame, std::array<double, 2> radius) {
  const test::TemporaryFolder folder;
  const auto dump = folder.write("dump", test::dump_text(frame));
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_motion({true, false}));
  analyses.push_back(make_halves(radius, true));
  const FrameHeader first = first_header(dump);
  const SweepResult swept = sweep(dump, find_bodies(dump, first, "type"), Masses::from_column("dump"), analyses);
  const auto [a, b] = body_motion(swept.tables[0], 0);
  const Eigen::Vector3d n = (b.position - a.position).normalized();
  const Table& halves = swept.tables[1];
  const auto value = [&](const char* column) { return halves.column(column)[0]; };
  return {(b.position - a.position).norm(), value("half_distance"), -n.dot(b.velocity - a.velocity),
          value("half_speed"), value("half_atoms1"), value("half_atoms2")};
}

/// Body 1 a ball, body 2 its point reflection in the origin of a frame that drifts.
MadeUpFrame mirrored(double half, const Eigen::Vector3d& shift, const Eigen::Vector3d& drift) {
  std::mt19937_64 random(3);
  const Eigen::Vector3d n = Eigen::Vector3d(2, -1, 2) / 3;
  MadeUpFrame frame;
  frame.atoms = test::ball(random, 1, 400, 1, -half * n, 0.25 * n);
  for (std::size_t i = 0; i < 400; ++i) {
    MadeUpAtom atom = frame.atoms[i];
    atom.type = 2;
    atom.x = -atom.x;
    atom.v = -atom.v;
    frame.atoms.push_back(atom);
  }
  for (std::size_t i = 0; i < frame.atoms.size(); ++i) {
    frame.atoms[i].id = static_cast<std::int64_t>(i + 1);
    frame.atoms[i].x += shift;
    frame.atoms[i].v += drift;
  }
  return frame;
}

// With as many crossed atoms from either side: 2/N of the sum of their heights, and of twice their
// velocities along the line.
TEST(Halves, DifferFromBodiesByTheCrossedAtomsOnly) {
  for (const double half : {1.5, 0.97, 0.9, 0.7}) {
    const MadeUpFrame frame = mirrored(half, {0, 0, 0}, {0, 0, 0});
    Eigen::Vector3d centre(0, 0, 0);
    for (std::size_t i = 400; i < 800; ++i) centre += frame.atoms[i].x / 400;
    const Eigen::Vector3d n = centre.normalized();
    double crossed = 0, speed = 0;
    std::size_t count = 0;
    for (const MadeUpAtom& atom : frame.atoms) {
      const double h = n.dot(atom.x) * (atom.type == 1 ? 1 : -1);
      if (h <= 0) continue;
      ++count;
      crossed += h;
      speed += n.dot(atom.v) * (atom.type == 1 ? 1 : -1);
    }
    const Measured m = measure(frame, {1, 1});
    EXPECT_EQ(m.below, 400);
    EXPECT_EQ(m.above, 400);
    EXPECT_EQ(count > 0, half < 1) << half;
    EXPECT_NEAR(m.by_sign - m.by_membership, 2 * crossed / 400, 1e-13);
    EXPECT_NEAR(m.speed_by_sign - m.speed_by_membership, -2 * speed / 400, 1e-13);
  }
}

// Positions shifted by 1e3 are rounded to 1e-13, velocities on a drift of 1e6 to 1e-10.
TEST(Halves, FrameOfReferenceDoesNotMatter) {
  const Measured plain = measure(mirrored(0.9, {0, 0, 0}, {0, 0, 0}), {1, 1});
  const Measured moved = measure(mirrored(0.9, {1e3, -2e3, 500}, {1e6, 2e6, -1e6}), {1, 1});
  EXPECT_NEAR(moved.by_sign, plain.by_sign, 1e-11);
  EXPECT_NEAR(moved.speed_by_sign, plain.speed_by_sign, 1e-8);
}

// Unequal bodies that touch: the plane lies where they touch, and no atom is on the other side.
TEST(Halves, UnequalBodiesAreDividedWhereTheyTouch) {
  std::mt19937_64 random(5);
  MadeUpFrame frame;
  frame.atoms = test::ball(random, 1, 1000, 3, {-3.2, 0, 0}, {1, 0, 0});
  for (const MadeUpAtom& atom : test::ball(random, 2, 40, 1, {1.2, 0, 0}, {-1, 0, 0})) frame.atoms.push_back(atom);
  for (std::size_t i = 0; i < frame.atoms.size(); ++i) frame.atoms[i].id = static_cast<std::int64_t>(i + 1);
  const Measured m = measure(frame, {3, 1});
  EXPECT_EQ(m.below, 1000);
  EXPECT_EQ(m.above, 40);
  EXPECT_NEAR(m.by_sign, m.by_membership, 1e-13);
}

}  // namespace
}  // namespace mdana
