// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "fits/viscous_contact.hpp"

namespace mdana {
namespace {

/// t_max v/delta_max = integral of 1/sqrt(1 - x^2.5) = sqrt(pi) Gamma(7/5)/Gamma(9/10).
const double compression_time = std::sqrt(std::numbers::pi) * std::tgamma(1.4) / std::tgamma(0.9);

/// With x = (delta/delta_max) = sin^0.8: a point of the motion and the time to it by quadrature.
void add_trajectory(Collision& c, const Impact& impact) {
  constexpr int half = 64;
  double time = 0;
  std::vector<CollisionPoint> loading;
  // y = sqrt(1 - x): dt = delta_max/v 2y dy/sqrt(1 - (1 - y^2)^2.5), which is smooth; Simpson's
  // rule.
  const auto pace = [](double y) {
    if (y == 0) return 2 / std::sqrt(2.5);
    return 2 * y / std::sqrt(-std::expm1(2.5 * std::log1p(-y * y)));
  };
  const double unit = c.delta_max / impact.velocity;
  for (int k = 0; k <= half; ++k) {
    const double y = 1 - static_cast<double>(k) / half, x = (1 - y) * (1 + y);
    if (k > 0) {
      const double h = 1.0 / half;
      const double first = k == 1 ? 2.0 : pace(y + h);  // y = 1: log1p(-1)
      time += h / 6 * (first + 4 * pace(y + 0.5 * h) + pace(y)) * unit;
    }
    const double speed = k == half ? 0 : std::sqrt(std::max(0.0, 1 - std::pow(x, 2.5)));
    loading.push_back({time, x * c.delta_max, speed * impact.velocity, std::sqrt(x) * c.a_max,
                       4.0 / 3.0 * impact.modulus * c.a_max * std::sqrt(x) * (x * c.delta_max)});
  }
  for (const CollisionPoint& p : loading) c.trajectory.push_back(p);
  for (int k = half - 1; k >= 0; --k) {
    const CollisionPoint& p = loading[static_cast<std::size_t>(k)];
    c.trajectory.push_back(
        {c.contact_time - p.time, p.delta, -p.velocity, p.contact_radius, p.force});
  }
}

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
    add_trajectory(
        c, {input.radius.value, input.mass.value, input.modulus.value, input.velocity.value});
  if (settings.sensitivities)
    c.sensitivities = {Parameter::Gradient::Zero(), d_max.gradient, t_max.gradient};
  return c;
}

}  // namespace mdana
