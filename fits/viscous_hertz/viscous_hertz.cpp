// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/viscous_contact.hpp"

namespace mdana {
namespace {

constexpr std::array parameters{parameter::nu, parameter::T_vis};

Collision collide_viscous_hertz(const CollisionInput& input, const CollisionSettings& settings) {
  const LawInput in(input);
  return collide_viscous(
      in, {.gamma = 0, .nu = in.values[0], .T_vis = in.values[1], .T_crack = {}, .stress = {}},
      settings);
}

}  // namespace

extern const CollisionLaw viscous_hertz_collision;
const CollisionLaw viscous_hertz_collision{"viscous-hertz",
                                           "spheres without adhesion, with bulk dissipation",
                                           parameters, collide_viscous_hertz};

}  // namespace mdana
