// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "fits/contact_fit.hpp"

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

ContactFit fit(std::string_view law, const Study& study, std::vector<FreeParameter> free = {}, int starts = 4) {
  ContactFitSettings settings;
  const CollisionLaw& l = *find_collision_law(law);
  settings.free = free.empty() ? usual_free_parameters(l) : free;
  settings.constants = study.constants;
  settings.starts = starts;
  return fit_contact(l, study.seen, settings);
}

void expect_found(const ContactFit& fit, const Parameters& truth) {
  ASSERT_TRUE(fit.usable) << fit.reason;
  for (const Estimate& p : fit.parameters)
    EXPECT_NEAR(p.value, truth.at(p.name), 1e-6 * truth.at(p.name)) << p.name;
  EXPECT_LT(fit.chi2, 1e-6);
  EXPECT_GE(fit.digits, 6);
}

const Parameters adhesive{{"E", 65.5}, {"gamma", 3.17}, {"nu", 0.25}, {"spacing", 1.091}};
const std::vector<double> velocities{0.06, 0.1, 0.2, 0.4};

TEST(ContactFit, KrijtIsFoundAgain) {
  const Parameters truth{{"T_vis", 0.04}};
  expect_found(fit("krijt", study(*find_collision_law("krijt"), truth, adhesive, velocities)), truth);
}

TEST(ContactFit, StressIsFoundAgain) {
  const Parameters truth{{"C", 2.1e-4}, {"B", 6.2}, {"zeta", 4}};
  expect_found(fit("stress", study(*find_collision_law("stress"), truth, adhesive, velocities)), truth);
}

TEST(ContactFit, PowerIsFoundAgain) {
  const Parameters truth{{"D", 118}, {"alpha", 3}, {"beta", 1.5}};
  expect_found(fit("power", study(*find_collision_law("power"), truth, adhesive, velocities)), truth);
}

TEST(ContactFit, JkrIsFoundAgain) {
  Parameters constants = adhesive;
  constants.erase("gamma");
  const Parameters truth{{"gamma", 3.17}};
  expect_found(fit("jkr", study(*find_collision_law("jkr"), truth, constants, velocities)), truth);
}

// Only gamma^5/E*^2 enters the loss of JKR (physics: F_c delta0).
TEST(ContactFit, JkrOfBothSaysWhatIsKnown) {
  const Study data = study(*find_collision_law("jkr"), {{"gamma", 3.17}, {"E", 65.5}}, {}, velocities);
  const ContactFit f = fit("jkr", data, {{"gamma"}, {"E"}});
  EXPECT_FALSE(f.usable);
  EXPECT_NE(f.reason.find("only gamma^5/E^2 is determined"), std::string::npos) << f.reason;
}

}  // namespace
}  // namespace mdana
