// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/elastoplastic.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <boost/math/special_functions/beta.hpp>

namespace mdana {
namespace {

using std::numbers::pi;

/// omega delta_Y/v_Y of the plastic part, omega^2 = pi R* p/m*.
const double omega = std::sqrt(15.0 / 8);

/// Time up to yield in delta_Y/v_Y: int_0^1 du/sqrt(x^2 - u^2.5), an incomplete beta function of
/// z = 1/x^2, by its complement near z = 1.
double time_to_yield(double x) {
  const double z = 1 / x / x, rest = (1 - 1 / x) * (1 + 1 / x);
  if (z < 1e-17) return 1 / x;
  const double part = z < 0.5 ? boost::math::beta(0.4, 0.5, z)
                              : boost::math::beta(0.4, 0.5) - boost::math::beta(0.5, 0.4, rest);
  return 0.4 * std::pow(z, -0.4) * part / x;
}

/// sqrt(x^2 - 1): speed at yield in v_Y.
double speed_at_yield(double x) { return std::sqrt((x - 1) * (x + 1)); }

/// delta_max and t_max from x and the scales.
void compress(Compression& c) {
  const double x = c.speed, scale = c.yield_delta / c.yield_velocity;
  if (!c.yields()) {
    c.delta_max = c.yield_delta * std::pow(x, 0.8);
    c.t_max = elastic_compression_time() * scale * std::pow(x, -0.2);
    return;
  }
  // delta - delta_Y/3 oscillates from 2/3 delta_Y on.
  c.delta_max = c.yield_delta * (5 + x * std::sqrt(120 - 20 / x / x)) / 15;
  const double quarter = std::atan2(speed_at_yield(x), 2.0 / 3.0 * omega) / omega;
  c.t_max = scale * (time_to_yield(x) + quarter);
}

/// m* v^2/(E* R*^3) without overflow.
double softness(const Impact& i, double velocity) {
  return i.mass / (i.radius * i.radius * i.radius) * (velocity * (velocity / i.modulus));
}

/// dln t_max/dln x: the singular parts of the two times cancel.
double time_slope(const Compression& c) {
  if (!c.yields()) return -0.2;
  const double w = speed_at_yield(c.speed);
  const double slope = -0.2 * time_to_yield(c.speed) - 2.0 / 15.0 / (5.0 / 6.0 / w + w);
  return slope * (c.yield_delta / c.yield_velocity) / c.t_max;
}

double delta_slope(const Compression& c) {
  if (!c.yields()) return 0.8;
  const double root = std::sqrt(120 - 20 / c.speed / c.speed);
  return 120 / root / (5 / c.speed + root);
}

}  // namespace

Compression compression_by_pressure(const Impact& i, double yield_pressure) {
  Compression c;
  c.yield_pressure = yield_pressure;
  const double strain = pi / 2 * (yield_pressure / i.modulus);
  c.yield_delta = strain * strain * i.radius;
  c.yield_velocity = strain * strain * std::sqrt(8 * pi / 15 * (yield_pressure / i.mass) *
                                                 (i.radius * i.radius * i.radius));
  c.speed = i.velocity / c.yield_velocity;
  compress(c);
  return c;
}

Compression compression_by_velocity(const Impact& i, double yield_velocity) {
  Compression c;
  const double d = std::pow(15.0 / 16.0 * softness(i, yield_velocity), 0.4);
  c.yield_delta = d * i.radius;
  c.yield_pressure = 2 / pi * i.modulus * std::sqrt(d);
  c.yield_velocity = yield_velocity;
  c.speed = i.velocity / yield_velocity;
  compress(c);
  return c;
}

double elastic_compression_time() {
  static const double time = std::sqrt(pi) * std::tgamma(1.4) / std::tgamma(0.9);
  return time;
}

Collision bounce(const Impact& i, const Compression& compression, double e_squared) {
  Collision c;
  if (!(compression.delta_max > 0 && std::isfinite(compression.delta_max) && compression.t_max > 0 &&
        std::isfinite(compression.t_max) && e_squared > 0)) {
    c.reason = "the numbers leave the range of double precision";
    return c;
  }
  c.outcome = CollisionOutcome::bounce;
  c.e_squared = e_squared;
  c.e = std::sqrt(e_squared);
  // Rounding of v_Y (a power 2.5) and of a dozen operations.
  c.e_squared_error = compression.yields() ? 32 * std::numeric_limits<double>::epsilon() * e_squared : 0;
  c.e_error = c.e_squared_error / (2 * c.e);
  c.delta_max = compression.delta_max;
  c.t_max = compression.t_max;
  c.a_max = std::sqrt(i.radius * compression.delta_max);
  c.p_c_max = compression.yields() ? compression.yield_pressure
                                   : 2 / pi * i.modulus * (c.a_max / i.radius);
  c.energy_residual = 0;
  return c;
}

CollisionSensitivities log_sensitivities(const Compression& c, const YieldSlopes& slopes,
                                         double e_squared_slope) {
  Eigen::VectorXd x = -slopes.velocity;
  x[3] += 1;
  return {e_squared_slope * x, c.delta_max * (slopes.delta + delta_slope(c) * x),
          c.t_max * (slopes.delta - slopes.velocity + time_slope(c) * x)};
}

CollisionSensitivities by_values(CollisionSensitivities s, const CollisionInput& input) {
  const Impact& i = input.impact;
  std::vector<double> values{i.radius, i.mass, i.modulus, i.velocity};
  values.insert(values.end(), input.values.begin(), input.values.end());
  for (std::size_t k = 0; k < values.size(); ++k)
    for (Eigen::VectorXd* v : {&s.e_squared, &s.delta_max, &s.t_max}) {
      double& derivative = (*v)[static_cast<Eigen::Index>(k)];
      derivative = std::abs(values[k]) > 0 ? derivative / values[k] : 0;
    }
  return s;
}

}  // namespace mdana
