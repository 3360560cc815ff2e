// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/energy_budget.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace mdana {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t least_frames_after = 8;

double mean(const double* first, const double* last) {
  return std::accumulate(first, last, 0.0) / static_cast<double>(last - first);
}

std::vector<double> known_values(const std::vector<double>& values, EnergyWindow window) {
  std::vector<double> known;
  for (std::size_t i = window.first; i < std::min(window.last, values.size()); ++i)
    if (!std::isnan(values[i])) known.push_back(values[i]);
  return known;
}

/// Change of the values from the only frame of a window to the nearest beside it that are known.
std::optional<double> change_beside(const std::vector<double>& values, EnergyWindow window) {
  std::optional<double> change;
  const auto compare = [&](std::size_t i, std::size_t j) {
    const double step = std::abs(values[i] - values[j]);
    if (!std::isnan(step)) change = std::max(change.value_or(0), step);
  };
  if (window.frames() != 1 || window.last > values.size()) return change;
  if (window.first > 0) compare(window.first, window.first - 1);
  if (window.last < values.size()) compare(window.first, window.last);
  return change;
}

std::optional<double> together(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return std::nullopt;
  return std::hypot(*a, *b);
}

Value difference(const Value& after, const Value& before) {
  return {after.value - before.value, together(after.error, before.error), after.dimension};
}

/// a/b, errors as of independent numbers; NaN if b is zero.
Value ratio(const Value& a, const Value& b) {
  if (!(std::abs(b.value) > 0)) return {nan, {}, dimension::none};
  Value result{a.value / b.value, {}, dimension::none};
  if (a.error && b.error)
    result.error = std::hypot(*a.error, result.value * *b.error) / std::abs(b.value);
  return result;
}

Value size(Value value) {
  value.value = std::abs(value.value);
  return value;
}

/// e = speed after / speed before, along the centre line.
Value restitution(const ForceCurve& curve, const EnergyWindows& windows) {
  if (curve.outcome == Outcome::stick) return {0, {}, dimension::none};
  if (curve.outcome == Outcome::unresolved || curve.speed.empty()) return {nan, {}, dimension::none};
  return ratio(size(window_mean(curve.speed, windows.after, dimension::velocity)),
               size(window_mean(curve.speed, windows.before, dimension::velocity)));
}

/// Frames at which delta turns, of both kinds, from the first turn on.
std::vector<std::size_t> turns(const ForceCurve& curve) {
  std::vector<std::size_t> all;
  const std::size_t end = curve.phase.size() - 1;
  for (const Cycle& cycle : curve.cycles) {
    all.push_back(cycle.turn);
    if (cycle.end < end) all.push_back(cycle.end);
  }
  return all;
}

/// The last whole periods of a bound pair, from a turn to the last one of its kind: as few of them as
/// hold the frames wanted. Nothing if there is no whole one, or if the ringing has died away since.
std::optional<EnergyWindow> last_periods(const ForceCurve& curve, std::size_t wanted) {
  const std::vector<std::size_t> all = turns(curve);
  if (all.size() < 3) return std::nullopt;
  const std::size_t last = all.back();
  std::size_t k = all.size() - 3;
  if (curve.phase.size() - 1 - last > std::max(wanted, last - all[k])) return std::nullopt;
  while (k >= 2 && last - all[k] < wanted) k -= 2;
  return EnergyWindow{all[k], last};
}

EnergyWindow window_after(const ForceCurve& curve) {
  const std::size_t frames = curve.phase.size();
  const auto separated = static_cast<std::size_t>(
      std::count(curve.phase.begin(), curve.phase.end(), Phase::separated));
  if (separated > 0) return {frames - (separated + 1) / 2, frames};
  const std::size_t wanted = std::max(frames / 10, least_frames_after);
  if (const auto periods = last_periods(curve, wanted)) return *periods;
  return {std::max(curve.cycles.front().turn, frames - std::min(wanted, frames)), frames};
}

