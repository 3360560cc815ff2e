// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/observed_collision.hpp"

#include <algorithm>

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
