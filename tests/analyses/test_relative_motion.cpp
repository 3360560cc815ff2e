// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "analyses/motion.hpp"
#include "analyses/relative_motion.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using Eigen::Vector3d;

struct Body {
  double mass;
  Vector3d x, v, f;
};

Table motion_table(MotionParts parts) { return Table(make_motion(parts)->columns()); }

void add_row(Table& table, const Body& one, const Body& two, MotionParts parts) {
  std::vector<double> row{0};
  const auto add = [&](const Vector3d& v) { row.insert(row.end(), v.begin(), v.end()); };
  for (const Body& body : {one, two}) {
    row.insert(row.end(), {10, body.mass});
    add(body.x);
    if (parts.velocity) add(body.v);
    if (parts.force) add(body.f);
  }
  table.add_row(row);
}

/// Two bodies of masses 2 and 6 (m* = 1.5) about a moving centre; X(t) = 10 - t - t^2 + t^3/4 along
/// an oblique line, forces of a third party on both as well.
struct Trajectory {
  MotionParts parts;
  double unit = 1;  ///< force of one mass unit at one length/time^2, in force units
  Table table = motion_table(parts);
  std::vector<double> times;
  std::vector<std::int64_t> steps;
  static constexpr double reduced_mass = 1.5;

  Trajectory(MotionParts p, double force_unit = 1) : parts(p), unit(force_unit) {
    const Vector3d n = Vector3d(2, 3, 6) / 7, drift(3, -1, 0.5), outside(0.5, 0, -2);
    for (int i = 0; i < 12; ++i) {
      const double t = 0.1 * i + 0.01 * (i % 3);
      const Vector3d centre = drift * t + 0.5 * outside * t * t;
      const double x = distance(t), v = -1 - 2 * t + 0.75 * t * t;
      const Vector3d force = reduced_mass * unit * acceleration(t) * n;
      add_row(table,
              {2, centre - 0.75 * x * n, drift + outside * t - 0.75 * v * n,
               2 * unit * outside - force},
              {6, centre + 0.25 * x * n, drift + outside * t + 0.25 * v * n,
               6 * unit * outside + force},
              parts);
      times.push_back(t);
      steps.push_back(i);
    }
  }
  static double distance(double t) { return 10 - t - t * t + 0.25 * t * t * t; }
  static double acceleration(double t) { return -2 + 1.5 * t; }

  RelativeMotion motion() const { return relative_motion(table, steps, times); }
};

constexpr MotionParts all{true, true};

TEST(RelativeMotion, OfTwoBodies) {
  const Trajectory t(all);
  const RelativeMotion motion = t.motion();
  EXPECT_DOUBLE_EQ(motion.reduced_mass, 1.5);
  EXPECT_EQ(motion.frames(), 12);
  const auto distance = motion.distance(), speed = approach_speed(motion);
  for (std::size_t i = 0; i < distance.size(); ++i) {
    EXPECT_NEAR(distance[i], Trajectory::distance(t.times[i]), 1e-13);  // rounding of 10
    EXPECT_NEAR(speed[i], 1 + 2 * t.times[i] - 0.75 * t.times[i] * t.times[i], 1e-13);
  }
}

// X(t) is a cubic, which the five-point formulas differentiate exactly; rounding of positions of 10
// over steps of 0.1 is amplified to 1e-15 * 1e3 at most.
TEST(RelativeMotion, AllForceSourcesGiveTheForce) {
  const Trajectory t(all);
  for (const ForceSource source :
       {ForceSource::forces, ForceSource::velocities, ForceSource::positions}) {
    const auto force = interparticle_force(t.motion(), source, Units::lj);
    for (std::size_t i = 0; i < force.size(); ++i)
      EXPECT_NEAR(force[i], 1.5 * Trajectory::acceleration(t.times[i]), 1e-11) << name(source);
  }
}

TEST(RelativeMotion, ForcesAreInTheUnitsForce) {
  for (const Units units : {Units::metal, Units::real, Units::si, Units::electron}) {
    const double unit = force_per_mass_acceleration(units);
    const RelativeMotion motion = Trajectory(all, unit).motion();
    const auto exact = interparticle_force(motion, ForceSource::forces, units);
    for (const ForceSource source : {ForceSource::velocities, ForceSource::positions}) {
      const auto force = interparticle_force(motion, source, units);
      for (std::size_t i = 0; i < force.size(); ++i)
        EXPECT_NEAR(force[i], exact[i], 1e-11 * unit) << name(units) << " " << name(source);
    }
  }
}

