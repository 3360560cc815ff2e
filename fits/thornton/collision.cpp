// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "fits/branch_motion.hpp"
#include "fits/elastoplastic.hpp"

namespace mdana {

extern const ForceLaw thornton_law;

namespace {

enum Parameter { gamma, Y, v_Y };

/// P1 eq. 13, squared; 1 below yield.
double e_squared(double x) {
  if (!(x > 1)) return 1;
  const double z = 1 / x / x, q = 2 * x * std::sqrt(1.2 - 0.2 * z);
  return 1.2 * std::numbers::sqrt3 * (1 - z / 6) / std::sqrt(1 + q);
}

/// de^2/dln x.
double e_squared_slope(double x) {
  if (!(x > 1)) return 0;
  const double z = 1 / x / x, q = 2 * std::sqrt(1.2 - 0.2 * z);
  return e_squared(x) * (z / 3 / (1 - z / 6) - 2.4 / (q * (1 / x + q)));
}

/// 0.77224... F_c delta0 over m* v^2/2: lost by breaking a JKR contact off.
double adhesive_loss(const Impact& i, double surface_energy) {
  const double loss = std::pow(6.0, -4.0 / 3.0) * (6 * std::pow(4.0, 4.0 / 3.0) + 4) / 5;
  const double g = surface_energy / i.radius / i.modulus, a0 = std::cbrt(9 * std::numbers::pi * g);
  const double energy = std::numbers::pi * g * a0 * a0;  // F_c delta0/(E* R*^3)
  return 2 * loss * energy /
         (i.mass / (i.radius * i.radius * i.radius) * (i.velocity * (i.velocity / i.modulus)));
}

Compression compression_of(const CollisionInput& input) {
  return std::isnan(input.values[v_Y])
             ? compression_by_pressure(input.impact, 1.6 * input.values[Y])
             : compression_by_velocity(input.impact, input.values[v_Y]);
}

CollisionSensitivities sensitivities(const CollisionInput& input, const Compression& c, double loss) {
  YieldSlopes s{Eigen::VectorXd(7), Eigen::VectorXd(7)};
  if (std::isnan(input.values[v_Y])) {
    s.delta << 1, 0, -2, 0, 0, 2, 0;
    s.velocity << 1.5, -0.5, -2, 0, 0, 2.5, 0;
  } else {
    s.delta << -0.2, 0.4, -0.4, 0, 0, 0, 0.8;
    s.velocity << 0, 0, 0, 0, 0, 0, 1;
  }
  CollisionSensitivities found = log_sensitivities(c, s, e_squared_slope(c.speed));
  Eigen::VectorXd of_loss(7);
  of_loss << 4.0 / 3.0, -1, -2.0 / 3.0, -2, 5.0 / 3.0, 0, 0;
  found.e_squared -= loss * of_loss;
  if (loss > 0) found.delta_max = found.t_max = Eigen::VectorXd::Constant(7, Collision::unknown);
  return by_values(found, input);
}

/// P1 eq. 14 with e of JKR. It belongs to no motion, so that nothing but e is known.
void add_adhesion(Collision& c, double loss) {
  const double e_squared = c.e_squared - loss;
  c = {};
  c.e_squared = e_squared;
  c.e_squared_error = 32 * std::numeric_limits<double>::epsilon() * (1 + loss);
  c.energy_residual = 0;
  c.e = std::sqrt(std::max(e_squared, 0.0));
  c.e_error = c.e > 0 ? c.e_squared_error / (c.e + std::sqrt(c.e_squared_error)) : 0;
  c.outcome = c.e > 0 ? CollisionOutcome::bounce : CollisionOutcome::stick;
  if (!(c.e > 0)) c.reason = "what yielding and breaking off cost exceeds the energy of the impact";
}

Collision collide_thornton(const CollisionInput& input, const CollisionSettings& settings) {
  const Impact& i = input.impact;
  const Compression compression = compression_of(input);
  const double loss = adhesive_loss(i, input.values[gamma]);
  Collision c = bounce(i, compression, e_squared(compression.speed));
  if (c.outcome != CollisionOutcome::bounce) return c;
  // Out: an elastic sphere of radius R_p, a^2 = R_p (delta_max - delta_p), with a and F of the turn.
  const double flatter = compression.yields() ? 0.75 * std::numbers::pi * (c.p_c_max / i.modulus) *
                                                    (i.radius / c.a_max) *
                                                    (1 - compression.yield_delta / c.delta_max / 3)
                                              : 1;
  c.contact_time = c.t_max + elastic_compression_time() * (c.delta_max * flatter) / (c.e * i.velocity);
  if (settings.trajectory && loss == 0)
    c.trajectory = branch_motion(
        thornton_law, unloading(thornton_law),
        {i.radius, i.modulus, 0, compression.yield_pressure / 1.6, 0, c.delta_max}, i.mass, settings.times);
  if (loss > 0) add_adhesion(c, loss);
  if (settings.sensitivities) c.sensitivities = sensitivities(input, compression, loss);
  return c;
}

constexpr std::array<CollisionParameter, 3> parameters{
    {{"gamma", "energy of one surface", dimension::surface_energy, 0, true, 1e300, 0.0},
     {"Y", "yield strength, p_y = 1.6 Y", dimension::pressure, 0, false, 1e300, {}, "v_Y"},
     {"v_Y", "velocity at which yield begins", dimension::velocity, 0, false, 1e300, {}, "Y"}}};

}  // namespace

extern const CollisionLaw thornton_collision;
const CollisionLaw thornton_collision{"thornton",
                                      "elastic, perfectly plastic spheres with or without adhesion",
                                      parameters, collide_thornton};

}  // namespace mdana
