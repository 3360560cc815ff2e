// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "fits/contact_fit.hpp"
#include "fits/followed_collision.hpp"
#include "fits/predicted_motion.hpp"
#include "fits/residual_memory.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

// ---- a law's motion at times

TEST(PredictedMotion, OutsideItIsFreeFlightOrRest) {
  Collision c;
  c.outcome = CollisionOutcome::bounce;
  c.trajectory = {{0.5, 1, 0, 0, 9}, {1, 0, -1, 0, 5}};
  const std::vector<double> times{-0.5, 0.5, 3};
  const auto bounce = predicted_motion(c, 2, times);
  EXPECT_EQ(bounce[0].delta, -1);
  EXPECT_EQ(bounce[1].force, 9);
  EXPECT_EQ(bounce[2].delta, -2);
  EXPECT_EQ(bounce[2].force, 0);
  c.outcome = CollisionOutcome::stick;
  EXPECT_EQ(predicted_motion(c, 2, times)[2].delta, 0);
  EXPECT_EQ(predicted_motion(c, 2, times)[2].force, 5);
}

/// -m* dv/dt = F and ddelta/dt = v by differences of a law's points at neighbouring times.
TEST(PredictedMotion, ObeysTheEquationOfMotion) {
  for (const CollisionLaw* law : collision_laws()) {
    ObservedCollision seen;
    seen.given = {{"R", 88.4}, {"m", 3120599}, {"E", 65.5}, {"v", 0.2}};
    const std::vector<NamedNumber> all{{"gamma", law->name == "thornton" ? 0 : 3.17}, {"nu", 0.25}, {"T_vis", 0.05}, {"v_Y", 0.05}, {"Y", 6},
                                       {"C", 2.1e-4}, {"B", 6.2}, {"zeta", 4}, {"D", 118}, {"alpha", 3}, {"beta", 1.5}};
    std::vector<NamedNumber> own;
    for (const NamedNumber& n : all)
      if (n.name != (law->name == "andrews" ? "v_Y" : "Y")) own.push_back(n);
    CollisionSettings settings{.tolerance = 1e-11, .trajectory = true};
    constexpr double h = 0.02;
    for (double t = 3; t < 100; t += 7)
      for (const double side : {-h, 0.0, h}) settings.times.push_back(t + side);
    const Collision c = collide(*law, input_of(*law, seen, own), settings);
    ASSERT_GT(c.trajectory.size(), 30u) << law->name;
    for (std::size_t k = 0; k + 3 < c.trajectory.size(); k += 3) {
      const CollisionPoint &a = c.trajectory[k], &p = c.trajectory[k + 1], &b = c.trajectory[k + 2];
      EXPECT_NEAR((b.delta - a.delta) / (2 * h), p.velocity, 1e-6) << law->name << " at " << p.time;
      EXPECT_NEAR(-3120599 / 2.0 * (b.velocity - a.velocity) / (2 * h), p.force, 1e-4 * 20000) << law->name << " at " << p.time;
    }
  }
}

// ---- what rows tell

std::vector<MotionSample> rows_of(double first, double step, int count, bool velocities,
                                  double (*delta)(double), double (*velocity)(double)) {
  std::vector<MotionSample> rows;
  for (int i = 0; i < count; ++i) {
    MotionSample r{first + i * step, {}, {}, {}};
    r.delta.value = delta(r.time);
    if (velocities) r.velocity.value = velocity(r.time);
    rows.push_back(r);
  }
  return rows;
}

// delta = sin(t - 0.5) of one half wave and its neighbourhood.
TEST(FollowedCollision, TimesCountFromTheZeroOfDelta) {
  for (const bool velocities : {true, false}) {
    const auto rows = rows_of(0, 0.1, 60, velocities, [](double t) { return std::sin(t - 0.537); },
                              [](double t) { return std::cos(t - 0.537); });
    const ObservedCollision c = followed_collision(rows, "run");
    EXPECT_NEAR(*c.find("v"), 1, 2e-5);  // h^3/24 of the cubic
    EXPECT_NEAR(c.motion.front().time, 0.5 - 0.537, 1e-5);
    EXPECT_LT(c.motion.front().delta.value, 0);
    EXPECT_NEAR(c.motion.back().time, 1.5 * std::acos(-1.0), 0.1);  // where sin rises again
    EXPECT_EQ(c.motion[3].delta.value, rows[8].delta.value);
  }
}

