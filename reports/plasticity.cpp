// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/plasticity.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace mdana {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

Value hertz_pressure(const Value& delta, double radius) {
  Value p{not_known, {}, dimension::none};
  if (!(delta.value > 0)) return p;
  p.value = 2 / std::numbers::pi * std::sqrt(delta.value / radius);
  if (delta.error) p.error = 0.5 * p.value * *delta.error / delta.value;
  return p;
}

/// P1 eq. 9 at the greatest delta, over E*.
std::optional<Value> pressure_by_jkr(const Value& delta, const ElasticContact& contact) {
  const ForceLaw* jkr = find_force_law("jkr");
  if (!jkr || !(contact.modulus > 0) || !(contact.surface_energy > 0)) return std::nullopt;
  const auto centre = [&](double d) { return jkr->pressure(0, d, contact) / contact.modulus; };
  Value p{centre(delta.value), {}, dimension::none};
  if (delta.error)
    p.error =
        0.5 * std::abs(centre(delta.value + *delta.error) - centre(delta.value - *delta.error));
  return p;
}

/// delta between frames i and i + 1 where the force is zero, with what its error moves.
Value zero_between(const ForceCurve& curve, std::size_t i) {
  const double f0 = curve.force[i], f1 = curve.force[i + 1];
  const double step = curve.delta[i + 1] - curve.delta[i];
  Value zero{curve.delta[i] + f0 / (f0 - f1) * step, {}, dimension::length};
  zero.error = std::abs(step / (f0 - f1)) * std::max(curve.force_error[i], curve.force_error[i + 1]);
  return zero;
}

/// Zeros of the force nearest to the first turn, before and behind it.
Value residual_delta(const ForceCurve& curve) {
  const Value none{not_known, {}, dimension::length};
  if (curve.cycles.empty()) return none;
  const Cycle& c = curve.cycles[0];
  std::size_t before = c.turn, behind = c.turn;
  while (before > c.start && curve.force[before] > 0) --before;
  while (behind < c.end && curve.force[behind] > 0) ++behind;
  if (curve.force[before] > 0 || curve.force[behind] > 0 || before == behind) return none;
  const Value loading = zero_between(curve, before), unloading = zero_between(curve, behind - 1);
  return {unloading.value - loading.value, std::hypot(*loading.error, *unloading.error),
          dimension::length};
}

/// One sign more.
void raise(Plasticity& verdict) {
  verdict = verdict == Plasticity::no ? Plasticity::possible : Plasticity::yes;
}

void judge(const ForceCurve& curve, PlasticSigns& signs) {
  const double p = signs.pressure().value;
  const char* law = signs.pressure_jkr ? "JKR" : "Hertz";
  if (p >= yield_certain)
    signs.verdict = Plasticity::yes;
  else if (p >= yield_begins)
    signs.verdict = Plasticity::possible;
  if (!std::isnan(p))
    signs.reasons.push_back(fmt::format("p_c = {:.3g} E* by {} at the greatest delta; yield begins near "
                                        "{}, and is certain beyond {}",
                                        p, law, yield_begins, yield_certain));
  const Value& rest = signs.residual;
  if (std::isnan(rest.value)) {
    signs.reasons.push_back("the force does not vanish on both sides of the greatest delta: no residual");
    return;
  }
  const bool significant = rest.error && rest.value > 3 * *rest.error &&
                           rest.value > 0.02 * std::abs(curve.delta_max.value);
  signs.reasons.push_back(fmt::format("residual delta {:.3g} ± {:.2g}: {}", rest.value,
                                      rest.error.value_or(0),
                                      significant ? "a dent is left" : "no dent beyond its error"));
  if (significant) raise(signs.verdict);
}

}  // namespace

std::string_view name(Plasticity plasticity) {
  constexpr std::array<std::string_view, 3> names{"no", "possible", "yes"};
  return names[static_cast<std::size_t>(plasticity)];
}

PlasticSigns plastic_signs(const ForceCurve& curve, const ElasticContact& contact) {
  PlasticSigns signs;
  signs.pressure_hertz = hertz_pressure(curve.delta_max, contact.radius);
  signs.pressure_jkr = pressure_by_jkr(curve.delta_max, contact);
  signs.residual = residual_delta(curve);
  judge(curve, signs);
  return signs;
}

Value far_side_growth(const Table& far_side, std::size_t body,
                      const std::optional<EnergyWindows>& windows) {
  const auto column = far_side.column("far_side" + std::to_string(body));
  const std::vector<double> reach(column.begin(), column.end());
  if (!windows) return {reach.back() - reach.front(), {}, dimension::length};
  const Value before = window_mean(reach, windows->before, dimension::length);
  const Value after = window_mean(reach, windows->after, dimension::length);
  Value growth{after.value - before.value, {}, dimension::length};
  if (before.error && after.error) growth.error = std::hypot(*before.error, *after.error);
  return growth;
}

void judge_bumps(PlasticSigns& signs, const std::array<Value, 2>& bump, double spacing) {
  signs.bump = bump;
  bool significant = false;
  for (const Value& b : bump)
    significant = significant || (b.value > bump_fraction * spacing &&
                                  (!b.error || b.value > 3 * *b.error));
  signs.reasons.push_back(
      fmt::format("far sides grow by {:.3g} ± {:.2g} and {:.3g} ± {:.2g}: {}", bump[0].value,
                  bump[0].error.value_or(0), bump[1].value, bump[1].error.value_or(0),
                  significant ? "a bump opposite to the contact" : "no bump"));
  if (significant) raise(signs.verdict);
}

}  // namespace mdana
