// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/measured.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analyses/motion.hpp"
#include "readers/input_error.hpp"
#include "reports/inline_run.hpp"

namespace mdana {

MeasuredMotion measure_motion(const Run& run, MotionParts parts,
                              std::vector<std::unique_ptr<Analysis>> others,
                              SweepOptions options) {
  options.selection = run.selection;
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_motion(parts));
  for (auto& other : others) analyses.push_back(std::move(other));
  MeasuredMotion measured;
  measured.swept = sweep_run(run, analyses, options);
  if (measured.swept.steps.size() < 2)
    throw InputError(fmt::format("{}: {} frame used; a collision needs at least two{}",
                                 run.dump.string(), measured.swept.steps.size(),
                                 measured.swept.damage.empty() ? "" : ". " + measured.swept.damage));
  measured.motion = told_of(run, [&] {
    return relative_motion(measured.swept.tables[0], measured.swept.steps,
                           frame_times(run, measured.swept));
  });
  const auto [a, b] = body_motion(measured.swept.tables[0], 0);
  measured.motion.position_noise = rounding_of_means(run, "x", a.atoms, b.atoms, options.dropped_digits);
  if (parts.velocity) measured.motion.velocity_noise = rounding_of_means(run, "vx", a.atoms, b.atoms, options.dropped_digits);
  return measured;
}

ForceCurve touching_force_curve(const Run& run, const RelativeMotion& motion, ForceSource source,
                                const Radii& radii, ForceDerivative by) {
  ForceCurve curve =
      told_of(run, [&] { return force_curve(motion, source, run.units, radii.sum(), by); });
  if (!curve.contact)
    throw InputError(fmt::format(
        "{}: no contact in this dump: the centres come no nearer than {:.6g}, {:.6g} more than the "
        "radii", run.dump.string(), *std::min_element(curve.distance.begin(), curve.distance.end()),
        -curve.delta_max.value));
  if (curve.delta_max.error)
    curve.delta_max.error = std::hypot(*curve.delta_max.error, radii.sum_error);
  return curve;
}

namespace {

/// Of each cycle, and of all together.
void add_loops(Document& document, const ForceCurve& curve) {
  auto list = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < curve.loops.size(); ++k)
    list.push_back({{"frames", {curve.cycles[k].start, curve.cycles[k].turn, curve.cycles[k].end}},
                    {"hysteresis_area", to_json(curve.loops[k].area)},
                    {"kinetic_loss", to_json(curve.loops[k].kinetic_loss)}});
  document.json("loops", std::move(list));
  document.json("all_loops", {{"hysteresis_area", to_json(curve.all_loops.area)},
                              {"kinetic_loss", to_json(curve.all_loops.kinetic_loss)}});
}

void add_off_axis(Document& document, const Restitution& restitution) {
  const std::pair<const char*, const Value&> numbers[] = {
      {"off_axis.impact_parameter", restitution.impact_parameter},
      {"off_axis.tangential_speed_before", restitution.tangential_before},
      {"off_axis.tangential_speed_after", restitution.tangential_after}};
  for (const auto& [name, value] : numbers)
    if (!std::isnan(value.value)) document.number(name, value);
}

}  // namespace

void add_force(Document& document, const ForceCurve& curve, ForceSource source,
               const Radii& radii) {
  document.text("outcome", std::string(name(curve.outcome)));
  document.number("F_max", curve.force_max);
  document.number("F_min_loading", curve.force_min_loading);
  document.number("delta_max", curve.delta_max);
  document.number("hysteresis_area", curve.hysteresis_area);
  document.number("kinetic_loss", curve.kinetic_loss);
  if (!std::isnan(curve.kinetic_loss_total.value))
    document.number("kinetic_loss_total", curve.kinetic_loss_total);
  add_loops(document, curve);
  document.json("force_source", name(source));
  document.line("force from", std::string(description(source)));
  document.number("radius_sum", {radii.sum(), {}, dimension::length});
  document.text("radius_source", radii.source);
  if (curve.window > 0) {
    document.json("derivative_window", curve.window);
    document.line("derivative", fmt::format("over {} frames, degree 4", curve.window));
  }
  document.json("cycles", curve.cycles.size());
  document.line("cycles", fmt::format("{} loading and unloading", curve.cycles.size()));
  document.json("contact_rule",
                fmt::format("|F| at least {} of its maximum, and above its noise",
                            contact_force_fraction));
}

void add_restitution(Document& document, const Restitution& restitution) {
  add_off_axis(document, restitution);
  if (!restitution.reason.empty()) return;
  document.number("e", restitution.e);
  document.number("e_total", restitution.e_total);
  document.number("speed_before", restitution.speed_before);
  if (!std::isnan(restitution.speed_after.value))
    document.number("speed_after", restitution.speed_after);
}

void add_lost_atoms(Document& document, const RelativeMotion& motion) {
  const auto most = std::ranges::max_element(
      motion.lost, {}, [](double lost) { return std::abs(lost); });
  document.json("lost", most == motion.lost.end() ? 0.0 : *most);
  if (motion.first_lost == 0) return;
  document.warn(fmt::format("the bodies have other atoms than in the first frame from frame {} (step {}) "
                            "on: up to {:g} fewer (column lost), {:.2g} % of a body; its centre and "
                            "velocity are those of the atoms that are there",
                            motion.first_lost, motion.steps[motion.first_lost], *most,
                            100 * motion.greatest_loss));
}

void warn_of_force(Document& document, const ForceCurve& curve) {
  if (curve.delta_max.value < 0)
    document.warn("delta is negative even at the greatest compression: the radius is smaller than "
                  "that at which the bodies touch; take R from fit-hertz and give it as --radius");
  if (curve.coarse)
    document.warn("the dump is too coarse for the force from derivatives: every second frame gives one "
                  "that differs by more than 5 % of F_max; dump more often, or dump fx fy fz");
  if (energies_disagree(curve))
    document.warn(fmt::format("the loop area ({:.6g}) and the kinetic energy lost ({:.6g}) differ by more "
                              "than their errors",
                              curve.hysteresis_area.value, curve.kinetic_loss.value));
  if (curve.outcome == Outcome::unresolved)
    document.warn("the dump ends before the bodies separate or turn back: no outcome");
}

}  // namespace mdana
