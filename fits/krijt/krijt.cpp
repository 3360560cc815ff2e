// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "fits/viscous_contact.hpp"

namespace mdana {
namespace {

constexpr std::array parameters{parameter::gamma,   parameter::nu,      parameter::T_vis,
                                parameter::T_crack, parameter::spacing, parameter::start};

Collision collide_krijt(const CollisionInput& input, const CollisionSettings& settings) {
  const LawInput in(input);
  const auto& v = in.values;
  ViscousContact contact{.gamma = v[0], .nu = v[1], .T_vis = v[2], .T_crack = {}, .stress = {}};
  if (!std::isnan(v[3].value)) contact.T_crack = v[3];
  contact.spacing = v[4];
  contact.start_on_curve = v[5].value == 1;
  return collide_viscous(in, contact, settings);
}

}  // namespace

extern const CollisionLaw krijt_collision;
const CollisionLaw krijt_collision{
    "krijt", "adhesive spheres with bulk dissipation and a crack that takes time", parameters,
    collide_krijt};

}  // namespace mdana
