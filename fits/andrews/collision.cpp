// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

#include "fits/branch_motion.hpp"
#include "fits/elastoplastic.hpp"

namespace mdana {

extern const ForceLaw andrews_law;

namespace {

/// (sqrt(30 x^2 - 5) - 2)/(3 x^2), with y = 1/x.
double e_squared(double x) {
  if (!(x > 1)) return 1;
  const double y = 1 / x;
  return y * (std::sqrt(30 - 5 * y * y) - 2 * y) / 3;
}

/// de^2/dln x.
double e_squared_slope(double x) {
  if (!(x > 1)) return 0;
  const double y = 1 / x, root = std::sqrt(30 - 5 * y * y);
  return -y * (root - 5 * y * y / root - 4 * y) / 3;
}

/// Time of the return in delta_Y/v_Y: x' = cos^2 phi of eq. 68 with n = delta_end/delta_Y, energy
/// 5 (n (1 - c^3) + 2/5 (1 - c^5))/2 of that up to yield; smooth in phi.
double return_time(double n) {
  const auto integrand = [&](double phi) {
    const double c = std::cos(phi), q = 1 + c + c * c;
    const double energy = 2.5 * (n * q + 0.4 * (q + c * c * c * (1 + c)));
    return 2 * std::numbers::sqrt2 * std::cos(phi / 2) * c / std::sqrt(energy);
  };
  return boost::math::quadrature::gauss<double, 40>::integrate(integrand, 0.0,
                                                                std::numbers::pi / 2);
}

double time_of_return(const Compression& c) {
  if (!c.yields()) return c.t_max;
  return c.yield_delta / c.yield_velocity * return_time(c.delta_max / c.yield_delta - 1);
}

CollisionSensitivities sensitivities(const CollisionInput& input, const Compression& c) {
  YieldSlopes s{Eigen::VectorXd(5), Eigen::VectorXd(5)};
  s.delta << 1, 0, -2, 0, 2;
  s.velocity << 1.5, -0.5, -2, 0, 2.5;
  return by_values(log_sensitivities(c, s, e_squared_slope(c.speed)), input);
}

Collision collide_andrews(const CollisionInput& input, const CollisionSettings& settings) {
  const Impact& i = input.impact;
  const Compression compression = compression_by_pressure(i, input.values[0]);
  Collision c = bounce(i, compression, e_squared(compression.speed));
  if (c.outcome != CollisionOutcome::bounce) return c;
  c.contact_time = c.t_max + time_of_return(compression);
  if (settings.sensitivities) c.sensitivities = sensitivities(input, compression);
  if (settings.trajectory)
    c.trajectory = branch_motion(andrews_law, unloading(andrews_law),
                                 {i.radius, i.modulus, 0, input.values[0], 0, c.delta_max}, i.mass,
                                settings.times);
  return c;
}

constexpr std::array<CollisionParameter, 1> parameters{
    {{"Y", "yield strength: greatest pressure that the contact bears", dimension::pressure, 0, false,
      1e300, {}}}};

}  // namespace

extern const CollisionLaw andrews_collision;
const CollisionLaw andrews_collision{
    "andrews", "elastic, perfectly plastic spheres without adhesion", parameters, collide_andrews};

}  // namespace mdana
