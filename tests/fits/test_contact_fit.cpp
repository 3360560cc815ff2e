// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "fits/contact_fit.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

using Parameters = std::map<std::string, double>;

std::vector<NamedNumber> numbers(const Parameters& p) {
  std::vector<NamedNumber> n;
  for (const auto& [name, value] : p) n.push_back({name, value});
  return n;
}

/// Units that multiply lengths, times and masses.
struct Scale {
  double length = 1, time = 1, mass = 1;
};

struct Study {
  std::vector<ObservedCollision> seen;
  std::vector<NamedNumber> constants;
};

/// P1's four radii and some of its velocities with gamma 3.17, E* 55: what the law predicts of them.
Study study(const CollisionLaw& law, const Parameters& truth, Parameters constants,
            const std::vector<double>& velocities, double error = 1e-3, Scale s = {}) {
  Study study{{}, numbers(constants)};
  for (const double R : {29.6, 58.9, 88.4, 147.0})
    for (const double v : velocities) {
      ObservedCollision o;
      o.given = {{"R", R * s.length}, {"m", 4.3633 * R * R * R * s.mass}, {"v", v * s.length / s.time}};
      o.place = "study";
      std::vector<NamedNumber> all = study.constants;
      for (const auto& [name, value] : truth) all.push_back({name, value});
      const Collision c = collide(law, input_of(law, o, all), {.tolerance = 1e-11});
      o.stuck = c.outcome == CollisionOutcome::stick;
      o.e = {o.stuck ? 0 : c.e, error};
      study.seen.push_back(o);
    }
  return study;
}

ContactFit fit(std::string_view law, const Study& study, std::vector<FreeParameter> free = {}, int starts = 4,
               Loss loss = Loss::none) {
  ContactFitSettings settings;
  const CollisionLaw& l = *find_collision_law(law);
  settings.free = free.empty() ? usual_free_parameters(l) : free;
  settings.constants = study.constants;
  settings.starts = starts;
  settings.loss = loss;
  return fit_contact(l, study.seen, settings);
}

FreeParameter one(const char* name) { return {name, {}, {}, {}, {}, false}; }

void expect_found(const ContactFit& fit, const Parameters& truth) {
  ASSERT_TRUE(fit.usable) << fit.reason;
  for (const Estimate& p : fit.parameters)
    EXPECT_NEAR(p.value, truth.at(p.name), 1e-6 * truth.at(p.name)) << p.name;
  EXPECT_LT(fit.chi2, 1e-6);
  EXPECT_GE(fit.digits, 6);
}

const Parameters adhesive{{"E", 65.5}, {"gamma", 3.17}, {"nu", 0.25}, {"spacing", 1.091}};
const std::vector<double> velocities{0.06, 0.1, 0.2, 0.4};

Parameters without(Parameters all, const char* name) {
  all.erase(name);
  return all;
}

Study exact(const char* law, const Parameters& truth, const Parameters& constants) {
  return study(*find_collision_law(law), truth, constants, velocities);
}

TEST(ContactFit, KrijtIsFoundAgain) {
  const Parameters truth{{"T_vis", 0.04}};
  expect_found(fit("krijt", exact("krijt", truth, adhesive)), truth);
}

TEST(ContactFit, StressIsFoundAgain) {
  const Parameters truth{{"C", 2.1e-4}, {"B", 6.2}, {"zeta", 4}};
  expect_found(fit("stress", exact("stress", truth, adhesive)), truth);
}

TEST(ContactFit, PowerIsFoundAgain) {
  const Parameters truth{{"D", 118}, {"alpha", 3}, {"beta", 1.5}};
  expect_found(fit("power", exact("power", truth, adhesive)), truth);
}

TEST(ContactFit, JkrIsFoundAgain) {
  const Parameters truth{{"gamma", 3.17}};
  expect_found(fit("jkr", exact("jkr", truth, without(adhesive, "gamma"))), truth);
}

TEST(ContactFit, ViscousHertzIsFoundAgain) {
  const Parameters truth{{"T_vis", 0.06}};
  expect_found(fit("viscous-hertz", exact("viscous-hertz", truth, {{"E", 65.5}, {"nu", 0.25}})), truth);
}