/// K_t + W of every frame: what one of them gives the other, as vibrations do, is not seen in it.
std::vector<double> internal(const EnergyCurve& energy) {
  std::vector<double> result = energy.W_total;
  const std::vector<double> thermal = energy.thermal();
  for (std::size_t i = 0; i < result.size(); ++i) result[i] += thermal[i];
  return result;
}

/// Besides the scatter within the windows: the digits of the potential energy, and the change of the
/// total energy, of which it cannot be said where it went.
Value widened(Value value, double rounding, double drift) {
  if (value.error) value.error = std::hypot(*value.error, rounding, drift);
  return value;
}

/// K_p that is still there where the bodies stick: it goes over when the ringing has died away.
Value ringing(const EnergyCurve& energy, const ForceCurve& curve, const EnergyWindows& windows) {
  if (curve.outcome == Outcome::bounce) return {0, {}, dimension::energy};
  return window_mean(energy.K_p_rel, windows.after, dimension::energy);
}

}  // namespace

Value window_mean(const std::vector<double>& values, EnergyWindow window, Dimension dimension) {
  const std::vector<double> known = known_values(values, window);
  const std::size_t n = known.size();
  if (n == 0) return {nan, {}, dimension};
  const double *first = known.data(), *last = first + n;
  Value result{mean(first, last), {}, dimension};
  if (n < 2) {
    result.error = change_beside(values, window);
    return result;
  }
  double squares = 0;
  for (const double value : known) squares += (value - result.value) * (value - result.value);
  const double scatter = std::sqrt(squares / static_cast<double>(n - 1) / static_cast<double>(n));
  const double halves = 0.5 * (mean(first, first + n / 2) - mean(last - n / 2, last));
  result.error = std::max(scatter, std::abs(halves));
  return result;
}

std::optional<EnergyWindows> energy_windows(const ForceCurve& curve) {
  const auto approach = static_cast<std::size_t>(
      std::find_if(curve.phase.begin(), curve.phase.end(),
                   [](Phase phase) { return phase != Phase::approach; }) -
      curve.phase.begin());
  if (!curve.contact || curve.cycles.empty() || approach == 0) return std::nullopt;
  return EnergyWindows{{0, (approach + 1) / 2}, window_after(curve)};
}

EnergyBudget energy_budget(const EnergyCurve& energy, const ForceCurve& curve,
                           const EnergyWindows& windows) {
  const auto change = [&](const std::vector<double>& values) {
    return difference(window_mean(values, windows.after, dimension::energy),
                      window_mean(values, windows.before, dimension::energy));
  };
  EnergyBudget budget;
  budget.windows = windows;
  budget.K_p_initial = window_mean(energy.K_p_rel, windows.before, dimension::energy);
  budget.delta_K_p = change(energy.K_p_rel);
  budget.delta_K_t = change(energy.thermal());
  budget.delta_rotation = change(energy.total_rotation());
  const Value drift = change(energy.total());
  budget.delta_W = widened(change(energy.W_total), energy.W_rounding, drift.value);
  budget.energy_drift = ratio(drift, budget.K_p_initial);
  budget.K_t_share = ratio(budget.delta_K_t, size(budget.delta_K_p));
  budget.W_share = ratio(budget.delta_W, size(budget.delta_K_p));
  const Value rest = ringing(energy, curve, windows);
  budget.ringing = ratio(rest, budget.K_p_initial);
  budget.converted = ratio(
      widened(change(internal(energy)), energy.W_rounding, std::abs(drift.value) + rest.value),
      budget.K_p_initial);
  budget.across = ratio(change(energy.K_p_across), budget.K_p_initial);
  budget.restitution = restitution(curve, windows);
  const Value& e = budget.restitution;
  budget.one_minus_e2 = {1 - e.value * e.value, {}, dimension::none};
  if (e.error) budget.one_minus_e2.error = 2 * e.value * *e.error;
  for (std::size_t b = 0; b < 2; ++b) {
    budget.temperature_before[b] =
        window_mean(energy.temperature[b], windows.before, dimension::none);
    budget.temperature_after[b] = window_mean(energy.temperature[b], windows.after, dimension::none);
  }
  return budget;
}

}  // namespace mdana
