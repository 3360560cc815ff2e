// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "fits/viscous_contact.hpp"

namespace mdana {
namespace {

constexpr std::array parameters{
    parameter::gamma,
    parameter::nu,
    CollisionParameter{
        "C", "T_vis at no pressure, over the radius", {0, -1, 1}, 0, true, 1e300, {}},
    CollisionParameter{"B", "of p_c/E* in T(p_c)", dimension::none, 0, true, 1e300, {}},
    CollisionParameter{"zeta", "power in T(p_c)", dimension::none, 0, false, 100, {}},
    parameter::T_crack,
    parameter::spacing,
    parameter::start};

/// P1 eqs 17, 18: T_vis = C R exp[(B p_c/E*)^zeta]; R = 2R*, the radius of each of two equal
/// spheres. T_crack, if given, is constant.
Collision collide_stress(const CollisionInput& input, const CollisionSettings& settings) {
  const LawInput in(input);
  const auto& v = in.values;
  ViscousContact contact{
      .gamma = v[0], .nu = v[1], .T_vis = 2 * v[2] * in.radius, .T_crack = {}, .stress = {}};
  if (v[3].value > 0) contact.stress = {v[3], v[4]};
  if (!std::isnan(v[5].value)) contact.T_crack = v[5];
  contact.spacing = v[6];
  contact.start_on_curve = v[7].value == 1;
  return collide_viscous(in, contact, settings);
}

}  // namespace

extern const CollisionLaw stress_collision;
const CollisionLaw stress_collision{"stress",
                                    "krijt with a relaxation time that grows with the pressure",
                                    parameters, collide_stress};

}  // namespace mdana
