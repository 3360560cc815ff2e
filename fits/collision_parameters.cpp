// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fits/collision_law.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// Optional here: which of them go together is checked by impact_of.
constexpr std::array<CollisionParameter, 9> impact_table{{
    {"R", "radius of each of two equal spheres", dimension::length, 0, false, 1e300, not_given},
    {"R1", "radius of one sphere", dimension::length, 0, false, 1e300, not_given},
    {"R2", "radius of the other; inf: a wall", dimension::length, 0, false, infinity, not_given},
    {"m", "mass of each of two equal spheres", dimension::mass, 0, false, 1e300, not_given},
    {"m1", "mass of one sphere", dimension::mass, 0, false, 1e300, not_given},
    {"m2", "mass of the other; inf: a wall", dimension::mass, 0, false, infinity, not_given},
    {"rho", "density of both, instead of masses", Dimension{1, -3, 0}, 0, false, 1e300, not_given},
    {"E", "reduced modulus E*, 1/E* = sum (1 - nu^2)/E", dimension::pressure, 0, false, 1e300, {}},
    {"v", "relative velocity at delta = 0", dimension::velocity, 0, false, 1e300, {}},
}};

[[noreturn]] void refuse(const CollisionLaw& law, std::string_view what) {
  throw InputError(fmt::format("law {}: {}", law.name, what));
}

std::string range_text(const CollisionParameter& p) {
  std::string text = fmt::format("a number {} {:g}", p.least_allowed ? "of at least" : "greater than",
                                 p.least);
  if (p.greatest < 1e300) text += fmt::format(" and at most {:g}", p.greatest);
  if (p.greatest == infinity) text += ", or inf";
  return text + " is needed";
}

bool admissible(const CollisionParameter& p, double value) {
  return (value > p.least || (p.least_allowed && value == p.least)) && value <= p.greatest;
}

double word_value(const CollisionLaw& law, const CollisionParameter& p, const std::string& text) {
  const auto word = std::find(p.words.begin(), p.words.end(), text);
  if (word == p.words.end())
    refuse(law, fmt::format("{}={}: one of {} is needed", p.name, text, fmt::join(p.words, ", ")));
  return static_cast<double>(word - p.words.begin());
}

double value_of(const CollisionLaw& law, const CollisionParameter& p, const std::string& text) {
  if (!p.words.empty()) return word_value(law, p, text);
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::result_out_of_range || (error == std::errc{} && rest == end)) {
    if (error == std::errc{} && admissible(p, value)) return value;
    refuse(law, fmt::format("{}={}: {}", p.name, text, range_text(p)));
  }
  refuse(law, fmt::format("{}={}: not a number", p.name, text));
}

void check_names(const CollisionLaw& law, std::span<const NamedValue> given) {
  std::vector<std::string_view> names;
  for (const CollisionParameter& p : impact_parameters()) names.push_back(p.name);
  for (const CollisionParameter& p : law.parameters) names.push_back(p.name);
  for (const NamedValue& g : given) {
    if (std::find(names.begin(), names.end(), g.name) == names.end())
      refuse(law, fmt::format("it has no parameter {}; its parameters are {}", g.name,
                              fmt::join(names, ", ")));
    if (std::count_if(given.begin(), given.end(), [&](auto& o) { return o.name == g.name; }) > 1)
      refuse(law, fmt::format("parameter {} is given twice", g.name));
  }
}

bool has(std::span<const NamedValue> given, std::string_view name) {
  return std::any_of(given.begin(), given.end(), [&](auto& g) { return g.name == name; });
}

std::vector<double> values_of(const CollisionLaw& law,
                              std::span<const CollisionParameter> parameters,
                              std::span<const NamedValue> given) {
  std::vector<double> values;
  for (const CollisionParameter& p : parameters) {
    const auto at = std::find_if(given.begin(), given.end(), [&](auto& g) { return g.name == p.name; });
    if (!p.instead.empty() && (at != given.end()) == has(given, p.instead))
      refuse(law, fmt::format("either {} or {} must be given, not both", p.name, p.instead));
    if (at != given.end())
      values.push_back(value_of(law, p, at->text));
    else if (p.instead.empty() && !p.fallback)
      refuse(law, fmt::format("parameter {} is missing: {}", p.name, p.meaning));
    else
      values.push_back(p.fallback.value_or(not_given));
  }
  return values;
}

/// Both of a pair, from the name for equal ones or the two names. Throws InputError.
std::array<double, 2> both(const CollisionLaw& law, std::string_view name,
                           std::span<const double> v) {
  const bool equal = !std::isnan(v[0]), first = !std::isnan(v[1]), second = !std::isnan(v[2]);
  if (equal ? first || second : !(first && second))
    refuse(law, fmt::format("either {0}, for equal spheres, or {0}1 and {0}2 must be given", name));
  return equal ? std::array{v[0], v[0]} : std::array{v[1], v[2]};
}

double mass_of(double density, double radius) {
  return 4.0 / 3.0 * std::numbers::pi * density * radius * radius * radius;
}

Impact impact_of(const CollisionLaw& law, std::span<const NamedValue> given) {
  const std::vector<double> v = values_of(law, impact_parameters(), given);
  const std::span<const double> all(v);
  const std::array<double, 2> radii = both(law, "R", all.subspan(0, 3));
  const double density = v[6];
  const bool masses = !(std::isnan(v[3]) && std::isnan(v[4]) && std::isnan(v[5]));
  if (masses && !std::isnan(density)) refuse(law, "masses and rho are given; one is enough");
  if (!masses && std::isnan(density))
    refuse(law, "parameter m is missing (or m1 and m2, or the density rho)");
  const std::array<double, 2> m =
      masses ? both(law, "m", all.subspan(3, 3))
             : std::array{mass_of(density, radii[0]), mass_of(density, radii[1])};
  if (std::isinf(m[0])) refuse(law, "m1: only m2 can be infinite");
  return {reduced(radii[0], radii[1]), reduced(m[0], m[1]), v[7], v[8]};
}

}  // namespace

double reduced(double a, double b) {
  const double less = std::min(a, b), more = std::max(a, b);
  return less / (1 + less / more);
}

std::span<const CollisionParameter> impact_parameters() { return impact_table; }

CollisionInput collision_input(const CollisionLaw& law, std::span<const NamedValue> given) {
  check_names(law, given);
  return {impact_of(law, given), values_of(law, law.parameters, given)};
}

}  // namespace mdana
