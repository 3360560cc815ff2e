// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include <gtest/gtest.h>

#include "tests/analyses/collision.hpp"

namespace mdana {
namespace {

using test::Approach;
using test::even_times;
using test::head_on;

constexpr ForceSource sources[] = {ForceSource::forces, ForceSource::velocities,
                                   ForceSource::positions};
constexpr double mass = 3, v = 0.5, omega = 0.25, radii = 20;

ForceCurve curve_of(const test::Path& path, ForceSource source, double first, double last,
                    double step) {
  return force_curve(head_on(even_times(first, last, step), path, radii, mass), source, Units::lj,
                     radii);
}

// F = m* omega^2 delta; 50 frames in contact. Differences blur the corner at touch over two frames,
// 2/50 of the contact; the values at the turn are smooth.
TEST(ForceCurve, OfAnElasticBounce) {
  for (const ForceSource source : sources) {
    const ForceCurve curve = curve_of(test::elastic_bounce(v, omega), source, -8, 25, 0.25);
    const double f_max = mass * omega * v, energy = 0.5 * mass * v * v;
    EXPECT_TRUE(curve.contact);
    EXPECT_EQ(curve.outcome, Outcome::bounce) << name(source);
    EXPECT_EQ(curve.cycles.size(), 1u);
    EXPECT_NEAR(curve.force_max.value, f_max, 1e-3 * f_max) << name(source);
    EXPECT_NEAR(curve.delta_max.value, v / omega, 1e-3 * v / omega);
    EXPECT_NEAR(curve.hysteresis_area.value, 0, 2e-3 * energy) << name(source);
    EXPECT_NEAR(curve.force_min_loading.value, 0, 0.02 * f_max) << name(source);
  }
}

TEST(ForceCurve, LoopAreaIsTheEnergyLost) {
  for (const double stiffer : {1.25, 2.0, 4.0})
    for (const ForceSource source : sources) {
      const ForceCurve curve =
          curve_of(test::plastic_bounce(v, omega, stiffer * omega), source, -8, 25, 0.1);
      const double energy = 0.5 * mass * v * v, lost = energy * (1 - 1 / (stiffer * stiffer));
      EXPECT_EQ(curve.outcome, Outcome::bounce);
      EXPECT_NEAR(curve.hysteresis_area.value, lost, 0.01 * energy) << name(source) << stiffer;
    }
}

/// Attraction before repulsion: acceleration b sin(omega t) for half a period, then -c sin; with
/// c = b + v omega it leaves as fast as it came, and F_max = m* c, F_min = -m* b.
test::Path attractive_bounce(double b) {
  const double half = std::numbers::pi / omega, c = b + v * omega, faster = v + 2 * b / omega;
  return test::with_flight(v, 2 * half, v, [=](double t) -> Approach {
    const double s = std::sin(omega * t), k = std::cos(omega * t);
    if (t <= half) return {v * t + b / omega * (t - s / omega), v + b / omega * (1 - k), b * s};
    const double later = t - half;
    const double s2 = std::sin(omega * later), k2 = std::cos(omega * later);
    return {faster * half - b / omega * half + faster * later - c / omega * (later - s2 / omega),
            faster - c / omega * (1 - k2), -c * s2};
  });
}

TEST(ForceCurve, ForceMinimumDuringLoading) {
  constexpr double b = 0.1;
  for (const ForceSource source : sources) {
    const ForceCurve curve = curve_of(attractive_bounce(b), source, -8, 40, 0.1);
    EXPECT_NEAR(curve.force_min_loading.value, -mass * b, 1e-3 * mass * b) << name(source);
    EXPECT_NEAR(curve.force_max.value, mass * (b + v * omega), 1e-3 * mass * b) << name(source);
    EXPECT_EQ(curve.cycles.size(), 1u);
  }
}

TEST(ForceCurve, SeriesAreThoseOfTheMotion) {
  const auto path = test::elastic_bounce(v, omega);
  const auto times = even_times(-8, 25, 0.25);
  const RelativeMotion motion = head_on(times, path, radii, mass);
  const ForceCurve curve = force_curve(motion, ForceSource::forces, Units::lj, radii);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Approach at = path(times[i]);
    EXPECT_NEAR(curve.delta[i], at.delta, 1e-14 * radii);  // rounding of X
    EXPECT_NEAR(curve.distance[i], radii - at.delta, 1e-14 * radii);
    EXPECT_NEAR(curve.speed[i], at.speed, 1e-15);
    EXPECT_NEAR(curve.force[i], -mass * at.acceleration, 1e-15);
  }
}

TEST(ForceCurve, PhasesFollowEachOther) {
  const auto times = even_times(-8, 25, 0.25);
  const ForceCurve curve =
      curve_of(test::elastic_bounce(v, omega), ForceSource::forces, -8, 25, 0.25);
  // Contact counts from 1 % of the greatest force on: sin(omega t) = 0.01, 0.04 after touch.
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double t = times[i], end = std::numbers::pi / omega;
    const Phase expected = t < 0.04         ? Phase::approach
                           : t < 0.5 * end  ? Phase::loading
                           : t < end - 0.04 ? Phase::unloading
                                            : Phase::separated;
    if (std::abs(t - 0.5 * end) < 0.25) continue;  // the turn's own frame
    EXPECT_EQ(curve.phase[i], expected) << t;
  }
}

