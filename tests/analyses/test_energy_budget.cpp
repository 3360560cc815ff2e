// SPDX-License-Identifier: GPL-3.0-or-later
// What a collision makes of the energy, for motions whose answer is known in closed form.
#include "analyses/energy_budget.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/analyses/collision.hpp"

namespace mdana {
namespace {

constexpr double radius_sum = 20, mass = 2, speed = 0.5;

struct Collision {
  ForceCurve curve;
  EnergyCurve energy;
};

/// Total energies of 1000 are summed over 500 frames with rounding of 1e-12, 1e-11 of K_p or less.
/// `heated`: the part of what K_p loses that K_t of body 1 gets; W gets the rest, and all that is in
/// the spring meanwhile. `lost` of the first K_p leaves the system by the end.
Collision collide(const test::Path& path, double first, double last, double heated,
                  double lost = 0) {
  const RelativeMotion motion =
      test::head_on(test::even_times(first, last, 0.05), path, radius_sum, mass);
  Collision c;
  c.curve = force_curve(motion, ForceSource::forces, Units::lj, radius_sum);
  const double start = 0.5 * mass * speed * speed;
  for (Eigen::Index i = 0; i < motion.frames(); ++i) {
    const bool over = motion.times[static_cast<std::size_t>(i)] > 10;
    const double k = 0.5 * mass * motion.velocity.col(i).squaredNorm();
    c.energy.K_p_rel.push_back(k);
    c.energy.K_p_across.push_back(over ? 0.05 * start : 0);
    c.energy.W_total.push_back(-1000 + (1 - heated) * (start - k) - (over ? lost * start : 0));
    for (std::size_t b = 0; b < 2; ++b) {
      c.energy.K_t[b].push_back(b == 0 ? 3 + heated * (start - k) : 1);
      c.energy.rotation[b].push_back(0);
      c.energy.temperature[b].push_back(0.25);
    }
  }
  return c;
}

EnergyBudget budget(const Collision& c) {
  return energy_budget(c.energy, c.curve, energy_windows(c.curve).value());
}

// e = w1/w2 = 1/2: 3/4 of K_p = 0.25 is lost, 60 % of it to heat (P1's share).
TEST(EnergyBudget, PlasticBounce) {
  const Collision c = collide(test::plastic_bounce(speed, 0.5, 1), -10, 20, 0.6);
  const EnergyBudget b = budget(c);
  EXPECT_EQ(c.curve.outcome, Outcome::bounce);
  EXPECT_NEAR(b.K_p_initial.value, 0.25, 1e-14);
  EXPECT_NEAR(b.delta_K_p.value, -0.1875, 1e-14);
  EXPECT_NEAR(b.delta_K_t.value, 0.1125, 1e-13);
  EXPECT_NEAR(b.delta_W.value, 0.075, 1e-12);  // rounding of W = -1000
  EXPECT_NEAR(b.K_t_share.value, 0.6, 1e-12);
  EXPECT_NEAR(b.W_share.value, 0.4, 1e-10);
  EXPECT_NEAR(b.energy_drift.value, 0, 1e-10);
  EXPECT_NEAR(b.restitution.value, 0.5, 1e-13);
  EXPECT_NEAR(b.one_minus_e2.value, 0.75, 1e-13);
  EXPECT_NEAR(b.converted.value, b.one_minus_e2.value, 1e-10);
  EXPECT_NEAR(b.across.value, 0.05, 1e-15);
  EXPECT_EQ(b.temperature_after[1].value, 0.25);
  EXPECT_LE(*b.delta_K_p.error, 1e-14);
}

// Equal masses exchange their velocities: nothing is converted, shares of nothing are not numbers.
TEST(EnergyBudget, ElasticExchangeConvertsNothing) {
  const EnergyBudget b = budget(collide(test::elastic_bounce(speed, 1), -10, 15, 0.5));
  EXPECT_NEAR(b.delta_K_p.value, 0, 1e-15);
  EXPECT_NEAR(b.delta_W.value, 0, 1e-12);
  EXPECT_NEAR(b.converted.value, 0, 1e-10);
  EXPECT_NEAR(b.restitution.value, 1, 1e-14);
}

TEST(EnergyBudget, SticksAndKeepsNothing) {
  const auto damped = [](double t) -> test::Approach {
    const double w = 1, g = 0.3, s = std::exp(-g * t) * speed / w;
    const double delta = s * std::sin(w * t), v = s * (w * std::cos(w * t) - g * std::sin(w * t));
    return {delta, v, -2 * g * v - (w * w + g * g) * delta};
  };
  const EnergyBudget b =
      budget(collide(test::with_flight(speed, 1e9, 0, damped), -10, 60, 0.25));
  EXPECT_EQ(b.restitution.value, 0);
  EXPECT_NEAR(b.converted.value, 1, 1e-10);
  EXPECT_NEAR(b.K_t_share.value, 0.25, 1e-10);
}

// Weak damping: a tenth of K_p is still there when the dump ends, wherever that is. Over whole periods
// K_p is what is missing to 1, and the error covers it.
TEST(EnergyBudget, RingingIsPartOfTheError) {
  constexpr double w = 1, g = 0.02;
  const auto damped = [](double t) -> test::Approach {
    const double s = std::exp(-g * t) * speed / w;
    const double delta = s * std::sin(w * t), v = s * (w * std::cos(w * t) - g * std::sin(w * t));
    return {delta, v, -2 * g * v - (w * w + g * g) * delta};
  };
  for (double end = 35; end < 42; end += 0.5) {
    const Collision c = collide(test::with_flight(speed, 1e9, 0, damped), -10, end, 0.25);
    const EnergyBudget b = budget(c);
    EXPECT_GT(b.ringing.value, 0.05);
    EXPECT_NEAR(b.converted.value + b.ringing.value, 1, 1e-9);
    ASSERT_TRUE(b.converted.error);
    EXPECT_LE(std::abs(b.converted.value - 1), *b.converted.error);
    const EnergyWindow after = b.windows.after;  // whole periods of 2 pi, frames every 0.05
    const double periods = static_cast<double>(after.frames()) * 0.05 / (2 * std::numbers::pi);
    EXPECT_NEAR(periods, std::round(periods), 0.02);
  }
}

// Energy that leaves the system is told, and is part of the error of delta_W.
TEST(EnergyBudget, DriftIsABoundForPotentialEnergy) {
  const EnergyBudget b = budget(collide(test::plastic_bounce(speed, 0.5, 1), -10, 20, 0.6, 0.1));
  EXPECT_NEAR(b.energy_drift.value, -0.1, 1e-10);
  EXPECT_NEAR(b.delta_W.value, 0.075 - 0.025, 1e-12);
  EXPECT_GE(*b.delta_W.error, 0.025 * (1 - 1e-9));
  EXPECT_LE(*b.delta_K_t.error, 1e-12);
}

TEST(EnergyBudget, WithoutPotentialTheRestIsThere) {
  Collision c = collide(test::plastic_bounce(speed, 0.5, 1), -10, 20, 0.6);
  c.energy.W_total.clear();
  const EnergyBudget b = budget(c);
  EXPECT_NEAR(b.K_t_share.value, 0.6, 1e-12);
  for (const Value& value : {b.delta_W, b.W_share, b.energy_drift, b.converted})
    EXPECT_TRUE(std::isnan(value.value) && !value.error);
}

TEST(EnergyBudget, FramesWithoutPotentialAreLeftOut) {
  Collision c = collide(test::plastic_bounce(speed, 0.5, 1), -10, 20, 0.6);
  for (std::size_t i = 0; i < c.energy.W_total.size(); ++i)
    if (i % 10) c.energy.W_total[i] = std::nan("");
  EXPECT_NEAR(budget(c).delta_W.value, 0.075, 1e-12);
}

TEST(EnergyBudget, WindowsLieOutsideContact) {
  const Collision c = collide(test::plastic_bounce(speed, 0.5, 1), -10, 20, 0.6);
  const EnergyWindows w = energy_windows(c.curve).value();
  EXPECT_EQ(w.before.first, 0u);
  EXPECT_EQ(c.curve.phase[2 * w.before.last - 2], Phase::approach);
  EXPECT_EQ(w.after.last, c.curve.phase.size());
  EXPECT_EQ(c.curve.phase[w.after.first - w.after.frames() + 1], Phase::separated);
}

TEST(EnergyBudget, NoFrameBeforeContactGivesNone) {
  const Collision c = collide(test::plastic_bounce(speed, 0.5, 1), 0.5, 20, 0.6);
  EXPECT_FALSE(energy_windows(c.curve));
  EXPECT_FALSE(energy_windows(collide(test::elastic_bounce(speed, 1), -10, -1, 0.6).curve));
}

// Independent values of spread 1: the error is 1/sqrt(n). Values that drift: half of what they drift
// between the halves, where s/sqrt(n) would say ten times less.
TEST(WindowMean, ErrorSeesScatterAndDrift) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(7, 1);
  std::vector<double> noise, drift;
  double errors = 0;
  for (int trial = 0; trial < 200; ++trial) {
    noise.clear();
    for (int i = 0; i < 400; ++i) noise.push_back(normal(random));
    const Value mean = window_mean(noise, {0, 400}, dimension::none);
    EXPECT_LE(std::abs(mean.value - 7), 5 * *mean.error);
    errors += *mean.error / 200;
  }
  EXPECT_GT(errors, 0.05);
  EXPECT_LT(errors, 0.07);
  for (int i = 0; i < 400; ++i) drift.push_back(i);
  EXPECT_NEAR(*window_mean(drift, {0, 400}, dimension::none).error, 100, 1e-9);
}

TEST(WindowMean, ErrorOfOneValueIsTheChangeBesideIt) {
  EXPECT_EQ(window_mean({3, 5, 9}, {0, 1}, dimension::none).error, 2);
  EXPECT_EQ(window_mean({3, 5, 9}, {1, 2}, dimension::none).error, 4);
  EXPECT_EQ(window_mean({3, 5, std::nan("")}, {1, 2}, dimension::none).error, 2);
}

TEST(WindowMean, OneValueHasNoErrorAndNoneNoValue) {
  EXPECT_FALSE(window_mean({3}, {0, 1}, dimension::none).error);
  EXPECT_TRUE(std::isnan(window_mean({}, {0, 1}, dimension::none).value));
  EXPECT_TRUE(std::isnan(window_mean({std::nan("")}, {0, 1}, dimension::none).value));
}

}  // namespace
}  // namespace mdana