TEST(RelativeMotion, SpeedFromPositionsWithoutVelocities) {
  const Trajectory with(all), without({false, false});
  const auto speed = approach_speed(without.motion());
  const auto exact = approach_speed(with.motion());
  ASSERT_EQ(speed.size(), exact.size());
  for (std::size_t i = 0; i < speed.size(); ++i) EXPECT_NEAR(speed[i], exact[i], 1e-11);
}

TEST(RelativeMotion, SaysWhichSourcesThereAre) {
  const RelativeMotion bare = Trajectory({false, false}).motion();
  EXPECT_FALSE(bare.can_give(ForceSource::forces));
  EXPECT_FALSE(bare.can_give(ForceSource::velocities));
  EXPECT_TRUE(bare.can_give(ForceSource::positions));
  EXPECT_INPUT_ERROR(interparticle_force(bare, ForceSource::forces, Units::lj), "forces", "lacks");
  Trajectory t(all);
  t.times.clear();
  EXPECT_TRUE(t.motion().can_give(ForceSource::forces));
  EXPECT_INPUT_ERROR(interparticle_force(t.motion(), ForceSource::positions, Units::lj),
                     "positions", "time between frames is unknown");
}

TEST(RelativeMotion, TooFewFramesToDifferentiate) {
  const RelativeMotion few = Trajectory(all).motion().subset(0, 3);
  ASSERT_EQ(few.frames(), 4);
  EXPECT_INPUT_ERROR(interparticle_force(few, ForceSource::velocities, Units::lj), "too few");
  EXPECT_EQ(interparticle_force(few, ForceSource::forces, Units::lj).size(), 4u);
}

TEST(RelativeMotion, SubsetsTakeEveryFrameOfTheirs) {
  const Trajectory t(all);
  const RelativeMotion whole = t.motion(), part = whole.subset(1, 4);
  EXPECT_EQ(part.steps, (std::vector<std::int64_t>{1, 5, 9}));
  EXPECT_EQ(part.times, (std::vector<double>{t.times[1], t.times[5], t.times[9]}));
  EXPECT_EQ(part.position.col(2), whole.position.col(9));
  EXPECT_EQ(part.reduced_mass, whole.reduced_mass);
}

TEST(RelativeMotion, CentresThatCoincideAreAnError) {
  Trajectory t(all);
  RelativeMotion motion = t.motion();
  motion.position.col(5).setZero();
  EXPECT_INPUT_ERROR(interparticle_force(motion, ForceSource::forces, Units::lj), "step 5");
}

TEST(RelativeMotion, TimesThatDoNotGrowAreAnError) {
  Trajectory t(all);
  t.times[4] = t.times[3];
  EXPECT_INPUT_ERROR(interparticle_force(t.motion(), ForceSource::velocities, Units::lj), "time");
}

TEST(RelativeMotion, LostAtomsAreAnError) {
  Table table = motion_table({});
  const Body one{2, {0, 0, 0}, {}, {}};
  add_row(table, one, {6, {5, 0, 0}, {}, {}}, {});
  add_row(table, one, {5.5, {5, 0, 0}, {}, {}}, {});
  EXPECT_INPUT_ERROR(relative_motion(table, {100, 200}, {}), "step 200", "lost");
}

// Up to 1 % of a body's atoms: counted, and the reduced mass stays.
TEST(RelativeMotion, AFewLostAtomsAreCounted) {
  Table table = motion_table({});
  const auto add = [&](double atoms1, double atoms2) {
    table.add_row(std::vector<double>{0, atoms1, 2 * atoms1, 0, 0, 0, atoms2, 3 * atoms2, 5, 0, 0});
  };
  add(1000, 2000);
  add(1000, 2000);
  add(998, 2001);
  add(990, 2000);
  const RelativeMotion motion = relative_motion(table, {1, 2, 3, 4}, {});
  EXPECT_EQ(motion.lost, (std::vector<double>{0, 0, 1, 10}));
  EXPECT_EQ(motion.first_lost, 2u);
  EXPECT_NEAR(motion.greatest_loss, 0.01, 1e-12);
  EXPECT_EQ(motion.reduced_mass, 1500);
  EXPECT_EQ(motion.subset(1, 2).lost, (std::vector<double>{0, 10}));
  add(989, 2000);
  EXPECT_INPUT_ERROR(relative_motion(table, {1, 2, 3, 4, 5}, {}), "step 5", "989", "more than 1 %");
}

}  // namespace
}  // namespace mdana