TEST(FollowedCollision, ADeltaThatBeginsAtZero) {
  const auto rows = rows_of(0, 0.25, 20, true, [](double t) { return t * (2 - t); }, [](double t) { return 2 - 2 * t; });
  const ObservedCollision c = followed_collision(rows, "run");
  EXPECT_EQ(c.motion.front().time, 0);
  EXPECT_EQ(*c.find("v"), 2);
  EXPECT_GT(c.motion.back().delta.value, -1);  // no farther apart than they were compressed
}

void expect_refused(const std::vector<MotionSample>& rows, const std::string& says) {
  try {
    followed_collision(rows, "run");
    FAIL() << says;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
  }
}

TEST(FollowedCollision, WhatCannotBeFollowed) {
  const auto parabola = [](double t) { return t * (2 - t); };
  expect_refused(rows_of(0.5, 0.1, 20, false, parabola, nullptr), "begins in contact");
  expect_refused(rows_of(-0.5, 0.1, 12, false, parabola, nullptr), "before its first turn");
  expect_refused(rows_of(-0.5, 0.1, 4, false, parabola, nullptr), "never rises above 0");
  expect_refused(rows_of(-0.5, 0.1, 3, false, parabola, nullptr), "at least 4");
  auto rows = rows_of(-0.5, 0.1, 30, false, parabola, nullptr);
  std::swap(rows[5].time, rows[6].time);
  expect_refused(rows, "time does not rise from row 6 to 7");
  rows = rows_of(-0.5, 0.1, 30, false, parabola, nullptr);
  rows[2].delta.value = std::nan("");
  expect_refused(rows, "delta of row 3 is not a number");
}

// ---- fits

struct Case {
  const char* law;
  std::vector<NamedNumber> truth, constants;
};

/// The law's own steps, at 1e-12, as rows; so nothing of what is fitted interpolated them.
ObservedCollision followed(const Case& test, double v, bool forces) {
  const CollisionLaw& law = *find_collision_law(test.law);
  ObservedCollision seen;
  seen.given = {{"R", 88.4}, {"m", 3120599}, {"v", v}};
  seen.place = "study";
  std::vector<NamedNumber> all = test.constants;
  all.insert(all.end(), test.truth.begin(), test.truth.end());
  const Collision c = collide(law, input_of(law, seen, all), {.tolerance = 1e-12, .trajectory = true});
  std::vector<MotionSample> rows;
  double last = -1e9;
  for (const CollisionPoint& p : c.trajectory) {
    if (p.time - last < c.t_max / 60) continue;
    last = p.time;
    rows.push_back({p.time, {p.delta, {}}, {p.velocity, {}}, {}});
    if (forces) rows.back().force.value = p.force;
  }
  ObservedCollision o = followed_collision(rows, "study");
  o.given.insert(o.given.end(), {{"R", 88.4}, {"m", 3120599}});
  return o;
}

ContactFit fit(const Case& test, const std::vector<ObservedCollision>& seen, IntervalSettings intervals = {}) {
  ContactFitSettings settings;
  settings.constants = test.constants;
  for (const NamedNumber& n : test.truth) settings.free.push_back({n.name, {}, {}, {}, {}, false});
  settings.starts = 2;
  settings.intervals = intervals;
  return fit_contact(*find_collision_law(test.law), seen, settings);
}

const std::vector<Case> cases{
    {"hertz", {{"E", 65.5}}, {}},
    {"viscous-hertz", {{"T_vis", 0.06}, {"E", 65.5}}, {{"nu", 0.25}}},
    {"jkr", {{"gamma", 3.17}, {"E", 65.5}}, {}},
    {"andrews", {{"E", 65.5}, {"Y", 6}}, {}},
    {"krijt", {{"T_vis", 0.05}}, {{"E", 65.5}, {"gamma", 3.17}, {"nu", 0.25}, {"spacing", 1.091}}},
    {"stress", {{"C", 2.1e-4}, {"B", 6.2}, {"zeta", 4}}, {{"E", 65.5}, {"gamma", 3.17}, {"nu", 0.25}, {"spacing", 1.091}}},
    {"power", {{"D", 118}, {"alpha", 3}, {"beta", 1.5}}, {{"E", 65.5}, {"gamma", 3.17}}}};

