// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/collision_law.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace mdana {

std::string_view name(CollisionOutcome outcome) {
  switch (outcome) {
    case CollisionOutcome::bounce: return "bounce";
    case CollisionOutcome::stick: return "stick";
    case CollisionOutcome::unresolved: break;
  }
  return "unresolved";
}

double Collision::digits() const {
  if (std::isnan(e_error)) return 0;
  if (e_error == 0) return 16;
  return std::clamp(-std::log10(e_error / (e > 0 ? e : 1)), 0.0, 16.0);
}

const CollisionLaw* find_collision_law(std::string_view name) {
  for (const CollisionLaw* law : collision_laws())
    if (law->name == name) return law;
  return nullptr;
}

std::optional<std::size_t> parameter_index(const CollisionLaw& law, std::string_view name) {
  for (std::size_t k = 0; k < law.parameters.size(); ++k)
    if (law.parameters[k].name == name) return k;
  return std::nullopt;
}

Collision collide(const CollisionLaw& law, const CollisionInput& input,
                  const CollisionSettings& settings) {
  const auto start = std::chrono::steady_clock::now();
  Collision collision = law.collide(input, settings);
  collision.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return collision;
}

}  // namespace mdana
