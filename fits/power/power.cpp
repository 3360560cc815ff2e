// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/converged.hpp"
#include "fits/viscous_contact.hpp"

namespace mdana {
namespace {

constexpr std::array parameters{
    parameter::gamma,
    // D has the dimension of v^-alpha a^(2 - beta), which is no product of whole powers.
    CollisionParameter{"D", "F_dis = D E* v^alpha a^beta", dimension::none, 0, true, 1e300, {}},
    CollisionParameter{"alpha", "power of the speed", dimension::none, 0, false, 20, {}},
    CollisionParameter{"beta", "power of the contact radius", dimension::none, 0, true, 20, {}}};

/// P1 eqs 19, 20: F_dis = sgn(v) D E* |v|^alpha a^beta, a on the JKR curve (Hertz's if gamma = 0).
Collision collide_power(const CollisionInput& input, const CollisionSettings& settings) {
  const LawInput in(input);
  const Parameter &gamma = in.values[0], &d = in.values[1], &alpha = in.values[2],
                  &beta = in.values[3];
  if (d.value == 0)
    return collide_viscous(in, {.gamma = gamma, .nu = 1, .T_vis = 0, .T_crack = {}, .stress = {}},
                           settings);
  const ContactScales scales = gamma.value > 0 ? jkr_scales(in, gamma) : hertz_scales(in);
  const Parameter scaled_d = exp(log(d) + log(in.modulus) + alpha * log(scales.speed()) +
                                 beta * log(scales.radius) - log(scales.force));
  CurveContact kind;
  kind.power = true;
  return collide_on_curve(kind, {in.velocity / scales.speed(), scaled_d, alpha, beta}, scales,
                          settings);
}

}  // namespace

extern const CollisionLaw power_collision;
const CollisionLaw power_collision{"power",
                                   "JKR with a dissipation by powers of speed and contact radius",
                                   parameters, collide_power};

}  // namespace mdana