TEST(ContactFit, ThorntonIsFoundAgain) {
  const Parameters truth{{"v_Y", 0.05}};
  expect_found(fit("thornton", exact("thornton", truth, {{"E", 65.5}}), {one("v_Y")}), truth);
}

/// delta_max and t_max of andrews at velocities, errors 1 %, in any units.
Study andrews(const Parameters& truth, const std::vector<double>& at, Scale s = {}) {
  const CollisionLaw& law = *find_collision_law("andrews");
  Study study;
  for (const double v : at) {
    ObservedCollision o;
    o.given = {{"R", 25 * s.length}, {"m", 30000 * s.mass}, {"v", v * s.length / s.time}};
    o.place = "study";
    const Collision c = collide(law, input_of(law, o, numbers(truth)), {.tolerance = 1e-11});
    o.delta_max = {c.delta_max, 0.01 * c.delta_max};
    o.t_max = {c.t_max, 0.01 * c.t_max};
    study.seen.push_back(o);
  }
  return study;
}

// P2 eqs 24-30: E* and Y from delta_max and t_max, over velocities that span the yield velocity.
TEST(ContactFit, AndrewsIsFoundAgainFromCompressionAndTime) {
  const Parameters truth{{"E", 50}, {"Y", 6}};
  expect_found(fit("andrews", andrews(truth, {0.01, 0.02, 0.05, 0.1, 0.2, 0.4}), {one("E"), one("Y")}), truth);
}

// Ice grains in SI: lengths 1e-8, times 1e-12, masses 1e-25.
TEST(ContactFit, UnitsAreOfNoAccount) {
  const Scale si{1e-9, 1e-12, 1e-25};
  const double pressure = si.mass / (si.length * si.time * si.time);
  const Parameters constants{{"E", 65.5 * pressure}, {"gamma", 3.17 * si.mass / (si.time * si.time)},
                             {"nu", 0.25}, {"spacing", 1.091 * si.length}};
  const auto in_si = [&](const char* law, const Parameters& truth, const Parameters& given) {
    expect_found(fit(law, study(*find_collision_law(law), truth, given, velocities, 1e-3, si)), truth);
  };
  in_si("stress", {{"C", 2.1e-4 * si.time / si.length}, {"B", 6.2}, {"zeta", 4}}, constants);
  in_si("jkr", {{"gamma", constants.at("gamma")}}, without(constants, "gamma"));
  // D has the dimension of velocity^-alpha length^(2 - beta).
  in_si("power", {{"D", 118 * std::pow(si.length / si.time, -3) * std::sqrt(si.length)}, {"alpha", 3}, {"beta", 1.5}},
        constants);
  const Parameters krijt{{"T_vis", 0.04 * si.time}};
  expect_found(fit("krijt", study(*find_collision_law("krijt"), krijt, constants, velocities, 1e-3, si)), krijt);
  const Parameters plastic{{"E", 50 * pressure}, {"Y", 6 * pressure}};
  expect_found(fit("andrews", andrews(plastic, {0.01, 0.02, 0.05, 0.1, 0.2, 0.4}, si), {one("E"), one("Y")}), plastic);
}

TEST(ContactFit, OneValueForEachRadius) {
  const CollisionLaw& law = *find_collision_law("krijt");
  Study all = study(law, {{"T_vis", 0.02}}, adhesive, velocities);
  const Study other = study(law, {{"T_vis", 0.05}}, adhesive, velocities);
  for (std::size_t i = 8; i < 12; ++i) all.seen[i] = other.seen[i];  // R = 88.4
  FreeParameter each = one("T_vis");
  each.per_radius = true;
  all.seen.erase(all.seen.begin(), all.seen.begin() + 8);  // the two smallest mostly stick
  const ContactFit f = fit("krijt", all, {each});
  ASSERT_TRUE(f.usable) << f.reason;
  ASSERT_EQ(f.parameters.size(), 2u);
  EXPECT_NEAR(f.parameters[0].value, 0.05, 5e-8);
  EXPECT_NEAR(f.parameters[1].value, 0.02, 2e-8);
  EXPECT_EQ(f.parameters[0].full_name(), "T_vis(R=88.4)");
}

