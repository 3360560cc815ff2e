// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/overlays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reports/plan.hpp"

namespace mdana {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Force of the loading at a delta, in the last step of it that covers that.
Value loading_at(const ForceCurve& curve, const Cycle& cycle, double d) {
  for (std::size_t i = cycle.turn; i > cycle.start; --i) {
    const double d0 = curve.delta[i - 1], d1 = curve.delta[i];
    if (!(d0 <= d && d <= d1)) continue;
    const double t = d1 > d0 ? (d - d0) / (d1 - d0) : 0.5;
    return {curve.force[i - 1] + t * (curve.force[i] - curve.force[i - 1]),
            std::max(curve.force_error[i - 1], curve.force_error[i]), dimension::force};
  }
  return {none, {}, dimension::force};
}

std::vector<double> over(std::vector<double> values, double unit) {
  for (double& value : values) value /= unit;
  return values;
}

void add_law(Table& table, const ForceCurve& curve, const char* name, const ElasticContact& contact) {
  const ForceLaw* law = find_force_law(name);
  if (!law) return;
  std::vector<double> force;
  for (const double d : curve.delta) force.push_back(law->force(d, contact));
  table.add_column({std::string("F_") + name, dimension::force}, std::move(force));
}

void add_loop(Document& document, Table& table, const ForceCurve& curve, double pull) {
  const LoopForce loop = loop_force(curve);
  std::vector<double> size;
  for (const double f : loop.difference) size.push_back(std::abs(f) / pull);
  Value most{none, {}, dimension::none}, where{none, {}, dimension::length};
  for (std::size_t i = 0; i < size.size(); ++i)
    if (size[i] > (std::isnan(most.value) ? -1 : most.value)) {
      most.value = size[i];
      if (std::isfinite(loop.error[i])) most.error = loop.error[i] / pull;
      where.value = curve.delta[i];
    }
  document.number("loop_over_F_c.max", most);
  document.number("loop_over_F_c.at_delta", where);
  table.add_column({"loop_over_F_c", dimension::none}, std::move(size));
}

}  // namespace

LoopForce loop_force(const ForceCurve& curve) {
  LoopForce loop{std::vector<double>(curve.delta.size(), none),
                 std::vector<double>(curve.delta.size(), none)};
  if (curve.cycles.empty()) return loop;
  const Cycle& cycle = curve.cycles.front();
  for (std::size_t i = cycle.turn + 1; i <= cycle.end; ++i) {
    const Value loading = loading_at(curve, cycle, curve.delta[i]);
    loop.difference[i] = curve.force[i] - loading.value;
    loop.error[i] = std::hypot(curve.force_error[i], loading.error.value_or(none));
  }
  return loop;
}

void add_overlays(Document& document, Table& table, const ForceCurve& curve,
                  const ElasticContact& contact) {
  if (!(contact.surface_energy > 0))
    return document.left_out("F/F_c", gamma_not_known);
  const double pull = 3 * std::numbers::pi * contact.surface_energy * contact.radius;
  document.number("F_c", {pull, {}, dimension::force});
  table.add_column({"F_over_F_c", dimension::none}, over(curve.force, pull));
  add_loop(document, table, curve, pull);
  if (!(contact.modulus > 0))
    return document.left_out("delta/delta_0, F_jkr", modulus_not_known);
  const double a0 = std::cbrt(9 * std::numbers::pi * contact.surface_energy *
                              (contact.radius * (contact.radius / contact.modulus)));
  const double delta0 = a0 * (a0 / (3 * contact.radius));
  document.number("delta_0", {delta0, {}, dimension::length});
  table.add_column({"delta_over_delta0", dimension::none}, over(curve.delta, delta0));
  add_law(table, curve, "hertz", contact);
  add_law(table, curve, "jkr", contact);
}

}  // namespace mdana
