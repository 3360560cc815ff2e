// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "analyses/motion.hpp"
#include "fits/followed_collision.hpp"
#include "readers/input_error.hpp"
#include "reports/compressed.hpp"
#include "reports/observations.hpp"

namespace mdana {
namespace {

Measured measured(const Value& value) {
  Measured m{value.value, value.error.value_or(0)};
  if (!(m.error > 0)) m.error = Measured().error;
  return m;
}

/// What one pass over a dump tells.
struct DumpMeasured {
  Run run;
  Radii radii;
  MeasuredMotion motion;
  ForceCurve curve;
  double mass_unit;  ///< see force_per_mass_acceleration

  std::string place() const { return run.dump.string(); }
};

DumpMeasured measure(const std::filesystem::path& dump, const ObservationSettings& settings) {
  RunOptions options;
  options.dump = dump;
  if (settings.radius) options.radius = {*settings.radius, *settings.radius};
  DumpMeasured m{prepare_run(options), {}, {}, {}, 1};
  require_two_bodies(m.run);
  m.radii = find_radii(m.run, options);
  const ForceSource source = best_force_source(m.run);
  MotionParts parts = parts_for(source);
  parts.velocity = m.run.first.has_column("vx");
  m.motion = measure_motion(m.run, parts, {}, settings.sweeping);
  m.curve = touching_force_curve(m.run, m.motion.motion, source, m.radii);
  m.mass_unit = force_per_mass_acceleration(m.run.units);
  return m;
}

ObservedCollision restitution_of(const DumpMeasured& m) {
  const Restitution r = restitution(m.motion.motion, m.curve);
  if (!r.reason.empty() || !(r.speed_before.value > 0))
    throw InputError(fmt::format("{}: e is not determined: {}", m.place(), r.reason));
  ObservedCollision c;
  c.given = {{"v", r.speed_before.value}};
  c.stuck = m.curve.outcome == Outcome::stick;
  c.e = measured(r.e);
  return c;
}

ObservedCollision compression_of(const DumpMeasured& m) {
  const Restitution r = restitution(m.motion.motion, m.curve);
  const MaximumCompression most = maximum_compression(approach_by_membership(m.motion.motion), m.radii.sum());
  for (const std::string& reason : {most.delta_reason, most.time_reason})
    if (!reason.empty()) throw InputError(fmt::format("{}: {}", m.place(), reason));
  if (!(r.speed_before.value > 0)) throw InputError(fmt::format("{}: the speed before contact is not known", m.place()));
  ObservedCollision c;
  c.given = {{"v", r.speed_before.value}};
  c.delta_max = measured(most.delta);
  c.t_max = measured(most.time);
  return c;
}

ObservedCollision followed(const DumpMeasured& m) {
  const std::vector<double>& times = m.motion.motion.times;
  if (times.empty()) throw InputError(m.place() + ": the times of the frames are not known: state the time step in the scene");
  std::vector<MotionSample> rows;
  for (std::size_t i = 0; i < times.size(); ++i) {
    rows.push_back({times[i], {m.curve.delta[i], {}}, {}, {m.curve.force[i], {}}});
    if (!m.curve.speed.empty()) rows.back().velocity.value = m.curve.speed[i];
  }
  return followed_collision(rows, m.place());
}

}  // namespace

ObservedDump observe_dump(const std::filesystem::path& dump, const ObservationSettings& settings) {
  const DumpMeasured m = measure(dump, settings);
  ObservedCollision c = settings.wanted == Wanted::motion        ? followed(m)
                        : settings.wanted == Wanted::compression ? compression_of(m)
                                                                 : restitution_of(m);
  c.place = m.place();
  give_both(c.given, "R", m.radii.value[0], m.radii.value[1]);
  const auto [first, second] = body_motion(m.motion.swept.tables[0], 0);
  give_both(c.given, "m", m.mass_unit * first.mass, m.mass_unit * second.mass);
  return {std::move(c), m.motion.swept.inputs, std::string(m.run.format)};
}

}  // namespace mdana
