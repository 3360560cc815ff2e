// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "fits/force_fit.hpp"
#include "readers/input_error.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

constexpr double radius = 29.6;

ElasticContact truth() {
  ElasticContact c;
  c.radius = radius / 2;
  c.modulus = 53.2;
  c.surface_energy = 3.17;
  c.yield_strength = 8;
  c.spacing = 1.091;
  return c;
}

/// A head-on collision with forces by the law: delta up to `delta_max` and back, relative noise of the
/// greatest force.
ForceData data_of(const ForceLaw& law, double noise = 0, double scale = 1) {
  constexpr std::size_t frames = 120;
  constexpr double delta_max = 2;
  ForceData d;
  d.turn = frames / 2;
  d.radius_sum = 2 * radius * scale;
  d.reduced_radius = radius / 2 * scale;
  ElasticContact c = truth();
  c.delta_max = delta_max;
  const double greatest = law.force(delta_max, c);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i <= frames; ++i) {
    const double delta = delta_max * std::sin(3.141592653589793 * static_cast<double>(i) / frames);
    const double f = i > d.turn ? unloading(law).force(delta, c) : law.force(delta, c);
    d.distance.push_back((2 * radius - delta) * scale);
    d.force.push_back((f + noise * greatest * normal(random)) * scale);
    d.error.push_back((noise > 0 ? noise : 1e-6) * greatest * scale);
  }
  return d;
}

double value_of(const ForceEstimate& e) {
  const ElasticContact c = truth();
  if (e.name == "R") return radius;
  if (e.name == "E*") return c.modulus;
  if (e.name == "gamma") return c.surface_energy;
  return e.name == "Y" ? c.yield_strength : c.spacing;
}

ForceFitSettings settings(std::vector<std::string> free, ForcePart part) {
  ForceFitSettings s;
  s.free = std::move(free);
  s.constants = truth();
  s.part = part;
  return s;
}

void expect_found(const char* law, std::vector<std::string> free, ForcePart part) {
  const ForceLaw& l = *find_force_law(law);
  const ForceFit f = fit_force(l, data_of(l), settings(std::move(free), part));
  ASSERT_TRUE(f.fit.usable) << law << ": " << f.fit.reason;
  for (const ForceEstimate& e : f.parameters)
    EXPECT_NEAR(e.value, value_of(e), 1e-6 * value_of(e)) << law << " " << e.name;
}

TEST(ForceFit, ExactDataGiveTheParametersBack) {
  expect_found("hertz", {"E*", "R"}, ForcePart::loading);
  expect_found("dmt", {"E*", "gamma", "R"}, ForcePart::loop);
  expect_found("jkr", {"E*", "gamma", "R"}, ForcePart::loading);
  expect_found("jkr", {"E*", "gamma"}, ForcePart::loop);
  expect_found("maugis", {"E*", "gamma", "R"}, ForcePart::loading);
  expect_found("andrews", {"E*", "Y", "R"}, ForcePart::loop);
  expect_found("thornton", {"E*", "Y"}, ForcePart::loop);
}

// Lengths in metres: nothing in the fit has a scale of its own.
TEST(ForceFit, ScaleOfLengthsDoesNotMatter) {
  const ForceLaw& l = *find_force_law("jkr");
  const double scale = std::ldexp(1.0, -33);  // about 1e-10
  ForceData d = data_of(l, 0, scale);
  ForceFitSettings s = settings({"E*", "R"}, ForcePart::loading);
  // F/L and X/L as before: E* L^2/L = E*/L, gamma stays.
  s.constants.surface_energy = 3.17;
  const ForceFit f = fit_force(l, d, s);
  ASSERT_TRUE(f.fit.usable) << f.fit.reason;
  EXPECT_NEAR(f.parameters[0].value, 53.2 / scale, 1e-6 * 53.2 / scale);
  EXPECT_NEAR(f.parameters[1].value, radius * scale, 1e-6 * radius * scale);
}

// With noise of known size the truth lies within three stated errors (99.7 % each; the draw is fixed), and
// the errors are small enough to mean something.
TEST(ForceFit, ErrorsCoverTheTruth) {
  const ForceLaw& l = *find_force_law("jkr");
  const ForceFit f = fit_force(l, data_of(l, 0.01), settings({"E*", "gamma", "R"}, ForcePart::loading));
  ASSERT_TRUE(f.fit.usable) << f.fit.reason;
  for (const ForceEstimate& e : f.parameters) {
    EXPECT_LT(std::abs(e.value - value_of(e)), 3 * e.error) << e.name;
    EXPECT_LT(e.error, 0.2 * e.value) << e.name;
  }
}

TEST(ForceFit, OffsetIsFoundAtGivenRadii) {
  const ForceLaw& l = *find_force_law("jkr");
  ForceData d = data_of(l);
  for (double& x : d.distance) x += 0.05;
  const ForceFit f = fit_force(l, d, settings({"E*", "offset"}, ForcePart::loading));
  ASSERT_TRUE(f.fit.usable) << f.fit.reason;
  EXPECT_NEAR(f.parameters[0].value, 53.2, 1e-5);
  EXPECT_NEAR(f.parameters[1].value, 0.05, 1e-7);
}

TEST(ForceFit, RefusesWhatCannotBeKnown) {
  const ForceLaw& l = *find_force_law("jkr");
  EXPECT_INPUT_ERROR(fit_force(l, data_of(l), settings({"E*", "R", "offset"}, ForcePart::loading)),
                     "R and offset", "fix one");
  EXPECT_INPUT_ERROR(fit_force(l, data_of(l), settings({"E*", "Y"}, ForcePart::loading)), "law jkr",
                     "no free parameter Y");
  ForceData few = data_of(l);
  few.turn = 1;
  EXPECT_INPUT_ERROR(fit_force(l, few, settings({"E*", "gamma", "R"}, ForcePart::loading)),
                     "frames of contact", "Dump more often");
  ForceData wrong = data_of(l);
  wrong.force[3] = std::nan("");
  EXPECT_INPUT_ERROR(fit_force(l, wrong, settings({"E*"}, ForcePart::loading)), "frame 3", "not finite");
}

// Below yield Andrews is Hertz: nothing is known of Y.
TEST(ForceFit, ParameterThatDoesNotActIsNamed) {
  const ForceLaw& l = *find_force_law("andrews");
  ForceFitSettings s = settings({"E*", "Y"}, ForcePart::loading);
  ForceData d = data_of(*find_force_law("hertz"));
  const ForceFit f = fit_force(l, d, s);
  EXPECT_FALSE(f.fit.usable);
  EXPECT_NE(f.fit.reason.find("only E* is determined"), std::string::npos) << f.fit.reason;
}

}  // namespace
}  // namespace mdana
