// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/viscous_contact.hpp"

namespace mdana {
namespace {

constexpr std::array parameters{parameter::gamma};

/// e in closed form, e^2 = 1 - 1.5444810 F_c delta_0/(m* v^2).
Collision collide_jkr(const CollisionInput& input, const CollisionSettings& settings) {
  const LawInput in(input);
  return collide_viscous(
      in, {.gamma = in.values[0], .nu = 1, .T_vis = 0, .T_crack = {}, .stress = {}}, settings);
}

}  // namespace

extern const CollisionLaw jkr_collision;
const CollisionLaw jkr_collision{"jkr", "elastic spheres with short-range adhesion", parameters,
                                 collide_jkr};

}  // namespace mdana
