// SPDX-License-Identifier: GPL-3.0-or-later
// How often intervals hold the truth: 200 draws of noise for a law in closed form.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "fits/contact_fit.hpp"

namespace mdana {
namespace {

constexpr int noises = 200;
constexpr double surface_energy = 3.17, error = 0.01;

/// P1's four radii at eight velocities above sticking by JKR, e with noise.
std::vector<ObservedCollision> seen(std::uint64_t seed) {
  const CollisionLaw& law = *find_collision_law("jkr");
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, error);
  std::vector<ObservedCollision> all;
  for (const double R : {29.6, 58.9, 88.4, 147.0})
    for (const double v : {0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.6}) {
      ObservedCollision o;
      o.given = {{"R", R}, {"m", 4.3633 * R * R * R}, {"E", 65.5}, {"v", v}};
      const std::vector<NamedNumber> truth{{"gamma", surface_energy}};
      o.e = {collide(law, input_of(law, o, truth)).e + noise(random), error};
      all.push_back(o);
    }
  return all;
}

void expect_rate(int covered) {  // 68.3 % of 200: 136.5 +- 6.6; four times that once in 15000
  EXPECT_GE(covered, 110);
  EXPECT_LE(covered, 163);
}

TEST(IntervalCoverage, IsTheStatedOne) {
  ContactFitSettings settings;
  settings.free = usual_free_parameters(*find_collision_law("jkr"));
  settings.starts = 1;
  settings.intervals.profile = true;
  settings.intervals.draws = 200;
  int by_error = 0, by_profile = 0, by_bootstrap = 0;
  for (int k = 0; k < noises; ++k) {
    const ContactFit fit = fit_contact(*find_collision_law("jkr"), seen(static_cast<std::uint64_t>(k)), settings);
    ASSERT_TRUE(fit.usable) << fit.reason;
    const Estimate& p = fit.parameters.at(0);
    by_error += std::abs(p.value - surface_energy) <= p.error;
    by_profile += p.profile.low <= surface_energy && surface_energy <= p.profile.high;
    by_bootstrap += p.bootstrap.low <= surface_energy && surface_energy <= p.bootstrap.high;
  }
  expect_rate(by_error);
  expect_rate(by_profile);
  expect_rate(by_bootstrap);
  RecordProperty("by_error", by_error);
  RecordProperty("by_profile", by_profile);
  RecordProperty("by_bootstrap", by_bootstrap);
}

}  // namespace
}  // namespace mdana