// Every tenth e is wrong by 0.2, 200 standard errors.
TEST(ContactFit, OutliersAreDamped) {
  const Parameters truth{{"T_vis", 0.04}};
  Study data = exact("krijt", truth, adhesive);
  for (std::size_t i = 5; i < data.seen.size(); i += 10) data.seen[i].e.value += 0.2, data.seen[i].stuck = false;
  const ContactFit plain = fit("krijt", data), cauchy = fit("krijt", data, {}, 4, Loss::cauchy);
  EXPECT_GT(std::abs(plain.parameters[0].value - 0.04), 1e-3);
  EXPECT_NEAR(cauchy.parameters[0].value, 0.04, 2e-4);
}

TEST(ContactFit, ABoundHolds) {
  FreeParameter T = one("T_vis");
  T.least = 0.05;
  T.greatest = 0.5;
  const ContactFit f = fit("krijt", exact("krijt", {{"T_vis", 0.04}}, adhesive), {T});
  EXPECT_FALSE(f.usable);
  EXPECT_NE(f.reason.find("lies on its bound"), std::string::npos) << f.reason;
}

// Only gamma^5/E*^2 enters the loss of JKR (physics: F_c delta0).
TEST(ContactFit, JkrOfBothSaysWhatIsKnown) {
  const Study data = exact("jkr", {{"gamma", 3.17}, {"E", 65.5}}, {});
  const ContactFit f = fit("jkr", data, {one("gamma"), one("E")});
  EXPECT_FALSE(f.usable);
  EXPECT_NE(f.reason.find("only gamma^5/E^2 is determined"), std::string::npos) << f.reason;
}

// A prior on one of them makes the other known.
TEST(ContactFit, APriorDeterminesWhatTheDataDoNot) {
  const Study data = exact("jkr", {{"gamma", 3.17}, {"E", 65.5}}, {});
  FreeParameter E = one("E");
  E.prior = Measured{65.5, 2};
  const ContactFit f = fit("jkr", data, {one("gamma"), E});
  ASSERT_TRUE(f.usable) << f.reason;
  EXPECT_NEAR(f.parameters[0].value, 3.17, 3e-4);
  EXPECT_NEAR(f.parameters[1].error, 2, 0.02);
  EXPECT_NEAR(f.parameters[0].error, 3.17 * 0.4 * 2 / 65.5, 5e-3);  // gamma ~ E^(2/5)
}

// Below v_Y nothing depends on Y.
TEST(ContactFit, AndrewsBelowYieldKnowsNothingOfY) {
  const ContactFit f =
      fit("andrews", andrews({{"E", 50}, {"Y", 20}}, {0.001, 0.002, 0.003}), {one("E"), one("Y")});
  EXPECT_FALSE(f.usable);
  EXPECT_NE(f.reason.find("only E is determined"), std::string::npos) << f.reason;
}

// Errors of 1 %: about the elastic law a Y at the edge of yield fits a greatest delta_max that is too large
// by chance, and far beyond yield any E that is great enough.
TEST(ContactFit, AndrewsInALimitKnowsOnlyOne) {
  for (const auto& [Y, says] : {std::pair{20.0, "the elastic limit (Y"}, {0.6, "the rigid plastic limit (E"}}) {
    Study data = andrews({{"E", 50}, {"Y", Y}}, {0.05, 0.1, 0.2, 0.4});
    data.seen.back().delta_max.value *= 1.015;
    const ContactFit f = fit("andrews", data, {one("E"), one("Y")});
    EXPECT_FALSE(f.usable);
    EXPECT_NE(f.reason.find(says), std::string::npos) << f.reason;
  }
}

// E is found from exact numbers, but within their errors it could be infinite.
TEST(ContactFit, AndrewsNearALimitSaysSo) {
  const ContactFit f = fit("andrews", andrews({{"E", 50}, {"Y", 2}}, {0.05, 0.1, 0.2, 0.4}), {one("E"), one("Y")});
  ASSERT_TRUE(f.usable) << f.reason;
  ASSERT_EQ(f.notes.size(), 1u);
  EXPECT_NE(f.notes[0].find("the rigid plastic limit (E infinite) describes the collisions as well"), std::string::npos);
}

