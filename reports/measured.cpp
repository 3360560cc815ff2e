// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/measured.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {

MeasuredMotion measure_motion(const Run& run, MotionParts parts,
                              std::vector<std::unique_ptr<Analysis>> others,
                              SweepOptions options) {
  options.selection = run.selection;
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_motion(parts));
  for (auto& other : others) analyses.push_back(std::move(other));
  MeasuredMotion measured;
  measured.swept = sweep(run.dump, run.bodies, run.masses, analyses, options);
  if (measured.swept.steps.size() < 2)
    throw InputError(fmt::format("{}: {} frame used; a collision needs at least two{}",
                                 run.dump.string(), measured.swept.steps.size(),
                                 measured.swept.damage.empty() ? "" : ". " + measured.swept.damage));
  measured.motion = told_of(run, [&] {
    return relative_motion(measured.swept.tables[0], measured.swept.steps,
                           frame_times(run, measured.swept));
  });
  return measured;
}

ForceCurve touching_force_curve(const Run& run, const RelativeMotion& motion, ForceSource source,
                                const Radii& radii) {
  ForceCurve curve =
      told_of(run, [&] { return force_curve(motion, source, run.units, radii.sum()); });
  if (!curve.contact)
    throw InputError(fmt::format(
        "{}: no contact in this dump: the centres come no nearer than {:.6g}, {:.6g} more than the "
        "radii", run.dump.string(), *std::min_element(curve.distance.begin(), curve.distance.end()),
        -curve.delta_max.value));
  if (curve.delta_max.error)
    curve.delta_max.error = std::hypot(*curve.delta_max.error, radii.sum_error);
  return curve;
}

void add_force(Document& document, const ForceCurve& curve, ForceSource source,
               const Radii& radii) {
  document.text("outcome", std::string(name(curve.outcome)));
  document.number("F_max", curve.force_max);
  document.number("F_min_loading", curve.force_min_loading);
  document.number("delta_max", curve.delta_max);
  document.number("hysteresis_area", curve.hysteresis_area);
  document.json("force_source", name(source));
  document.line("force from", std::string(description(source)));
  document.number("radius_sum", {radii.sum(), {}, dimension::length});
  document.text("radius_source", radii.source);
  document.json("cycles", curve.cycles.size());
  document.line("cycles", fmt::format("{} loading and unloading", curve.cycles.size()));
  document.json("contact_rule",
                fmt::format("|F| at least {} of its maximum, and above its noise",
                            contact_force_fraction));
}

void warn_of_force(Document& document, const ForceCurve& curve) {
  if (curve.delta_max.value < 0)
    document.warn("delta is negative even at the greatest compression: the radius is smaller than "
                  "that at which the bodies touch; take R from fit-hertz and give it as --radius");
  if (curve.outcome == Outcome::unresolved)
    document.warn("the dump ends before the bodies separate or turn back: no outcome");
}

}  // namespace mdana