// One motion tells gamma and E* apart, E* and Y, and C, B, zeta, which e of one velocity does not.
TEST(FollowedCollision, ParametersAreFoundAgainFromOneMotion) {
  for (const Case& test : cases) {
    const ContactFit f = fit(test, {followed(test, 0.2, true)});
    ASSERT_TRUE(f.usable) << test.law << ": " << f.reason;
    const double tolerance = test.truth.back().name == "Y" ? 1e-5 : 1e-6;  // E tells only of the motion before yield
    for (std::size_t k = 0; k < test.truth.size(); ++k)
      EXPECT_NEAR(f.parameters[k].value / test.truth[k].value, 1, tolerance) << test.law << " " << test.truth[k].name;
  }
}

TEST(FollowedCollision, DeltaAloneDoes) {
  for (const std::size_t k : {0u, 2u, 3u}) {
    ObservedCollision seen = followed(cases[k], 0.2, false);
    for (MotionSample& m : seen.motion) m.velocity = {};
    const ContactFit f = fit(cases[k], {seen});
    ASSERT_TRUE(f.usable) << f.reason;
    EXPECT_NEAR(f.parameters[0].value / cases[k].truth[0].value, 1, 1e-6) << cases[k].law;
  }
}

// Noise of 1 % of the greatest delta, v and F: of 20 intervals 13.7 +- 2.1 hold gamma.
TEST(FollowedCollision, IntervalsOfNoisyMotionsCoverTheTruth) {
  const Case& jkr = cases[2];
  const ObservedCollision clean = followed(jkr, 0.2, true);
  double delta = 0, force = 0;
  for (const MotionSample& m : clean.motion)
    delta = std::max(delta, m.delta.value), force = std::max(force, std::abs(m.force.value));
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 0.01);
  int by_error = 0, by_bootstrap = 0;
  IntervalSettings intervals;
  intervals.draws = 40;
  for (int i = 0; i < 20; ++i) {
    ObservedCollision seen = clean;
    for (MotionSample& m : seen.motion) {
      m.delta.value += delta * normal(random);
      m.velocity.value += 0.2 * normal(random);
      m.force.value += force * normal(random);
    }
    const ContactFit f = fit(jkr, {seen}, intervals);
    ASSERT_TRUE(f.usable) << f.reason;
    const Estimate& gamma = f.parameters[0];
    by_error += std::abs(gamma.value - 3.17) <= gamma.error;
    by_bootstrap += gamma.bootstrap.low <= 3.17 && 3.17 <= gamma.bootstrap.high;
  }
  for (const int covered : {by_error, by_bootstrap}) {
    EXPECT_GE(covered, 7);
    EXPECT_LE(covered, 19);
  }
}

// ---- residuals that are alike

/// x_i = rho x_(i-1) + noise has the memory (1 + rho)/(1 - rho).
TEST(ResidualMemory, OfAnAutoregressiveSeries) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (const double rho : {0.0, 0.5, 0.8}) {
    std::vector<FittedPoint> points;
    double x = 0;
    for (std::size_t i = 0; i < 20000; ++i) {
      x = rho * x + normal(random);
      points.push_back({0, SeenQuantity::delta, i, 0, x});
    }
    EXPECT_NEAR(residual_memory(points), (1 + rho) / (1 - rho), 0.1 * (1 + rho) / (1 - rho)) << rho;
  }
}

TEST(ResidualMemory, SeriesThatAreTheSameCountOnce) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  std::vector<FittedPoint> points;
  for (std::size_t i = 0; i < 5000; ++i) {
    const double x = normal(random);
    for (const SeenQuantity q : {SeenQuantity::delta, SeenQuantity::velocity, SeenQuantity::force})
      points.push_back({0, q, i, 0, q == SeenQuantity::velocity ? -x : x});
  }
  EXPECT_NEAR(residual_memory(points), 3, 0.1);
}

TEST(ResidualMemory, CollisionsHaveNone) {
  std::vector<FittedPoint> points;
  for (std::size_t i = 0; i < 50; ++i) points.push_back({i, SeenQuantity::e_squared, 0, 0.5, 1.0});
  EXPECT_EQ(residual_memory(points), 1);
}

}  // namespace
}  // namespace mdana
