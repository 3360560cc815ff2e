// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/observed_collision.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

bool knows(const CollisionLaw& law, std::string_view name) {
  const auto impact = impact_parameters();
  return parameter_index(law, name) ||
         std::ranges::find(impact, name, &CollisionParameter::name) != impact.end();
}

}  // namespace

void give_both(std::vector<NamedNumber>& given, const std::string& name, double first, double second) {
  if (!(first > 0 && second > 0 && std::isfinite(first) && std::isfinite(second))) return;
  if (std::abs(first - second) <= 0.01 * std::max(first, second))
    return given.push_back({name, (first + second) / 2});
  given.push_back({name + "1", first});
  given.push_back({name + "2", second});
}

std::optional<double> ObservedCollision::find(std::string_view name) const {
  const auto at = std::ranges::find(given, name, &NamedNumber::name);
  if (at == given.end()) return std::nullopt;
  return at->value;
}

CollisionInput input_of(const CollisionLaw& law, const ObservedCollision& seen,
                        std::span<const NamedNumber> constants) try {
  std::vector<NamedValue> values;
  const auto give = [&](const NamedNumber& n) {
    if (knows(law, n.name)) values.push_back({n.name, fmt::format("{}", n.value)});
  };
  for (const NamedNumber& n : seen.given) give(n);
  for (const NamedNumber& n : constants)
    if (!seen.find(n.name)) give(n);
  return collision_input(law, values);
} catch (const InputError& error) {
  throw InputError(fmt::format("{}: {}", seen.place, error.what()));
}

}  // namespace mdana
