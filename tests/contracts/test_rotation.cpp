// SPDX-License-Identifier: GPL-3.0-or-later
// The whole frame moved and turned: vectors turn with it, all other columns stay.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/contracts/catalogue.hpp"

namespace mdana {
namespace {

using test::MadeUpAtom;
using test::MadeUpFrame;

struct Motion {
  Eigen::Quaterniond turn;
  Eigen::Vector3d shift;

  std::vector<MadeUpFrame> apply(std::vector<MadeUpFrame> frames) const {
    for (MadeUpFrame& frame : frames)
      for (MadeUpAtom& atom : frame.atoms) {
        atom.x = turn * atom.x + shift;
        atom.v = turn * atom.v;
        atom.f = turn * atom.f;
      }
    return frames;
  }
};

/// "x1", "vx2", "fx1": first component of a vector; the others follow it.
bool starts_vector(const std::string& name) {
  return name.size() >= 2 && name.size() <= 3 && name[name.size() - 2] == 'x' &&
         (name.size() == 2 || name[0] == 'v' || name[0] == 'f');
}

Eigen::Vector3d vector(const Table& table, std::size_t column, std::size_t row) {
  return {table.column(column)[row], table.column(column + 1)[row], table.column(column + 2)[row]};
}

void expect_moved(const Table& plain, const Table& moved, const Motion& motion, double rounding) {
  for (std::size_t c = 0; c < plain.columns().size(); ++c)
    for (std::size_t row = 0; row < plain.rows(); ++row) {
      const std::string& name = plain.columns()[c].name;
      if (starts_vector(name)) {
        Eigen::Vector3d expected = motion.turn * vector(plain, c, row);
        if (name.size() == 2) expected += motion.shift;
        const double scale = std::max(1.0, expected.norm());
        EXPECT_LE((vector(moved, c, row) - expected).norm(), rounding * scale) << name;
      } else if (plain.columns()[c].name.find_first_of("xyz") == std::string::npos) {
        const double a = plain.column(c)[row];
        const double b = moved.column(c)[row];
        // Directions between grains that are 1/64 apart or less are rounded by so much more.
        const double scale = name.starts_with("fabric") ? 128 : std::max(1.0, std::abs(a));
        EXPECT_TRUE(test::agree(a, b, rounding * scale)) << name << " " << a << " " << b;
      }
    }
}

// Positions of order one moved by `shift` are rounded to epsilon * |shift|; the sums over atoms add
// no more than a few of those. 20 epsilon (1 + |shift|).
void expect_law(const Motion& motion) {
  const auto frames = test::made_up_collision(4, 500);
  const SweepResult plain = test::sweep_catalogue(frames);
  const SweepResult moved = test::sweep_catalogue(motion.apply(frames));
  const double rounding = 20 * 2.2e-16 * (1 + motion.shift.norm());
  for (std::size_t k = 0; k < plain.tables.size(); ++k) {
    SCOPED_TRACE(k);
    expect_moved(plain.tables[k], moved.tables[k], motion, std::max(rounding, 1e-13));
  }
}

TEST(CatalogueMoved, Translation) {
  expect_law({Eigen::Quaterniond::Identity(), {3, -5, 7}});
  expect_law({Eigen::Quaterniond::Identity(), {1e7, 2e6, -1e7}});
}

TEST(CatalogueMoved, Rotation) {
  for (const Eigen::Vector4d& q :
       {Eigen::Vector4d(1, 1, 1, 1), Eigen::Vector4d(0.3, -0.8, 0.5, 0.1),
        Eigen::Vector4d(0, 1, 0, 0), Eigen::Vector4d(0.1, 0.9, 1, -7)})
    expect_law({Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized(), {0, 0, 0}});
}

TEST(CatalogueMoved, RotationAndTranslation) {
  expect_law({Eigen::Quaterniond(0.2, 0.4, -0.4, 0.8).normalized(), {100, 200, -300}});
}

}  // namespace
}  // namespace mdana
