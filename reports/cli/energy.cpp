// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/energy.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/cli/error_option.hpp"
#include "reports/cli/measuring_options.hpp"
#include "reports/exchange.hpp"
#include "reports/inline_run.hpp"
#include "reports/plan.hpp"

namespace mdana::cli {
namespace {

struct Measured {
  const Run& run;
  const Radii& radii;
  const MeasuredMotion& motion;
  const MeasuredEnergy& energy;
  const SweepOptions& sweeping;
};

/// Energies by the final clusters besides.
void tell_exchange(Document& document, const Measured& m, bool wanted) {
  if (!m.energy.budget) return;
  if (!has_atoms(m.run)) return document.left_out("exchanged atoms", needs_atoms);
  const ForceCurve curve = force_curve(m.motion.motion, best_force_source(m.run), m.run.units,
                                       m.radii.sum());
  add_exchange(document, {m.run, m.motion, curve, restitution(m.motion.motion, curve), m.energy.curve,
                          m.energy.budget->windows.after, m.sweeping, wanted});
}

void add_options(Options& options) {
  add_run_options(options);
  add_membership_options(options);
  add_potential_options(options);
  add_error_option(options, "the frame stride");
  add_output_options(options, true);
}

int run_command(const Values& values) {
  check_output(values, true);
  const PotentialOptions potential = potential_options(values);
  const RunOptions options = run_options(values);
  SweepOptions sweeping = sweep_options(values);
  const Run run = prepare_run(options);
  require_two_bodies(run);
  const MotionParts parts = parts_for_energy(run);
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_energy(choose_potential(run, potential).column));
  const Radii radii = find_radii(run, options);
  const auto chosen = choose_stride(values, energy_subject({run, options, sweeping, {}, potential}), sweeping);
  const MeasuredMotion measured = measure_motion(run, parts, std::move(analyses), sweeping);
  const MeasuredEnergy energy =
      measure_energy(run, measured, measured.swept.tables[1], radii, potential);

  Document document("energy", run);
  document.sweep(measured.swept, run.format);
  PlanWishes wishes;
  wishes.potential = potential;
  add_plan(document, plan_command(run, "energy", wishes));
  add_lost_atoms(document, measured.motion);
  add_energy(document, energy);
  tell_exchange(document, {run, radii, measured, energy, sweeping}, values["final-clusters"].as<bool>());
  Table table = energy_table(energy.curve, measured.motion.steps, measured.motion.times);
  if (measured.motion.first_lost > 0)
    table.add_column({"lost", dimension::none}, measured.motion.lost);
  tell_choice(document, chosen);
  return choice_code(chosen, emit(values, document, &table));
}

}  // namespace

extern const Command energy_command;
const Command energy_command{
    "energy",
    "DUMP",
    "where the kinetic energy of the bodies goes: heat, rotation, potential energy",
    "Translation K_p, thermal kinetic energy K_t about the centres of mass, its part in rotation,\n"
    "temperature of each body, potential energy W; what the collision changed of them, shares of\n"
    "|delta K_p|, drift of the total energy. The table (-o FILE.csv) has a row a frame.",
    "  mdana energy sample-data/adhesive-tiny/dump.lammpstrj.gz\n"
    "  mdana energy run/dump.lammpstrj.gz --log run/log.lammps -o energy.csv\n"
    "  mdana energy run/dump.lammpstrj.gz --potential c_pe --json",
    add_options,
    run_command,
    /*on_ranks=*/true};

}  // namespace mdana::cli
