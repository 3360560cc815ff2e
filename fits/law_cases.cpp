// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/law_cases.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "readers/known_answer.hpp"

namespace mdana {

CaseParameters with(CaseParameters p,
                    std::initializer_list<std::pair<const std::string, double>> changes) {
  for (const auto& [name, value] : changes) p[name] = value;
  return p;
}

const std::map<std::string_view, CaseParameters>& base_cases() {
  static const CaseParameters sphere{{"R", 147}, {"m", 14434147}, {"E", 65.5}, {"v", 0.125}};
  const auto sphere_with = [](CaseParameters more) {
    more.insert(sphere.begin(), sphere.end());
    return more;
  };
  const CaseParameters krijt{{"gamma", 3.17}, {"nu", 0.25}, {"T_vis", 0.075}, {"spacing", 1.091}};
  CaseParameters plastic = krijt;
  plastic["v_Y"] = 0.0625;
  static const std::map<std::string_view, CaseParameters> cases{
      {"hertz", sphere},
      {"viscous-hertz", sphere_with({{"nu", 0.25}, {"T_vis", 0.075}})},
      {"jkr", sphere_with({{"gamma", 3.17}})},
      {"dmt", sphere_with({{"gamma", 3.17}})},
      {"thornton", sphere_with({{"v_Y", 0.0625}})},
      {"andrews", sphere_with({{"Y", 5}})},
      {"krijt", sphere_with(krijt)},
      {"krijt-plastic", sphere_with(plastic)},
      {"stress", sphere_with({{"gamma", 3.17},
                              {"nu", 0.25},
                              {"C", 2.1e-4},
                              {"B", 6.2},
                              {"zeta", 4},
                              {"spacing", 1.091}})},
      {"power", sphere_with({{"gamma", 3.17}, {"D", 118}, {"alpha", 3}, {"beta", 1.5}})}};
  return cases;
}

Collision Catalogue::run(std::string_view law, const CaseParameters& p, double tolerance) {
  const CollisionLaw* found = find_collision_law(law);
  if (!found) return {};
  std::vector<NamedValue> given;
  for (const auto& [name, value] : p) given.push_back({name, fmt::format("{}", value)});
  const Collision c = collide(*found, collision_input(*found, given), {.tolerance = tolerance});
  evaluations_ += c.evaluations;
  seconds_ += c.seconds;
  unresolved_ = unresolved_ || c.outcome == CollisionOutcome::unresolved;
  return c;
}

void Catalogue::add(std::string_view law, std::string what, double computed, double exact,
                    double needed) {
  LawCase c{law, std::move(what), computed, exact, needed, 0, unresolved_, evaluations_, seconds_};
  if (std::isfinite(computed)) c.digits = std::min(16.0, correct_digits({"", computed, exact, 0}));
  if (find_collision_law(law) && !std::isnan(exact)) cases.push_back(std::move(c));
  evaluations_ = 0;
  seconds_ = 0;
  unresolved_ = false;
}

void Catalogue::add_stick(std::string_view law, std::string what, const Collision& c) {
  const bool right = c.outcome != CollisionOutcome::bounce;
  add(law, std::move(what), right ? 0 : c.e, 0, 16);
}

}  // namespace mdana
