// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analyses/energy.hpp"
#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/cli/error_option.hpp"
#include "reports/measured.hpp"
#include "reports/measured_energy.hpp"
#include "reports/plan.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

constexpr std::array<std::string_view, 4> source_names{"auto", "forces", "velocities", "positions"};

/// Nothing stands for the best that the dump has.
std::optional<ForceSource> source_option(const Values& values) {
  const std::size_t k = choice(values, "source", source_names);
  return k == 0 ? std::nullopt : std::optional(static_cast<ForceSource>(k - 1));
}

/// Velocities are read wherever the dump has them, for v; forces only if asked for.
MotionParts parts(const Run& run, ForceSource source, bool compare) {
  const bool forces = source == ForceSource::forces || (compare && run.first.has_column("fx"));
  return {run.first.has_column("vx") || source == ForceSource::velocities, forces};
}

/// Root mean square difference of the other sources' forces from the chosen one, in contact.
void add_comparison(Document& document, const Run& run, const RelativeMotion& motion,
                    const ForceCurve& curve, ForceSource chosen, Table& table) {
  auto all = nlohmann::ordered_json::object();
  for (const ForceSource source :
       {ForceSource::forces, ForceSource::velocities, ForceSource::positions}) {
    if (!motion.can_give(source)) continue;
    const std::vector<double> force = interparticle_force(motion, source, run.units);
    double sum = 0;
    std::size_t n = 0;
    for (std::size_t i = 0; i < force.size(); ++i)
      if (curve.phase[i] == Phase::loading || curve.phase[i] == Phase::unloading) {
        sum += (force[i] - curve.force[i]) * (force[i] - curve.force[i]);
        ++n;
      }
    const double rms = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(n, 1)));
    const double share = rms / curve.force_max.value;
    all[std::string(name(source))] = {{"rms_difference", rms}, {"share_of_F_max", share}};
    if (source != chosen) {
      document.line(fmt::format("F from {}", name(source)),
                    fmt::format("differs by {:.3g} % of F_max (rms in contact)", 100 * share));
      table.add_column({fmt::format("F_{}", name(source)), dimension::force}, force);
    }
  }
  document.json("sources", std::move(all));
}

/// Positions and velocities tell how the bodies turn.
std::vector<std::unique_ptr<Analysis>> rotation_analysis(const Plan& plan) {
  std::vector<std::unique_ptr<Analysis>> analyses;
  if (plan.has(Part::rotation)) analyses.push_back(make_energy(""));
  return analyses;
}

void tell_rotation(Document& document, const Run& run, const MeasuredMotion& measured,
                   const ForceCurve& curve, Table& table) {
  const EnergyCurve energy =
      energy_curve(measured.swept.tables[0], measured.swept.tables[1], run.units);
  add_rotation(document, energy, curve);
  for (std::size_t b = 0; b < 2; ++b)
    table.add_column({fmt::format("rotation{}", b + 1), dimension::energy}, energy.rotation[b]);
}

void add_options(Options& options) {
  add_run_options(options);
  options.add_options()                                                                     //
      ("source", po::value<std::string>()->default_value("auto")->value_name("NAME"),
       "force from: forces (sum of fx fy fz), velocities (m* dv/dt), positions (m* d2x/dt2), or "
       "auto, the best that the dump has")                                                  //
      ("compare", po::bool_switch(), "compare all sources that the dump has");
  add_error_option(options, "the frame stride");
  add_output_options(options, true);
}

int run_command(const Values& values) {
  check_output(values, true);
  const std::optional<ForceSource> wanted = source_option(values);
  const RunOptions options = run_options(values);
  SweepOptions sweeping = sweep_options(values);
  const Run run = prepare_run(options);
  require_two_bodies(run);
  const bool compare = values["compare"].as<bool>();
  const ForceSource source = wanted ? *wanted : best_force_source(run);
  PlanWishes wishes;
  wishes.source = wanted;
  Plan plan = plan_command(run, "force", wishes);
  const Radii radii = find_radii(run, options);
  const auto chosen = choose_stride(values, force_subject({run, options, sweeping, {}, {}, source}), sweeping);
  const MeasuredMotion measured = measure_motion(run, parts(run, source, compare),
                                                 rotation_analysis(plan), sweeping);
  const ForceCurve curve = touching_force_curve(run, measured.motion, source, radii);

  Document document("force", run);
  document.sweep(measured.swept, run.format);
  add_force(document, curve, source, radii);
  const Restitution e = restitution(measured.motion, curve);
  plan.settle(e, curve.outcome);
  add_plan(document, plan);
  add_restitution(document, e);
  Table table = force_table(curve, measured.motion, measured.swept.tables[0]);
  if (plan.has(Part::rotation)) tell_rotation(document, run, measured, curve, table);
  add_lost_atoms(document, measured.motion);
  warn_of_force(document, curve);
  tell_choice(document, chosen);
  if (compare) add_comparison(document, run, measured.motion, curve, source, table);
  return choice_code(chosen, emit(values, document, &table));
}

}  // namespace

extern const Command force_command;
const Command force_command{
    "force",
    "DUMP",
    "force between the bodies, phases, hysteresis",
    "Centre of mass and velocity of each body, the force between them, F against the mutual\n"
    "approach delta = R1 + R2 - X, its loading and unloading phases and the area of the loop.\n"
    "F > 0 is repulsive, v = d delta/dt > 0 is approach. The table (-o FILE.csv) has a row a frame.",
    "  mdana force sample-data/adhesive-tiny/dump.lammpstrj.gz\n"
    "  mdana force dump.lammpstrj --units lj --timestep 0.005 --radius 29.6 -o force.csv\n"
    "  mdana force sample-data/adhesive-tiny/dump.lammpstrj.gz --error 0.2\n"
    "  mdana force run/dump.lammpstrj.gz --compare --json",
    add_options,
    run_command,
    /*on_ranks=*/true};

}  // namespace mdana::cli
