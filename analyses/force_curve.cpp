// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/force_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analyses/force_series.hpp"
#include "analyses/loop_loss.hpp"
#include "analyses/turning_points.hpp"

namespace mdana {
namespace {

/// First and last frame in contact.
struct Span {
  std::size_t first, last;
};

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

Span contact_span(const std::vector<double>& force) {
  double strongest = 0;
  for (const double f : force) strongest = std::max(strongest, std::abs(f));
  const double limit = std::max(contact_force_fraction * strongest,
                                std::min(4 * noise_of(force), 0.1 * strongest));
  Span span{force.size(), 0};
  for (std::size_t i = 0; i < force.size(); ++i) {
    const bool alone = (i == 0 || std::abs(force[i - 1]) < limit) &&
                       (i + 1 == force.size() || std::abs(force[i + 1]) < limit);
    if (std::abs(force[i]) < limit || alone) continue;
    span.first = std::min(span.first, i);
    span.last = i;
  }
  if (span.first == force.size()) span = {0, force.size() - 1};  // one strong frame: no rule holds
  return span;
}

/// What sampling may have missed of a maximum: twice the rise of a parabola through the greatest
/// sample and its neighbours above it, since the parabola is only the first term.
double missed_above(const std::vector<double>& series) {
  const auto top = std::max_element(series.begin(), series.end());
  if (top == series.begin() || top + 1 == series.end()) return 0;
  const double before = *top - *(top - 1), after = *top - *(top + 1);
  const double slope = 0.5 * (before - after), curvature = before + after;
  return curvature > 0 ? slope * (slope / curvature) : 0;
}

/// What it may have missed of the minimum up to a frame.
double missed_below(const std::vector<double>& series, std::size_t last) {
  std::vector<double> turned;
  for (std::size_t i = 0; i <= last; ++i) turned.push_back(-series[i]);
  return missed_above(turned);
}

/// Integral of the repulsive part of the force over time.
double repulsive_impulse(const ForceCurve& curve, const std::vector<double>& times) {
  double impulse = 0;
  for (std::size_t i = 1; i < times.size(); ++i)
    impulse += 0.5 * (std::max(curve.force[i], 0.0) + std::max(curve.force[i - 1], 0.0)) *
               (times[i] - times[i - 1]);
  return impulse;
}

/// The bodies met if they overlap, or if they pushed each other with a thousandth of their relative
/// momentum, which rounding and overshoot of a derivative do not.
bool have_contact(const ForceCurve& curve, const RelativeMotion& motion, Units units) {
  if (largest(curve.delta) >= 0) return true;
  if (!(largest(curve.force) > 0)) return false;
  const std::vector<double> speeds = squared_speed(motion);
  if (speeds.empty() || motion.times.empty()) return true;
  const double momentum = force_per_mass_acceleration(units) * motion.reduced_mass *
                          std::sqrt(largest(speeds));
  return repulsive_impulse(curve, motion.times) > 1e-3 * momentum;
}

std::vector<Cycle> find_cycles(const std::vector<double>& delta, Span contact) {
  const double rise = largest(delta) - delta[contact.first];
  const std::vector<Turn> turns = turning_points(delta, turning_point_fraction * rise);
  std::vector<Cycle> cycles;
  std::size_t start = 0;
  for (const Turn& turn : turns) {
    if (turn.index < contact.first) continue;
    if (turn.maximum) {
      cycles.push_back({start, turn.index, delta.size() - 1});
    } else {
      if (!cycles.empty()) cycles.back().end = turn.index;
      start = turn.index;
    }
  }
  return cycles;
}

Outcome find_outcome(const ForceCurve& curve, Span contact) {
  if (curve.cycles.empty()) return Outcome::unresolved;
  const std::size_t last = curve.delta.size() - 1;
  const bool receding = curve.delta[last] < curve.delta[last > 0 ? last - 1 : 0];
  if (contact.last < last && receding && curve.cycles.back().end == last) return Outcome::bounce;
  return curve.cycles.front().end < last ? Outcome::stick : Outcome::unresolved;
}

std::vector<Phase> find_phases(const ForceCurve& curve, Span contact) {
  std::vector<Phase> phase(curve.delta.size(), Phase::approach);
  for (std::size_t i = contact.first; i < phase.size(); ++i) phase[i] = Phase::loading;
  for (const Cycle& cycle : curve.cycles)
    for (std::size_t i = cycle.turn + 1; i <= cycle.end; ++i) phase[i] = Phase::unloading;
  if (curve.outcome == Outcome::bounce)
    for (std::size_t i = contact.last + 1; i < phase.size(); ++i) phase[i] = Phase::separated;
  return phase;
}

/// Loop areas and kinetic losses of all cycles, and of the first one by itself. Those of a coarser series
/// begin and end at the same delta as those of `fine`.
void find_losses(const RelativeMotion& motion, Units units, ForceCurve& curve,
                 const ForceCurve* fine) {
  const auto energy = [](double value) { return Value{value, {}, dimension::energy}; };
  const PathEnergies path(motion, units, curve);
  const auto add = [&](const LoopLoss& loss, double low) {
    Loop loop{energy(loss.area), energy(loss.kinetic), low, loss.area_by_time};
    loop.area.error = loss.area_error;
    return loop;
  };
  for (std::size_t k = 0; k < curve.cycles.size(); ++k) {
    const Cycle& cycle = curve.cycles[k];
    const double low = fine && k < fine->loops.size()
                           ? fine->loops[k].low
                           : std::max(curve.delta[cycle.start], curve.delta[cycle.end]);
    const LoopLoss loss = path.of(cycle, low);
    curve.loops.push_back(add(loss, low));
    if (k == 0) curve.kinetic_loss_total = energy(loss.kinetic_total);
  }
  curve.hysteresis_area = curve.loops[0].area;
  curve.kinetic_loss = curve.loops[0].kinetic_loss;
  const LoopLoss all = path.between(curve.cycles.front().start, curve.cycles.back().end);
  curve.all_loops = add(all, std::numeric_limits<double>::quiet_NaN());
}

/// Standard deviation of the integral of F d delta by the noise of single forces (trapezoidal rule).
double area_noise(const ForceCurve& curve, std::size_t first, std::size_t last, double noise) {
  double squares = 0;
  for (std::size_t i = first; i <= last; ++i) {
    const double before = i > first ? curve.delta[i] - curve.delta[i - 1] : 0;
    const double behind = i < last ? curve.delta[i + 1] - curve.delta[i] : 0;
    squares += 0.25 * (before + behind) * (before + behind);
  }
  return noise * std::sqrt(squares);
}

ForceCurve measure(const RelativeMotion& motion, ForceSource source, Units units,
                   double radius_sum, ForceDerivative by, const ForceCurve* fine = nullptr) {
  ForceCurve curve;
  curve.window = by.window;
  curve.distance = motion.distance();
  for (const double x : curve.distance) curve.delta.push_back(radius_sum - x);
  curve.speed = approach_speed(motion);
  curve.force = interparticle_force(motion, source, units, by);
  curve.contact = have_contact(curve, motion, units);
  curve.phase.assign(curve.delta.size(), Phase::approach);
  curve.delta_max = {largest(curve.delta), {}, dimension::length};
  curve.force_max = {largest(curve.force), {}, dimension::force};
  curve.force_min_loading.dimension = dimension::force;
  curve.hysteresis_area = {std::numeric_limits<double>::quiet_NaN(), {}, dimension::energy};
  curve.kinetic_loss = curve.kinetic_loss_total = curve.hysteresis_area;
  curve.all_loops = {curve.hysteresis_area, curve.hysteresis_area};
  if (!curve.contact) return curve;

  const Span contact = contact_span(curve.force);
  curve.cycles = find_cycles(curve.delta, contact);
  curve.outcome = find_outcome(curve, contact);
  curve.phase = find_phases(curve, contact);
  const std::size_t turn = curve.cycles.empty() ? curve.force.size() - 1 : curve.cycles[0].turn;
  curve.force_min_loading.value =
      *std::min_element(curve.force.begin(), curve.force.begin() + static_cast<long>(turn) + 1);
  if (!curve.cycles.empty()) find_losses(motion, units, curve, fine);
  return curve;
}

void widen(Value& value, double difference) {
  value.error = std::max(value.error.value_or(0), std::abs(difference));
}

void widen(Value& value, const Value& coarse) {
  if (std::isnan(value.value) || std::isnan(coarse.value)) return;
  widen(value, value.value - coarse.value);
}

/// Whether the truncation of the derivative is large: at two frames or more, so that the edges of a
/// contact do not count.
bool is_coarse(const ForceSeries& series) {
  const double limit = 0.05 * largest(series.value);
  return std::ranges::count_if(series.truncation, [&](double t) { return t > limit; }) > 5;
}

/// Noise is independent of what sampling does.
void add(Value& value, double noise) {
  if (value.error) value.error = std::hypot(*value.error, noise);
}

/// Of the difference of two kinetic energies.
double kinetic_noise(const RelativeMotion& motion, Units units, const ForceCurve& curve) {
  if (curve.speed.empty()) return 0;
  const double fastest = std::max(largest(curve.speed), -*std::ranges::min_element(curve.speed));
  return std::sqrt(2.0) * motion.reduced_mass * force_per_mass_acceleration(units) * fastest *
         noise_of(curve.speed);
}

/// By how much noise shifts the extreme of values up to a frame: of n that it does not tell apart (within two
/// standard deviations) the greatest is sqrt(2 ln n) standard deviations off.
template <class Noise>
double extreme_noise(const std::vector<double>& series, std::size_t last, double extreme, Noise&& noise_at) {
  const double noise = noise_at(static_cast<std::size_t>(std::ranges::find(series, extreme) - series.begin()));
  const auto near = std::count_if(series.begin(), series.begin() + static_cast<long>(last) + 1,
                                  [&](double value) { return std::abs(value - extreme) <= 2 * noise; });
  return noise * std::max(1.0, std::sqrt(2 * std::log(static_cast<double>(std::max<long>(near, 1)))));
}

void add_noise_of_extremes(const RelativeMotion& motion, const ForceSeries& series, ForceCurve& curve) {
  const auto force = [&](std::size_t i) { return series.noise_at(std::min(i, curve.force.size() - 1)); };
  const auto length = [noise = std::max(motion.position_noise, noise_of(curve.distance))](std::size_t) { return noise; };
  const std::size_t end = curve.force.size() - 1, turn = curve.cycles.empty() ? end : curve.cycles[0].turn;
  add(curve.force_max, extreme_noise(curve.force, end, curve.force_max.value, force));
  add(curve.force_min_loading, extreme_noise(curve.force, turn, curve.force_min_loading.value, force));
  add(curve.delta_max, extreme_noise(curve.delta, end, curve.delta_max.value, length));
}

void add_noise(const RelativeMotion& motion, Units units, double noise, ForceCurve& curve) {
  if (curve.cycles.empty()) return;
  const double kinetic = kinetic_noise(motion, units, curve);
  const auto add_to = [&](Loop& loop, std::size_t first, std::size_t last) {
    const bool seen = curve.window == 0 && !std::isnan(loop.area_by_time);  // by PathEnergies::sampling
    if (!seen) add(loop.area, area_noise(curve, first, last, noise));
    add(loop.kinetic_loss, kinetic);
  };
  for (std::size_t k = 0; k < curve.loops.size(); ++k)
    add_to(curve.loops[k], curve.cycles[k].start, curve.cycles[k].end);
  add_to(curve.all_loops, curve.cycles.front().start, curve.cycles.back().end);
  add(curve.kinetic_loss_total, kinetic);
}

/// Whether a cycle in every second frame from `first` on turns and ends where one in all frames does, up
/// to a frame of the coarse series.
bool same_cycle(const Cycle& fine, const Cycle& coarse, std::size_t first) {
  const auto near = [&](std::size_t i, std::size_t half) {
    const std::size_t j = 2 * half + first;
    return (i > j ? i - j : j - i) <= 2;
  };
  return near(fine.start, coarse.start) && near(fine.turn, coarse.turn) && near(fine.end, coarse.end);
}

/// The area by time hardly depends on sampling that resolves the force, trapezoids over delta do.
void widen(Loop& loop, const Loop& coarse) {
  if (std::isnan(loop.area_by_time) || std::isnan(coarse.area_by_time))
    widen(loop.area, coarse.area);
  else
    widen(loop.area, loop.area_by_time - coarse.area_by_time);
  widen(loop.kinetic_loss, coarse.kinetic_loss);
}

/// Losses by every second frame from `first` on, as far as they show the same cycles.
void widen_losses(const ForceCurve& coarse, std::size_t first, ForceCurve& curve) {
  std::size_t same = 0;
  while (same < std::min(curve.cycles.size(), coarse.cycles.size()) &&
         same_cycle(curve.cycles[same], coarse.cycles[same], first)) {
    widen(curve.loops[same], coarse.loops[same]);
    ++same;
  }
  if (same > 0) widen(curve.kinetic_loss_total, coarse.kinetic_loss_total);
  if (same > 0 && same == curve.cycles.size() && same == coarse.cycles.size())
    widen(curve.all_loops, coarse.all_loops);
}

}  // namespace

bool energies_disagree(const ForceCurve& curve) {
  const Value &area = curve.hysteresis_area, &loss = curve.kinetic_loss;
  if (std::isnan(area.value) || std::isnan(loss.value) || !area.error || !loss.error) return false;
  const double rounding = 1e-9 * (std::abs(area.value) + std::abs(loss.value));
  return std::abs(area.value - loss.value) > 2 * std::hypot(*area.error, *loss.error) + rounding;
}

std::string_view name(Phase phase) {
  constexpr std::array<std::string_view, 4> names{"approach", "loading", "unloading", "separated"};
  return names[static_cast<std::size_t>(phase)];
}

std::string_view name(Outcome outcome) {
  constexpr std::array<std::string_view, 3> names{"bounce", "stick", "unresolved"};
  return names[static_cast<std::size_t>(outcome)];
}

ForceCurve force_curve(const RelativeMotion& motion, ForceSource source, Units units,
                       double radius_sum, ForceDerivative by) {
  const ForceSeries series = force_series(motion, source, units, by);
  by.window = series.window;
  ForceCurve curve = measure(motion, source, units, radius_sum, by);
  for (std::size_t i = 0; i < curve.force.size(); ++i) curve.force_error.push_back(series.error(i));
  if (!curve.contact || motion.frames() / 2 <= by.degree) return curve;
  curve.coarse = is_coarse(series);
  widen(curve.force_max, missed_above(curve.force));
  widen(curve.force_min_loading, missed_below(curve.force, curve.cycles.empty() ? curve.force.size() - 1 : curve.cycles[0].turn));
  widen(curve.delta_max, missed_above(curve.delta));
  for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {
    const ForceCurve coarse = measure(motion.subset(first, 2), source, units, radius_sum, by, &curve);
    widen(curve.force_max, coarse.force_max);
    widen(curve.force_min_loading, coarse.force_min_loading);
    widen(curve.delta_max, coarse.delta_max);
    widen_losses(coarse, first, curve);
  }
  add_noise_of_extremes(motion, series, curve);
  add_noise(motion, units, series.noise, curve);
  if (curve.loops.empty()) return curve;
  curve.hysteresis_area = curve.loops[0].area;
  curve.kinetic_loss = curve.loops[0].kinetic_loss;
  return curve;
}

Table force_table(const ForceCurve& curve, const RelativeMotion& motion, const Table& bodies) {
  Table table;
  table.add_column({"step", dimension::none},
                   std::vector<double>(motion.steps.begin(), motion.steps.end()));
  if (!motion.times.empty()) table.add_column({"time", dimension::time}, motion.times);
  table.add_column({"X", dimension::length}, curve.distance);
  table.add_column({"delta", dimension::length}, curve.delta);
  if (!curve.speed.empty()) table.add_column({"v", dimension::velocity}, curve.speed);
  table.add_column({"F", dimension::force}, curve.force);
  table.add_column({"F_error", dimension::force}, curve.force_error);
  std::vector<std::string> labels;
  for (const Phase p : {Phase::approach, Phase::loading, Phase::unloading, Phase::separated})
    labels.emplace_back(name(p));
  std::vector<double> phase;
  for (const Phase p : curve.phase) phase.push_back(static_cast<double>(p));
  table.add_column({"phase", dimension::none, std::move(labels)}, std::move(phase));
  if (!motion.lost.empty()) table.add_column({"lost", dimension::none}, motion.lost);
  for (std::size_t k = 0; k < bodies.columns().size(); ++k) {
    const ColumnSpec& spec = bodies.columns()[k];
    const auto values = bodies.column(k);
    if (spec.dimension == dimension::length || spec.dimension == dimension::velocity)
      table.add_column(spec, {values.begin(), values.end()});
  }
  return table;
}

}  // namespace mdana
