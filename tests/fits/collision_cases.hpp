// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "fits/collision_law.hpp"

namespace mdana::test {

using Values = std::map<std::string, std::string>;

inline const CollisionLaw& law_of(std::string_view name) {
  const CollisionLaw* law = find_collision_law(name);
  if (!law) throw std::runtime_error(fmt::format("no law {}", name));
  return *law;
}

/// The sphere of P1's Table II with R = 147 at v = 0.1, with changes; an empty value leaves one
/// out.
inline CollisionInput sphere(std::string_view law, const Values& changes) {
  Values all{{"R", "147"}, {"m", "14434147"}, {"E", "65.5"}, {"v", "0.1"}};
  for (const auto& [name, value] : changes) all[name] = value;
  std::vector<NamedValue> given;
  for (const auto& [name, value] : all)
    if (!value.empty()) given.push_back({name, value});
  return collision_input(law_of(law), given);
}

inline const Values& parameters_of(std::string_view law) {
  static const std::map<std::string_view, Values> all{
      {"hertz", {}},
      {"viscous-hertz", {{"nu", "0.25"}, {"T_vis", "0.075"}}},
      {"jkr", {{"gamma", "3.17"}}},
      {"krijt", {{"gamma", "3.17"}, {"nu", "0.25"}, {"T_vis", "0.075"}}},
      {"krijt-plastic", {{"gamma", "3.17"}, {"nu", "0.25"}, {"T_vis", "0.075"}, {"v_Y", "0.07"}}},
      {"stress", {{"gamma", "3.17"}, {"nu", "0.25"}, {"C", "2.1e-4"}, {"B", "6.2"}, {"zeta", "4"}}},
      {"power", {{"gamma", "3.17"}, {"D", "118"}, {"alpha", "3"}, {"beta", "1.5"}}}};
  return all.at(law);
}

inline const std::vector<std::string>& laws_here() {
  static const std::vector<std::string> names{"hertz",         "viscous-hertz", "jkr",  "krijt",
                                              "krijt-plastic", "stress",        "power"};
  return names;
}

}  // namespace mdana::test