// One velocity: t_max v/delta_max hardly depends on Y, so 1 % of it leaves everything open.
TEST(ContactFit, AndrewsAtOneVelocityIsNotUsable) {
  const ContactFit f =
      fit("andrews", andrews({{"E", 50}, {"Y", 6}}, {0.2, 0.2, 0.2, 0.2}), {one("E"), one("Y")});
  EXPECT_FALSE(f.usable);
  EXPECT_NE(f.reason.find("all collisions have v = 0.2"), std::string::npos) << f.reason;
}

TEST(ContactFit, StressAtOneVelocityIsNotUsable) {
  const Study data = study(*find_collision_law("stress"), {{"C", 2.1e-4}, {"B", 6.2}, {"zeta", 4}}, adhesive, {0.2}, 1e-2);
  const ContactFit f = fit("stress", data, {}, 2);
  EXPECT_FALSE(f.usable);
  EXPECT_NE(f.reason.find("all collisions have v = 0.2"), std::string::npos) << f.reason;
}

TEST(ContactFit, StickingAloneDeterminesNothing) {
  const Study data = study(*find_collision_law("krijt"), {{"T_vis", 0.04}}, adhesive, {0.001, 0.002});
  const ContactFit f = fit("krijt", data);
  EXPECT_FALSE(f.usable);
  EXPECT_EQ(f.reason, "every collision sticks: that bounds the parameters, but determines none");
}

TEST(ContactFit, WhatIsGivenCannotBeFree) {
  Study data = exact("krijt", {{"T_vis", 0.04}}, adhesive);
  for (auto& s : data.seen) s.given.push_back({"T_vis", 0.04});
  EXPECT_THROW(fit("krijt", data), InputError);
}

/// gamma of jkr, e seen with errors of 0.01.
ContactFit noisy(std::uint64_t seed, IntervalSettings intervals) {
  static const Study clean = exact("jkr", {{"gamma", 3.17}}, without(adhesive, "gamma"));
  Study data = clean;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, 0.01);
  for (ObservedCollision& s : data.seen)
    if (!s.stuck) s.e = {std::max(1e-3, s.e.value + noise(random)), 0.01};
  ContactFitSettings settings;
  settings.free = {one("gamma")};
  settings.constants = data.constants;
  settings.starts = 1;
  settings.intervals = intervals;
  return fit_contact(*find_collision_law("jkr"), data.seen, settings);
}

// For one parameter and small errors the cost is a parabola: both ends lie one standard error away.
TEST(ContactFit, ProfilesOfSmallErrorsAreTheStandardErrors) {
  IntervalSettings intervals;
  intervals.profile = true;
  const Estimate p = noisy(7, intervals).parameters.at(0);
  EXPECT_NEAR(p.profile.high - p.value, p.error, 0.05 * p.error);
  EXPECT_NEAR(p.value - p.profile.low, p.error, 0.05 * p.error);
}

// 68.3 % of 20 intervals: 13.7 +- 2.1; outside 7 to 19 once in a thousand.
TEST(ContactFit, IntervalsCoverTheTruth) {
  IntervalSettings intervals;
  intervals.profile = true;
  int covered = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Estimate p = noisy(seed, intervals).parameters.at(0);
    covered += p.profile.low <= 3.17 && 3.17 <= p.profile.high;
  }
  EXPECT_GE(covered, 7);
  EXPECT_LE(covered, 19);
}

TEST(ContactFit, BootstrapIsRepeatable) {
  IntervalSettings intervals;
  intervals.draws = 50;
  const ContactFit a = noisy(3, intervals), b = noisy(3, intervals);
  ASSERT_EQ(a.draws, 50u);
  EXPECT_EQ(a.parameters[0].bootstrap.low, b.parameters[0].bootstrap.low);
  EXPECT_LT(a.parameters[0].bootstrap.low, a.parameters[0].bootstrap.high);
  intervals.seed = 2;
  EXPECT_NE(a.parameters[0].bootstrap.low, noisy(3, intervals).parameters[0].bootstrap.low);
}

}  // namespace
}  // namespace mdana
