// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "fits/converged.hpp"
#include "fits/viscous_contact.hpp"

namespace mdana {
namespace {

constexpr double none = Collision::unknown;

constexpr std::array parameters{
    parameter::gamma,
    parameter::nu,
    parameter::T_vis,
    parameter::T_crack,
    parameter::spacing,
    parameter::start,
    CollisionParameter{"v_Y", "yield velocity", dimension::velocity, 0, false, 1e300, none, "Y"},
    CollisionParameter{"Y", "yield strength, p_y = 1.6 Y", dimension::pressure, 0, false, 1e300,
                       none, "v_Y"}};

/// v_Y = (pi/(2E*))^2 sqrt(8 pi R*^3/(15 m*)) p_y^(5/2).
Parameter yield_velocity(const LawInput& in, const Parameter& strength) {
  const double pi = std::numbers::pi;
  const Parameter p = 1.6 * strength / in.modulus;
  return pi * pi / 4 * p * p *
         sqrt(8 * pi / 15 * p * (in.radius * in.radius * in.radius / in.mass) * in.modulus);
}

/// 1 - e_TN^2 (P1 eq. 13), zero below the yield velocity, by x = v/v_Y.
Parameter plastic_loss(const Parameter& x) {
  if (!(x.value > 1)) return 0;
  const Parameter y = 1 / (x * x);
  return 1 - 6 * std::sqrt(3.0) / 5 * (1 - y / 6) / sqrt(1 + 2 * sqrt(6 / (5 * y) - 0.2));
}

/// P1 eq. 14: e^2 = e_krijt^2 - (1 - e_TN^2); a negative radicand is sticking.
Collision collide_krijt_plastic(const CollisionInput& input, const CollisionSettings& settings) {
  const LawInput in(input);
  const auto& v = in.values;
  ViscousContact contact{.gamma = v[0], .nu = v[1], .T_vis = v[2], .T_crack = {}, .stress = {}};
  if (!std::isnan(v[3].value)) contact.T_crack = v[3];
  contact.spacing = v[4];
  contact.start_on_curve = v[5].value == 1;
  Collision c = collide_viscous(in, contact, settings);
  if (c.outcome == CollisionOutcome::unresolved) return c;
  const Parameter v_y = std::isnan(v[6].value) ? yield_velocity(in, v[7]) : v[6];
  const Parameter loss = plastic_loss(in.velocity / v_y);
  if (loss.value <= 0) return c;
  if (c.sensitivities) c.sensitivities->e_squared -= loss.gradient;
  set_restitution(c, c.e_squared - loss.value, c.e_squared_error + 1e-15);
  if (c.outcome == CollisionOutcome::stick && c.reason.empty())
    c.reason = "the plastic loss is more than the energy left";
  return c;
}

}  // namespace

extern const CollisionLaw krijt_plastic_collision;
const CollisionLaw krijt_plastic_collision{"krijt-plastic",
                                           "krijt with the plastic loss of Thornton and Ning",
                                           parameters, collide_krijt_plastic};

}  // namespace mdana
