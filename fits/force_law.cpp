// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/force_law.hpp"

#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {

const ForceLaw* find_force_law(std::string_view name) {
  for (const ForceLaw* law : force_laws())
    if (law->name == name) return law;
  return nullptr;
}

const ForceBranch& unloading(const ForceLaw& law) {
  return law.unloading ? *law.unloading : law;
}

void require_parameters(const ForceLaw& law, const ElasticContact& contact) {
  for (const ContactParameter& p : law.parameters) {
    const double value = contact.*p.value;
    if (std::isfinite(value) && (value > 0 || (p.zero_allowed && value == 0))) continue;
    throw InputError(fmt::format("law {}: {} = {:g}: a finite number {} is needed ({})", law.name,
                                 p.name, value, p.zero_allowed ? "of at least 0" : "greater than 0",
                                 p.meaning));
  }
}

}  // namespace mdana
