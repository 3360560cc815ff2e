// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/force_law.hpp"

namespace mdana {

const ForceLaw* find_force_law(std::string_view name) {
  for (const ForceLaw* law : force_laws())
    if (law->name == name) return law;
  return nullptr;
}

}  // namespace mdana
