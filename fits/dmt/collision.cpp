// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "fits/branch_motion.hpp"

namespace mdana {

extern const ForceLaw dmt_law;

namespace {

/// D = delta_max by that of Hertz: D^2.5 - k D = 1. Newton from above on a convex function.
double compression(double k) {
  double d = 1 + std::cbrt(k) * std::cbrt(k);
  for (int n = 0; n < 100; ++n) {
    const double d15 = d * std::sqrt(d);
    const double next = d - (d * (d15 - k) - 1) / (2.5 * d15 - k);
    if (!(next < d)) return d;
    d = next;
  }
  return d;
}

/// t_max v/delta_max = T(b) and dT/db, b = k D: delta = delta_max cos^2 phi, kinetic energy
/// 1 - c^5 + b (c^2 - c^5) over 1 - c.
struct CompressionTime {
  double value, slope;

  explicit CompressionTime(double b) : value(integral(b, 0)), slope(integral(b, 1)) {}

 private:
  static double integral(double b, int derivative) {
    const auto integrand = [&](double phi) {
      const double c = std::cos(phi), q = 1 + c + c * c, pull = c * c * q;
      const double energy = q + c * c * c * (1 + c) + b * pull;
      const double rate = 2 * std::numbers::sqrt2 * std::cos(phi / 2) * c / std::sqrt(energy);
      return derivative == 0 ? rate : -0.5 * rate * pull / energy;
    };
    using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
    return Rule::integrate(integrand, 0.0, std::numbers::pi / 2, 15, 1e-14);
  }
};

/// m* v^2/2 = 8/15 E* sqrt(R*) delta^2.5 - 4 pi gamma R* delta, and t_max = delta_max/v T(b).
CollisionSensitivities sensitivities(const CollisionInput& input, const Collision& c, double d,
                                     double b, double b_by_gamma) {
  const Impact& i = input.impact;
  const double hertz = d * d * std::sqrt(d), force = 2.5 * hertz - b;
  const CompressionTime time(b);
  Eigen::VectorXd of_delta(5), of_b(5), of_v(5), scale(5);
  // By logarithms, but the last by gamma itself, which can be zero.
  of_delta << b - 0.5 * hertz, 1, -hertz, 2, b_by_gamma;
  of_delta /= force;
  of_b << b, -b, 0, -2 * b, b_by_gamma;
  of_b += b * of_delta;
  of_v << 0, 0, 0, 1, 0;
  scale << i.radius, i.mass, i.modulus, i.velocity, 1;
  const Eigen::VectorXd of_time = of_delta + time.slope / time.value * of_b - of_v;
  return {Eigen::VectorXd::Zero(5), c.delta_max * of_delta.cwiseQuotient(scale),
          c.t_max * of_time.cwiseQuotient(scale)};
}

Collision collide_dmt(const CollisionInput& input, const CollisionSettings& settings) {
  const Impact& i = input.impact;
  const double energy = i.mass / (i.radius * i.radius * i.radius) *
                        (i.velocity * (i.velocity / i.modulus)) / 2;  // in E* R*^3
  const double hertz = std::pow(15.0 / 8.0 * energy, 0.4);            // delta_max/R*
  const double k_by_gamma = 4 * std::numbers::pi / i.radius / i.modulus * (hertz / energy);
  const double k = k_by_gamma * input.values[0], d = compression(k);
  Collision c;
  if (!(hertz > 0 && std::isfinite(k * d))) {
    c.reason = "the numbers leave the range of double precision";
    return c;
  }
  c.outcome = CollisionOutcome::bounce;
  c.e = c.e_squared = 1;
  c.e_error = c.e_squared_error = c.energy_residual = 0;
  c.delta_max = d * hertz * i.radius;
  c.t_max = CompressionTime(k * d).value * (c.delta_max / i.velocity);
  c.contact_time = 2 * c.t_max;
  c.a_max = std::sqrt(d * hertz) * i.radius;
  c.p_c_max = 2 / std::numbers::pi * i.modulus * std::sqrt(d * hertz);
  if (settings.sensitivities) c.sensitivities = sensitivities(input, c, d, k * d, k_by_gamma * d);
  if (settings.trajectory)
    c.trajectory = branch_motion(dmt_law, dmt_law,
                                 {i.radius, i.modulus, input.values[0], 0, 0, c.delta_max}, i.mass,
                                settings.times);
  return c;
}

constexpr std::array<CollisionParameter, 1> parameters{
    {{"gamma", "energy of one surface", dimension::surface_energy, 0, true, 1e300, {}}}};

}  // namespace

extern const CollisionLaw dmt_collision;
const CollisionLaw dmt_collision{"dmt", "elastic spheres with attraction about the contact", parameters,
                                 collide_dmt};

}  // namespace mdana
