// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/viscous_contact.hpp"

namespace mdana {
namespace {

Collision collide_hertz(const CollisionInput& input, const CollisionSettings& settings) {
  return collide_elastic(LawInput(input), settings);
}

}  // namespace

extern const CollisionLaw hertz_collision;
const CollisionLaw hertz_collision{"hertz", "elastic spheres without adhesion", {}, collide_hertz};

}  // namespace mdana
