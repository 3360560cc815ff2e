// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fits/branch_motion.hpp"
#include "fits/viscous_contact.hpp"

namespace mdana {
namespace {

/// t_max v/delta_max = integral of 1/sqrt(1 - x^2.5) = sqrt(pi) Gamma(7/5)/Gamma(9/10).
const double compression_time = std::sqrt(std::numbers::pi) * std::tgamma(1.4) / std::tgamma(0.9);

double contact_radius(double delta, const ElasticContact& c) { return std::sqrt(c.radius * std::max(delta, 0.0)); }

double force(double delta, const ElasticContact& c) {
  return 4.0 / 3.0 * c.modulus * contact_radius(delta, c) * delta;
}

const ForceBranch hertz_branch{.force = force,
                               .contact_radius = contact_radius,
                               .least_delta = [](const ElasticContact&) { return 0.0; },
                               .energy = [](double delta, const ElasticContact& c) { return 0.4 * force(delta, c) * delta; }};

}  // namespace

/// P1 eqs 3, 4, 15: 8/15 E* sqrt(R*) delta_max^2.5 = m* v^2/2, p_c = 2 E* a/(pi R*).
Collision collide_elastic(const LawInput& input, const CollisionSettings& settings) {
  const ContactScales scales = hertz_scales(input);
  const Parameter d_max = std::pow(15.0 / 16.0, 0.4) * scales.delta;
  const Parameter t_max = compression_time * (d_max / input.velocity);
  Collision c;
  c.outcome = CollisionOutcome::bounce;
  c.e = c.e_squared = 1;
  c.e_error = c.e_squared_error = 0;
  c.delta_max = d_max.value;
  c.t_max = t_max.value;
  c.contact_time = 2 * c.t_max;
  const double u = std::pow(15.0 / 16.0, 0.2);
  c.a_max = u * scales.radius.value;
  c.p_c_max = scales.centre_pressure(u);
  c.energy_residual = 0;
  if (settings.trajectory)
    c.trajectory = branch_motion(hertz_branch, hertz_branch,
                                 {input.radius.value, input.modulus.value, 0, 0, 0, c.delta_max}, input.mass.value,
                                 settings.times);
  if (settings.sensitivities)
    c.sensitivities = {Parameter::Gradient::Zero(), d_max.gradient, t_max.gradient};
  return c;
}

}  // namespace mdana
