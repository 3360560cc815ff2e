// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/run.hpp"

#include <fmt/format.h>

#include "analyses/gyration.hpp"
#include "readers/inline_log.hpp"
#include "readers/input_error.hpp"
#include "readers/positions.hpp"
#include "readers/trajectory.hpp"
#include "reports/inline_run.hpp"

namespace mdana {
namespace {

Radii gyration_radii(const Run& run) {
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_motion({}));  // first: it checks that both bodies are there
  analyses.push_back(make_gyration());
  SweepOptions options;
  options.frames = 1;
  options.selection = run.selection;
  const SweepResult swept = sweep_run(run, analyses, options);
  return {{swept.tables[1].column("radius1")[0], swept.tables[1].column("radius2")[0]},
          "sqrt(5/3) r_g of the first frame", 0};
}

/// So many steps that the time of one is lost in rounding to a millionth.
bool starts_late(const FrameHeader& first) { return std::abs(first.step) > std::int64_t{1} << 32; }

}  // namespace

StatedUnits find_units(const RunOptions& options, const FrameHeader& first, const Scene& scene) {
  const std::pair<std::optional<Units>, std::string> statements[] = {
      {options.units, "option"}, {first.units, "dump"}, {scene.units, "scene"}};
  std::optional<StatedUnits> found;
  for (const auto& [units, source] : statements) {
    if (!units) continue;
    if (found && found->units != *units)
      throw InputError(fmt::format("{}: units {} by the {}, but {} by the {} {}",
                                   options.dump.string(), name(found->units), found->source,
                                   name(*units), source,
                                   source == "scene" ? scene.file.string() : ""));
    if (!found) found = StatedUnits{*units, source};
  }
  if (found) return *found;
  throw InputError(fmt::format("{}: the dump does not state its units; add --units NAME (one of {}) "
                               "or a scene file", options.dump.string(), units_names()));
}

Masses find_masses(const RunOptions& options, const FrameHeader& first, const Scene& scene,
                   Units units, std::vector<std::string>& warnings) {
  const auto need_type = [&](const char* source) {
    if (!first.has_column("type"))
      throw InputError(fmt::format("{}: masses by type from the {}, but no column 'type'",
                                   first.place, source));
  };
  if (!options.masses.empty()) {
    need_type("option");
    return Masses::by_type(options.masses, "option");
  }
  if (first.has_column("mass")) return Masses::from_column("dump");
  if (!scene.masses.empty()) {
    need_type("scene file");
    return Masses::by_type(scene.masses, "scene");
  }
  if (units == Units::lj) {
    warnings.push_back("no masses are stated: every atom has mass 1 (lj units)");
    return Masses::uniform("1 for every atom (assumed, lj units)");
  }
  throw InputError(fmt::format("{}: no masses; add --masses TYPE=MASS,... or a scene file, or dump "
                               "the column 'mass'", options.dump.string()));
}

Scene find_scene(const RunOptions& options) {
  return options.scene.empty() ? scene_beside(options.dump) : load_scene(options.scene);
}

Run prepare_run(const RunOptions& options) {
  if (is_inline_log(options.dump)) return inline_run(options);
  FrameHeader first = first_header(options.dump);
  if (first.atoms == 0)
    throw InputError(fmt::format("{}: the first frame has no atoms", first.place));
  Scene scene = find_scene(options);
  if (!position_source(first.columns))
    throw InputError(fmt::format("{}: no position columns (x y z, xs, xu or xsu) in the dump; it has "
                                 "{}", first.place, fmt::join(first.columns, " ")));
  const StatedUnits units = find_units(options, first, scene);
  if (options.physical && units.units != Units::lj)
    throw InputError(fmt::format("{}: --physical tells what the units lj stand for, but these are {} "
                                 "(by the {})", options.dump.string(), name(units.units),
                                 units.source));
  std::vector<std::string> warnings;
  Masses masses = find_masses(options, first, scene, units.units, warnings);
  const bool own_rule = !options.bodies.empty();
  Bodies bodies = find_bodies(options.dump, first, own_rule ? options.bodies : scene.bodies,
                              options.selection);
  const auto timestep = options.timestep ? options.timestep : scene.timestep;
  const std::string timestep_source =
      options.timestep ? "option" : first.time ? "dump" : scene.timestep ? "scene" : "unknown";
  if (timestep && timestep_source != "dump" && starts_late(first))
    warnings.push_back(fmt::format("steps begin at {}: times count from the first frame, since so many time steps "
                                   "would round them", first.step));
  return {options.dump, format_of(options.dump), std::move(first), std::move(scene), units.units,
          units.source, timestep, timestep_source, std::move(masses), std::move(bodies),
          options.selection, std::move(warnings), options.physical};
}

void require_two_bodies(const Run& run) {
  if (run.bodies.count() == 2) return;
  throw InputError(fmt::format("{}: {} {} found by {}; exactly two are needed. Try another --bodies "
                               "(type, mol, clusters, id:FIRST-LAST)", run.dump.string(),
                               run.bodies.count(), run.bodies.count() == 1 ? "body" : "bodies",
                               run.bodies.rule()));
}

Radii find_radii(const Run& run, const RunOptions& options) {
  if (options.radius) return {*options.radius, "option", 0, true};
  if (run.scene.radii.size() == 2) {
    const std::string& how = run.scene.radius_definition;
    return {{run.scene.radii[0], run.scene.radii[1]},
            how.empty() ? "scene" : fmt::format("scene ({} radius)", how), 0, true};
  }
  return gyration_radii(run);
}

double half_layer(const Run& run, std::optional<double> thickness) {
  if (thickness) return 0.5 * *thickness;
  if (run.scene.sigma) return 0.5 * *run.scene.sigma;
  if (run.units == Units::lj) return 0.5;
  throw InputError(fmt::format("{}: the thickness of the contact layer is one sigma of the "
                               "potential, which is not known; add --layer LENGTH or sigma in the "
                               "scene file", run.dump.string()));
}

std::vector<double> frame_times(const Run& run, const SweepResult& swept) {
  if (run.timestep_source == "dump") return swept.stated_times;
  std::vector<double> times;
  if (!run.timestep) return times;
  const std::int64_t origin = starts_late(run.first) ? run.first.step : 0;
  for (const std::int64_t step : swept.steps)
    times.push_back(static_cast<double>(step - origin) * *run.timestep);
  return times;
}

ForceSource best_force_source(const Run& run) {
  const auto has_all = [&](std::initializer_list<const char*> names) {
    for (const char* n : names)
      if (!run.first.has_column(n)) return false;
    return true;
  };
  if (has_all({"fx", "fy", "fz"})) return ForceSource::forces;
  if (!run.first.time && !run.timestep)
    throw InputError(fmt::format("{}: without forces (fx fy fz) the force is a derivative by time, "
                                 "and the time between frames is unknown; add --timestep DT, or dump "
                                 "with 'dump_modify time yes'", run.dump.string()));
  return has_all({"vx", "vy", "vz"}) ? ForceSource::velocities : ForceSource::positions;
}

MotionParts parts_for(ForceSource source) {
  return {source == ForceSource::velocities, source == ForceSource::forces};
}

}  // namespace mdana
