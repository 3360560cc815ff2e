// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fits/force_law.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

[[noreturn]] void refuse(const ForceLaw& law, std::string_view what) {
  throw InputError(fmt::format("law {}: {}", law.name, what));
}

/// As users give it: R for R*, which is that of each of two equal spheres, or R1 and R2.
std::vector<std::string_view> given_names(const ForceLaw& law) {
  std::vector<std::string_view> names{"R", "R1", "R2"};
  for (const ContactParameter& p : law.parameters)
    if (p.value != &ElasticContact::radius) names.push_back(given_name(p));
  return names;
}

void check_names(const ForceLaw& law, std::span<const NamedValue> given) {
  const auto names = given_names(law);
  for (const NamedValue& g : given) {
    if (std::find(names.begin(), names.end(), g.name) == names.end())
      refuse(law, fmt::format("it has no parameter {}; its parameters are {}", g.name,
                              fmt::join(names, ", ")));
    if (std::count_if(given.begin(), given.end(), [&](auto& o) { return o.name == g.name; }) > 1)
      refuse(law, fmt::format("parameter {} is given twice", g.name));
  }
}

/// Within what two of its kind can be reduced and multiplied without leaving double precision.
double value_of(const ForceLaw& law, const NamedValue& g) {
  double value = 0;
  const char* end = g.text.data() + g.text.size();
  const auto [rest, error] = std::from_chars(g.text.data(), end, value);
  if (error == std::errc::invalid_argument || rest != end)
    refuse(law, fmt::format("{}={}: not a number", g.name, g.text));
  const bool zero_allowed = g.name == "gamma", wall = g.name == "R2" && value > 0;
  const bool inside = value >= 1e-100 && value <= 1e100;
  if (error != std::errc{} ||
      !(inside || (zero_allowed && value == 0) || (wall && std::isinf(value))))
    refuse(law, fmt::format("{}={}: a number from 1e-100 to 1e100{} is needed", g.name, g.text,
                            zero_allowed     ? ", or 0,"
                            : g.name == "R2" ? ", or inf,"
                                             : ""));
  return value;
}

const NamedValue* find(std::span<const NamedValue> given, std::string_view name) {
  const auto at = std::find_if(given.begin(), given.end(), [&](auto& g) { return g.name == name; });
  return at == given.end() ? nullptr : &*at;
}

double radius_of(const ForceLaw& law, std::span<const NamedValue> given) {
  const NamedValue *equal = find(given, "R"), *one = find(given, "R1"), *other = find(given, "R2");
  if (equal ? one || other : !(one && other))
    refuse(law, "either R, for equal spheres, or R1 and R2 must be given");
  return equal ? value_of(law, *equal) / 2 : reduced(value_of(law, *one), value_of(law, *other));
}

}  // namespace

std::string_view given_name(const ContactParameter& parameter) {
  return parameter.name.substr(0, parameter.name.find('*'));
}

ElasticContact elastic_contact(const ForceLaw& law, std::span<const NamedValue> given) {
  check_names(law, given);
  ElasticContact contact;
  contact.radius = radius_of(law, given);
  for (const ContactParameter& p : law.parameters) {
    if (p.value == &ElasticContact::radius) continue;
    const NamedValue* g = find(given, given_name(p));
    if (!g) refuse(law, fmt::format("parameter {} is missing: {}", given_name(p), p.meaning));
    contact.*p.value = value_of(law, *g);
  }
  require_parameters(law, contact);
  return contact;
}

}  // namespace mdana
