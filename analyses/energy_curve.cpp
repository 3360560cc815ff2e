// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/energy_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "analyses/motion.hpp"
#include "readers/boltzmann.hpp"

namespace mdana {
namespace {

using Series = std::vector<double>;

Series sum(const Series& a, const Series& b) {
  Series result(a.size());
  std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::plus<>());
  return result;
}

Series scaled(std::span<const double> values, double factor) {
  Series result(values.begin(), values.end());
  for (double& value : result) value *= factor;
  return result;
}

/// 2 K/(f k_B) of K_t less rotation. Of a body that only rotates the two are equal to rounding: what is
/// left below it is no temperature below zero.
double temperature(double thermal, double rotation, double freedom, double k_B) {
  if (!(freedom > 0)) return std::numeric_limits<double>::quiet_NaN();
  return 2 * std::max(thermal - rotation, 0.0) / (freedom * k_B);
}

void add_translation(EnergyCurve& curve, const Table& motion, double factor) {
  for (std::size_t i = 0; i < motion.rows(); ++i) {
    const auto body = body_motion(motion, i);
    for (std::size_t b = 0; b < 2; ++b)
      curve.K_p[b].push_back(0.5 * factor * body[b].mass * body[b].velocity.squaredNorm());
    const double reduced = body[0].mass * (body[1].mass / (body[0].mass + body[1].mass));
    const Eigen::Vector3d v = body[1].velocity - body[0].velocity;
    const Eigen::Vector3d line = (body[1].position - body[0].position).stableNormalized();
    curve.K_p_rel.push_back(0.5 * factor * reduced * v.squaredNorm());
    curve.K_p_across.push_back(0.5 * factor * reduced * (v - line * line.dot(v)).squaredNorm());
  }
}

}  // namespace

Series EnergyCurve::thermal() const { return sum(K_t[0], K_t[1]); }

Series EnergyCurve::total_rotation() const { return sum(rotation[0], rotation[1]); }

Series EnergyCurve::kinetic() const { return sum(sum(K_p[0], K_p[1]), thermal()); }

Series EnergyCurve::total() const {
  return W_total.empty() ? Series() : sum(sum(K_p_rel, thermal()), W_total);
}

EnergyCurve energy_curve(const Table& motion, const Table& energy, Units units) {
  const double factor = force_per_mass_acceleration(units);  // of energies, too: mvv2e
  EnergyCurve curve;
  add_translation(curve, motion, factor);
  for (std::size_t b = 0; b < 2; ++b) {
    const std::string body = std::to_string(b + 1);
    curve.K_t[b] = scaled(energy.column("K_t" + body), factor);
    curve.rotation[b] = scaled(energy.column("rotation" + body), factor);
    const auto freedom = energy.column("degrees_of_freedom" + body);
    for (std::size_t i = 0; i < freedom.size(); ++i)
      curve.temperature[b].push_back(
          temperature(curve.K_t[b][i], curve.rotation[b][i], freedom[i], boltzmann(units)));
    if (energy.has("W" + body)) curve.W[b] = scaled(energy.column("W" + body), 1.0);
  }
  curve.W_total = sum(curve.W[0], curve.W[1]);
  return curve;
}

Table energy_table(const EnergyCurve& curve, const std::vector<std::int64_t>& steps,
                   const std::vector<double>& times) {
  Table table;
  table.add_column({"step", dimension::none}, Series(steps.begin(), steps.end()));
  if (!times.empty()) table.add_column({"time", dimension::time}, times);
  const auto add = [&](const std::string& name, const std::array<Series, 2>& both, Dimension d) {
    for (std::size_t b = 0; b < 2; ++b)
      if (!both[b].empty()) table.add_column({name + std::to_string(b + 1), d}, both[b]);
  };
  add("K_p", curve.K_p, dimension::energy);
  table.add_column({"K_p_rel", dimension::energy}, curve.K_p_rel);
  add("K_t", curve.K_t, dimension::energy);
  add("rotation", curve.rotation, dimension::energy);
  add("temperature", curve.temperature, dimension::none);
  add("W", curve.W, dimension::energy);
  if (curve.W_total.empty()) return table;
  table.add_column({"W_total", dimension::energy}, curve.W_total);
  table.add_column({"total", dimension::energy}, curve.total());
  return table;
}

}  // namespace mdana