TEST(ForceCurve, ShortDumpsAreUnresolved) {
  const auto path = test::elastic_bounce(v, omega);
  const ForceCurve loading = curve_of(path, ForceSource::forces, -2, 5, 0.25);
  EXPECT_TRUE(loading.contact);
  EXPECT_TRUE(loading.cycles.empty());
  EXPECT_EQ(loading.outcome, Outcome::unresolved);
  const ForceCurve unloading = curve_of(path, ForceSource::forces, -2, 9, 0.25);
  EXPECT_EQ(unloading.cycles.size(), 1u);
  EXPECT_EQ(unloading.outcome, Outcome::unresolved);
}

TEST(ForceCurve, ScalesWithPowersOfTwo) {
  const RelativeMotion motion =
      head_on(even_times(-8, 25, 0.25), test::plastic_bounce(v, omega, 2 * omega), radii, mass);
  RelativeMotion scaled = motion;
  constexpr double m = 0x1p-80, l = 0x1p-30, t = 0x1p-35;
  for (double& time : scaled.times) time *= t;
  scaled.reduced_mass *= m;
  scaled.position *= l;
  scaled.velocity *= l / t;
  scaled.acceleration *= l / (t * t);
  for (const ForceSource source : sources) {
    const ForceCurve a = force_curve(motion, source, Units::si, radii);
    const ForceCurve b = force_curve(scaled, source, Units::si, radii * l);
    EXPECT_EQ(a.force_max.value * (m * l / (t * t)), b.force_max.value) << name(source);
    EXPECT_EQ(*a.force_max.error * (m * l / (t * t)), *b.force_max.error) << name(source);
    EXPECT_EQ(a.hysteresis_area.value * (m * l * l / (t * t)), b.hysteresis_area.value);
    EXPECT_EQ(a.delta_max.value * l, b.delta_max.value);
    EXPECT_EQ(a.phase, b.phase);
  }
}

TEST(ForceCurve, NoiseDoesNotHideTheBounce) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0, 0.01 * omega * v);
    RelativeMotion motion =
        head_on(even_times(-30, 40, 0.25), test::elastic_bounce(v, omega), radii, mass);
    for (double& a : motion.acceleration.reshaped()) a += noise(random);
    const ForceCurve curve = force_curve(motion, ForceSource::forces, Units::lj, radii);
    EXPECT_EQ(curve.outcome, Outcome::bounce) << seed;
    EXPECT_EQ(curve.phase[40], Phase::approach) << seed;  // 20 before touch
  }
}

TEST(ForceTable, HasTheColumnsThatAreKnown) {
  RelativeMotion motion =
      head_on(even_times(-8, 25, 0.25), test::elastic_bounce(v, omega), radii, mass);
  const std::vector<double> rows(motion.steps.size());
  Table bodies;
  for (const char* name : {"x1", "y1"}) bodies.add_column({name, dimension::length}, rows);
  bodies.add_column({"mass1", dimension::mass}, rows);
  const auto names = [&] {
    const ForceCurve curve = force_curve(motion, ForceSource::forces, Units::lj, radii);
    std::string text;
    const Table table = force_table(curve, motion, bodies);
    for (const ColumnSpec& column : table.columns()) text += column.name + " ";
    return text;
  };
  EXPECT_EQ(names(), "step time X delta v F F_error phase x1 y1 ");
  motion.times.clear();
  motion.velocity.resize(3, 0);
  EXPECT_EQ(names(), "step X delta F F_error phase x1 y1 ");
}

}  // namespace
}  // namespace mdana
