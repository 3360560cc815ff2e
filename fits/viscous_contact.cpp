// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/viscous_contact.hpp"

#include <cmath>
#include <numbers>

#include "fits/converged.hpp"

namespace mdana {
namespace {

/// Energy of pull-off less that of first contact, in F_c delta_0: what a JKR contact loses.
const double jkr_loss = (6 * std::pow(4.0, 4.0 / 3.0) + 4) / 5 * std::pow(6.0, -4.0 / 3.0);

/// lam of bulk dissipation without adhesion: 2 T_vis/(nu^2 t); b by P = 2 sqrt(d/R*)/pi.
Collision without_adhesion(const LawInput& input, const ViscousContact& contact,
                           const CollisionSettings& settings) {
  if (contact.T_vis.value == 0) return collide_elastic(input, settings);
  const ContactScales scales = hertz_scales(input);
  const Parameter lam = 2 * contact.T_vis / (contact.nu * contact.nu) / scales.time;
  CurveContact kind;
  kind.stress = contact.stress.has_value();
  const Parameter b = kind.stress ? contact.stress->b * scales.pressure : Parameter(0);
  const Parameter zeta = kind.stress ? contact.stress->zeta : Parameter(1);
  return collide_on_curve(kind, {1.0, lam, b, zeta}, scales, settings);
}

/// e^2 = 1 - 2 loss/w0^2, e from (w0 - w)(w0 + w) where they are close.
void set_closed_form(Collision& c, double w0) {
  const double threshold = std::sqrt(2 * jkr_loss);
  c.outcome = w0 > threshold ? CollisionOutcome::bounce : CollisionOutcome::stick;
  c.reason = w0 > threshold ? "" : "bound: the energy left does not reach pull-off";
  set_restitution(c, (w0 - threshold) / w0 * ((w0 + threshold) / w0),
                  8e-16 * (1 + threshold / w0 * (threshold / w0)));
}

/// The motion on the JKR curve; its times, which have no closed form, are integrated.
Collision on_jkr_curve(const ContactScales& scales, const Parameter& lam,
                       const ViscousContact& contact, const CollisionSettings& settings,
                       const Parameter& w0) {
  CurveContact kind;
  kind.stress = contact.stress.has_value();
  const Parameter b = kind.stress ? contact.stress->b * scales.pressure : Parameter(0);
  const Parameter zeta = kind.stress ? contact.stress->zeta : Parameter(1);
  Collision c = collide_on_curve(kind, {w0, lam, b, zeta}, scales, settings);
  if (lam.value == 0 && std::isfinite(w0.value)) set_closed_form(c, w0.value);
  return c;
}

/// Where a crack is so fast that double precision cannot tell its delay, and what that delay could
/// cost in F_c delta_0: 4u(1 - beta) du with beta of the crack law while a moves, and the passage
/// of pull-off, measured as 2.5 (w_0/kap)^(2/3) at kap = 1e9 to 1e11.
constexpr double fastest_crack = 1e12;
double greatest_delay_loss(double kap, double w0, double u_max) {
  if (std::isinf(kap)) return 0;
  const double slowness = std::max(1.0, w0) / kap;
  return 4 * u_max * u_max * std::pow(slowness, 0.87) + 12 * std::pow(slowness, 2.0 / 3.0);
}

Collision with_fast_crack(Collision c, double kap, double w0, const ContactScales& scales) {
  if (c.outcome == CollisionOutcome::unresolved) return c;
  const double loss = greatest_delay_loss(kap, w0, c.a_max / scales.radius.value);
  set_restitution(c, c.e_squared, c.e_squared_error + 2 * loss / (w0 * w0));
  return c;
}

}  // namespace

Collision collide_viscous(const LawInput& input, const ViscousContact& contact,
                          const CollisionSettings& settings) {
  if (contact.gamma.value == 0) return without_adhesion(input, contact, settings);
  const ContactScales scales = jkr_scales(input, contact.gamma);
  const Parameter w0 = input.velocity / scales.speed();
  const Parameter lam = 2 * contact.T_vis / (contact.nu * contact.nu) / scales.time;
  const Parameter T_crack = contact.T_crack.value_or(contact.T_vis);
  if (T_crack.value == 0) return on_jkr_curve(scales, lam, contact, settings, w0);
  // sigma_0 = gamma/spacing: 2 E* gamma tau/(sigma_0^2 T a_0)
  const Parameter kap = 2 * (input.modulus / contact.gamma) * (contact.spacing / scales.radius) *
                        contact.spacing * (scales.time / T_crack);
  if (kap.value > fastest_crack)
    return with_fast_crack(on_jkr_curve(scales, lam, contact, settings, w0), kap.value, w0.value,
                           scales);
  CrackContact kind;
  kind.start_on_curve = contact.start_on_curve;
  kind.stress = contact.stress.has_value();
  kind.stress_in_crack = kind.stress && !contact.T_crack;
  const Parameter b = kind.stress ? contact.stress->b * scales.pressure : Parameter(0);
  const Parameter zeta = kind.stress ? contact.stress->zeta : Parameter(1);
  return collide_with_crack(kind, {w0, lam, kap, b, zeta}, scales, settings);
}

}  // namespace mdana
