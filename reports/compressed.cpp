// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/compressed.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "analyses/halves.hpp"
#include "readers/input_error.hpp"
#include "reports/network.hpp"

namespace mdana {
namespace {

constexpr double alike = 0.01;          ///< relative: bodies of one kind
constexpr double splits_differ = 0.01;  ///< relative, beyond which it is worth a warning

bool nearly(double a, double b) { return std::abs(a - b) <= alike * std::max(a, b); }

double cube(double x) { return x * x * x; }

/// v_rel by the derivative if it was not measured; without it if frames are too few.
ApproachSeries approach_by_sign(const RelativeMotion& motion, const Table& halves) {
  const auto distance = halves.column("half_distance");
  ApproachSeries series{motion.times, {distance.begin(), distance.end()}, {},
                        motion.position_noise, motion.velocity_noise};
  if (halves.has("half_speed")) {
    const auto speed = halves.column("half_speed");
    series.speed.assign(speed.begin(), speed.end());
    return series;
  }
  if (motion.frames() <= first_derivative.degree) return series;
  const Eigen::Map<const Eigen::RowVectorXd> row(distance.data(), motion.frames());
  const Eigen::MatrixXd rate = derivative(motion.times, row, first_derivative);
  for (Eigen::Index i = 0; i < rate.cols(); ++i) series.speed.push_back(-rate(0, i));
  return series;
}

void require_times(const Run& run) {
  if (run.first.time || run.timestep) return;
  throw InputError(fmt::format("{}: {}", run.dump.string(), times_not_known));
}

/// As mdana network counts contacts, in the first frame that is used.
void count_contacts(const Run& run, SweepOptions sweeping, CompressedRun& result) {
  sweeping.frames = 1;
  sweeping.progress = nullptr;
  try {
    const NetworkSetup setup = network_setup(run, result.radii, {});
    const Table table = measure_network(run, result.radii, setup, sweeping).table;
    result.coordination = {table.column("coordination")[0], table.column("coordination_error")[0], dimension::none};
  } catch (const InputError& error) {
    result.no_coordination = error.what();
  }
}

void tell_coordination(Document& document, const CompressedRun& run) {
  if (run.no_coordination.empty()) return document.number("coordination", run.coordination);
  document.json("coordination", nullptr);
}

/// Damage that ended the dump before the bodies met is part of the reason.
ForceCurve curve_of(const Run& run, const MeasuredMotion& measured, ForceSource source, const Radii& radii) {
  try {
    return touching_force_curve(run, measured.motion, source, radii);
  } catch (const InputError& error) {
    if (measured.swept.damage.empty()) throw;
    throw InputError(fmt::format("{}. {}", error.what(), measured.swept.damage));
  }
}

Value over(const Value& value, double length) {
  Value ratio{value.value / length, {}, dimension::none};
  if (value.error) ratio.error = *value.error / length;
  return ratio;
}

/// With an error that is the same for all runs beside it.
Value with(Value value, double error) {
  if (value.error) value.error = std::hypot(*value.error, error);
  return value;
}

/// What radii and offset leave of doubt in 2 R_eff.
double doubt_of_touch(const CompressedRun& run, const SurfaceOffset& offset) {
  return std::hypot(run.radii.sum_error, 2 * offset.value.error.value_or(0));
}

void tell_maximum(Document& document, const CompressedRun& run, const Compressing& c, Split split,
                  const SurfaceOffset& offset) {
  const MaximumCompression& best = c.by[static_cast<std::size_t>(split)];
  const double doubt = doubt_of_touch(run, offset);
  Value delta = best.delta;
  delta.value += 2 * offset.value.value;
  delta = with(delta, run.radii.sum_error);
  document.number("delta_max", delta);
  document.number("delta_max_over_R", over(delta, run.radius()));
  const Value effective = with(best.delta, doubt);
  document.number("delta_max_eff", effective);
  document.number("delta_max_over_R_eff", over(effective, c.effective_radius));
  document.number("t_max", with(best.time, doubt / c.impact.velocity));
  document.text("offset_source", offset.source);
  for (const auto& [what, reason] : {std::pair{"delta_max", &best.delta_reason}, {"t_max", &best.time_reason}}) {
    if (reason->empty()) continue;
    document.left_out(what, *reason);
    document.warn(fmt::format("no {}: {}", what, *reason));
  }
}

void tell_splits(Document& document, const Compressing& c, const SurfaceOffset& offset) {
  for (std::size_t k = 0; k < 2; ++k) {
    Value delta = c.by[k].delta;
    delta.value += 2 * offset.value.value;
    document.number(fmt::format("by_{}.delta_max", split_names[k]), delta);
    document.number(fmt::format("by_{}.t_max", split_names[k]), c.by[k].time);
  }
  const double a = c.by[0].delta.value, b = c.by[1].delta.value;
  if (!std::isnan(a - b) && std::abs(a - b) > splits_differ * std::max(a, b))
    document.warn(fmt::format("delta_max by sign and by membership differ by {:.2g} %: many atoms have crossed the "
                              "contact plane", 100 * std::abs(a - b) / std::max(a, b)));
}

void tell_bodies(Document& document, const CompressedRun& run, const Compressing& c) {
  document.number("R_agg", {run.radius(), {}, dimension::length});
  document.text("radius_source", run.radii.source);
  document.number("R_eff", {c.effective_radius, {}, dimension::length});
  document.number("rho", {c.density, {}, Dimension{1, -3, 0}});
  if (run.filling_factor) document.number("phi", {*run.filling_factor, {}, dimension::none});
  const double unit = force_per_mass_acceleration(run.units);
  document.number("m_star", {c.impact.mass / unit, {}, dimension::mass});
  document.number("m_star_counted", {c.counted_mass / unit, {}, dimension::mass});
  if (!run.equal_bodies())
    document.warn("the bodies are not equal: R_agg is the mean of their radii, and the formulas of the paper are for "
                  "equal ones");
}

/// Greatest speed of receding after the turn and when; its error the change to the neighbouring frames.
void tell_receding(Document& document, const ApproachSeries& series, const MaximumCompression& best) {
  if (std::isnan(best.turn_time)) return;
  const auto begin = std::ranges::upper_bound(series.times, best.turn_time) - series.times.begin();
  if (begin + 1 >= std::ssize(series.times)) return;
  const auto at = std::ranges::min_element(series.speed.begin() + begin, series.speed.end());
  double change = std::abs(*at - *(at - 1));
  if (at + 1 != series.speed.end()) change = std::max(change, std::abs(*at - *(at + 1)));
  const auto k = static_cast<std::size_t>(at - series.speed.begin());
  document.number("return.greatest_speed", {-*at, change, dimension::velocity});
  if (best.time_reason.empty())
    document.number("return.time_of_greatest_speed", {series.times[k] - best.contact_time,
                                                      series.times[k] - series.times[k - 1], dimension::time});
}

void tell_oscillation(Document& document, const CompressedRun& run) {
  const auto& cycles = run.curve.cycles;
  const auto& times = run.measured.motion.times;
  document.json("return.cycles", cycles.size());
  if (run.curve.outcome != Outcome::stick || cycles.size() < 2) return;
  const Cycle &first = cycles[0], &second = cycles[1];
  document.number("return.oscillation_period", {times[second.turn] - times[first.turn],
                                                times[second.turn] - times[second.turn - 1], dimension::time});
  document.number("return.oscillation_amplitude",
                  {0.5 * (run.curve.delta[second.turn] - run.curve.delta[first.end]), {}, dimension::length});
}

void tell_return(Document& document, const CompressedRun& run, const Compressing& c, Split split) {
  const auto k = static_cast<std::size_t>(split);
  const Restitution& r = run.restitution;
  add_restitution(document, r);
  if (!r.reason.empty() && !std::isnan(r.speed_before.value)) document.number("speed_before", r.speed_before);
  tell_receding(document, run.series[k], c.by[k]);
  tell_oscillation(document, run);
  if (run.interaction == Interaction::aggregate)
    document.text("return.note", "LAMMPS' granular JKR breaks contacts at -0.397 delta_0 instead of -0.825: compression "
                                 "is that of the paper, the return phase is not");
}

std::vector<double> deltas(const ApproachSeries& series, double radius_sum) {
  std::vector<double> delta;
  for (const double x : series.distance) delta.push_back(radius_sum - x);
  return delta;
}

}  // namespace

bool CompressedRun::equal_bodies() const {
  return nearly(radii.value[0], radii.value[1]) && nearly(mass[0], mass[1]);
}

ApproachSeries approach_by_membership(const RelativeMotion& motion) {
  return {motion.times, motion.distance(), approach_speed(motion), motion.position_noise, motion.velocity_noise};
}

CompressedRun measure_compression(const Run& run, const RunOptions& options, const SweepOptions& sweeping) {
  require_times(run);
  CompressedRun result;
  result.dump = run.dump.string();
  result.units = run.units;
  result.interaction = run.scene.interaction;
  result.filling_factor = run.scene.filling_factor;
  result.radii = find_radii(run, options);
  const bool velocity = run.first.has_column("vx");
  const ForceSource source = best_force_source(run);
  std::vector<std::unique_ptr<Analysis>> halves;
  halves.push_back(make_halves(result.radii.value, velocity));
  result.measured = measure_motion(run, {velocity, source == ForceSource::forces}, std::move(halves), sweeping);
  const RelativeMotion& motion = result.measured.motion;
  const auto bodies = body_motion(result.measured.swept.tables[0], 0);
  result.mass = {bodies[0].mass, bodies[1].mass};
  result.curve = curve_of(run, result.measured, source, result.radii);
  result.restitution = restitution(motion, result.curve);
  result.series = {approach_by_sign(motion, result.measured.swept.tables[1]), approach_by_membership(motion)};
  count_contacts(run, sweeping, result);
  return result;
}

void settle(Plan& plan, const CompressedRun& run) {
  plan.settle(run.restitution, run.curve.outcome);
  if (!run.no_coordination.empty()) plan.leave_out(Part::coordination, run.no_coordination);
}

Compressing compressing(const CompressedRun& run, const SurfaceOffset& offset) {
  const double off = offset.value.value, unit = force_per_mass_acceleration(run.units);
  Compressing c;
  c.effective_radius = run.radius() - off;
  if (!(c.effective_radius > 0))
    throw InputError(fmt::format("{}: an offset of {:g} leaves nothing of R_agg = {:g}", run.dump, off, run.radius()));
  std::array<double, 2> radius{}, mass{};
  for (std::size_t b = 0; b < 2; ++b) {
    radius[b] = run.radii.value[b] - off;
    mass[b] = unit * run.mass[b] * cube(radius[b] / run.radii.value[b]);
  }
  for (std::size_t k = 0; k < 2; ++k) c.by[k] = maximum_compression(run.series[k], run.radii.sum() - 2 * off);
  const double volume = 4 * std::numbers::pi / 3 * (cube(run.radii.value[0]) + cube(run.radii.value[1]));
  c.density = (run.mass[0] + run.mass[1]) / volume;
  c.impact = {reduced(radius[0], radius[1]), reduced(mass[0], mass[1]), 0, run.restitution.speed_before.value};
  c.counted_mass = unit * reduced(run.mass[0], run.mass[1]);
  return c;
}

void add_compression(Document& document, const CompressedRun& run, Split split, const SurfaceOffset& offset) {
  const Compressing c = compressing(run, offset);
  document.text("split", std::string(split_names[static_cast<std::size_t>(split)]));
  document.text("outcome", std::string(name(run.curve.outcome)));
  tell_maximum(document, run, c, split, offset);
  tell_splits(document, c, offset);
  tell_bodies(document, run, c);
  tell_return(document, run, c, split);
  tell_coordination(document, run);
  add_lost_atoms(document, run.measured.motion);
  if (run.curve.outcome == Outcome::unresolved)
    document.warn("the dump ends before the bodies separate or turn back: no outcome");
}

Table compression_table(const CompressedRun& run, Split split) {
  const RelativeMotion& motion = run.measured.motion;
  Table table;
  table.add_column({"step", dimension::none}, {motion.steps.begin(), motion.steps.end()});
  table.add_column({"time", dimension::time}, motion.times);
  const auto add = [&](const std::string& suffix, Split which) {
    const ApproachSeries& series = run.series[static_cast<std::size_t>(which)];
    table.add_column({"delta" + suffix, dimension::length}, deltas(series, run.radii.sum()));
    if (series.known()) table.add_column({"v_rel" + suffix, dimension::velocity}, series.speed);
  };
  add("", split);
  add("_sign", Split::sign);
  add("_membership", Split::membership);
  const Table& halves = run.measured.swept.tables[1];
  for (const char* column : {"half_atoms1", "half_atoms2"}) {
    const auto atoms = halves.column(column);
    table.add_column({column, dimension::none}, {atoms.begin(), atoms.end()});
  }
  return table;
}

}  // namespace mdana
