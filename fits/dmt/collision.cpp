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

/// t_max v/delta_max, delta = delta_max cos^2 phi; b = k D. Kinetic energy 1 - c^5 + b (c^2 - c^5).
double compression_time(double b) {
  const auto integrand = [&](double phi) {
    const double c = std::cos(phi), q = 1 + c + c * c;
    return 2 * std::numbers::sqrt2 * std::cos(phi / 2) * c /
           std::sqrt(q + c * c * c * (1 + c) + b * c * c * q);
  };
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  return Rule::integrate(integrand, 0.0, std::numbers::pi / 2, 15, 1e-14);
}

CollisionSensitivities no_loss(const CollisionInput& input, const Collision& c, double k, double d) {
  // m* v^2/2 = 8/15 E* sqrt(R*) delta^2.5 - 4 pi gamma R* delta: by delta, F delta.
  const double hertz = d * d * std::sqrt(d), force = 2.5 * hertz - k * d, b = k * d;
  Eigen::VectorXd work(5);  // what is missing at a fixed delta, by the logarithms
  work << b - 0.5 * hertz, 1, -hertz, 2, b;
  CollisionSensitivities s{Eigen::VectorXd::Zero(5), c.delta_max / force * work,
                           Eigen::VectorXd::Constant(5, Collision::unknown)};
  // t_max = delta_max/v T(b); b = k D, k = 4 pi gamma R* delta_H/(m* v^2/2).
  Eigen::VectorXd of_b(5), of_delta = work / force;
  of_b << 1, -1, 0, -2, 1;
  of_b += of_delta;
  const double h = 1e-4 * (1 + b);
  const auto time = [](double x) { return compression_time(std::max(x, 0.0)); };
  const double slope = b > 2 * h ? (8 * (time(b + h) - time(b - h)) - time(b + 2 * h) + time(b - 2 * h)) /
                                       (12 * h)
                                 : (4 * time(b + h) - 3 * time(b) - time(b + 2 * h)) / (2 * h);
  s.t_max = c.t_max * (of_delta + slope * b / compression_time(b) * of_b);
  s.t_max[3] -= c.t_max;
  const Impact& i = input.impact;
  const std::array values{i.radius, i.mass, i.modulus, i.velocity, input.values[0]};
  for (Eigen::Index n = 0; n < 5; ++n)
    for (Eigen::VectorXd* v : {&s.delta_max, &s.t_max})
      (*v)[n] = values[n] > 0 ? (*v)[n] / values[n] : 0;
  return s;
}

Collision collide_dmt(const CollisionInput& input, const CollisionSettings& settings) {
  const Impact& i = input.impact;
  const double energy = i.mass / (i.radius * i.radius * i.radius) *
                        (i.velocity * (i.velocity / i.modulus)) / 2;  // in E* R*^3
  const double hertz = std::pow(15.0 / 8.0 * energy, 0.4);            // delta_max/R*
  const double k = 4 * std::numbers::pi * (input.values[0] / i.radius / i.modulus) * hertz / energy;
  const double d = compression(k);
  Collision c;
  c.outcome = CollisionOutcome::bounce;
  c.e = c.e_squared = 1;
  c.e_error = c.e_squared_error = c.energy_residual = 0;
  c.delta_max = d * hertz * i.radius;
  c.t_max = compression_time(k * d) * (c.delta_max / i.velocity);
  c.contact_time = 2 * c.t_max;
  c.a_max = std::sqrt(d * hertz) * i.radius;
  c.p_c_max = 2 / std::numbers::pi * i.modulus * std::sqrt(d * hertz);
  if (settings.sensitivities) c.sensitivities = no_loss(input, c, k, d);
  if (settings.trajectory)
    c.trajectory = branch_motion(dmt_law, dmt_law,
                                 {i.radius, i.modulus, input.values[0], 0, 0, c.delta_max}, i.mass);
  return c;
}

constexpr std::array<CollisionParameter, 1> parameters{
    {{"gamma", "energy of one surface", dimension::surface_energy, 0, true, 1e300, {}}}};

}  // namespace

extern const CollisionLaw dmt_collision;
const CollisionLaw dmt_collision{"dmt", "elastic spheres with attraction about the contact", parameters,
                                 collide_dmt};

}  // namespace mdana
