// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/force_law.hpp"
#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/cli/error_option.hpp"
#include "reports/cli/measuring_options.hpp"
#include "reports/measured.hpp"
#include "reports/plan.hpp"

namespace mdana::cli {
namespace {

std::vector<double> approach(const RelativeMotion& motion, double radius_sum) {
  std::vector<double> delta;
  for (const double x : motion.distance()) delta.push_back(radius_sum - x);
  return delta;
}

/// step, [time,] X, delta, and the columns of the analyses.
Table contact_table(const MeasuredMotion& measured, const std::vector<double>& delta) {
  Table table;
  const RelativeMotion& motion = measured.motion;
  table.add_column({"step", dimension::none},
                   std::vector<double>(motion.steps.begin(), motion.steps.end()));
  if (!motion.times.empty()) table.add_column({"time", dimension::time}, motion.times);
  table.add_column({"X", dimension::length}, motion.distance());
  table.add_column({"delta", dimension::length}, delta);
  add_contact_columns(table, measured);
  return table;
}

/// Columns a_hertz and a_jkr, as far as their constants are known.
void add_laws(Document& document, Table& table, const std::vector<double>& delta,
              const Radii& radii, const Material& material, const Plan& plan) {
  const double reduced = radii.value[0] * (radii.value[1] / radii.sum());
  if (const ForceLaw* hertz = find_force_law("hertz"))
    add_law_column(table, delta, *hertz, {reduced, 0, 0});
  else
    document.left_out("a_hertz", "this build has no such law");
  if (plan.has(Part::jkr))
    add_law_column(table, delta, *find_force_law("jkr"), {reduced, *material.modulus, *material.surface_energy});
}

void add_options(Options& options) {
  add_run_options(options);
  add_contact_options(options);
  add_material_options(options);
  add_error_option(options, "the frame stride");
  add_output_options(options, true);
}

void require_touch(const Run& run, const ContactNumbers& numbers) {
  if (numbers.touch()) return;
  throw InputError(run.dump.string() + ": no contact in this dump: the layer about the contact "
                                       "plane never holds atoms of both bodies (repulsive bodies "
                                       "under a small load keep farther apart: try a thicker "
                                       "--layer)");
}

int run_command(const Values& values) {
  check_output(values, true);
  const RunOptions options = run_options(values);
  SweepOptions sweeping = sweep_options(values);
  const ContactOptions contact = contact_options(values);
  material_options(values, {});  // a usage error comes before work
  const Run run = prepare_run(options);
  require_two_bodies(run);
  const Material material = material_options(values, run.scene);
  PlanWishes wishes;
  wishes.layer = contact.layer;
  wishes.modulus = material.modulus.has_value();
  wishes.surface_energy = material_options(values, {}).surface_energy;
  const Plan plan = plan_command(run, "contact-radius", wishes);
  const Radii radii = find_radii(run, options);
  const ContactSetup setup = contact_setup(run, contact);
  std::optional<Recommendation> chosen;  // the subject reads the first frame
  if (wanted_error(values)) chosen = choose_stride(values, contact_radius_subject({run, options, sweeping, contact}), sweeping);
  const MeasuredMotion measured =
      measure_motion(run, {}, contact_analyses(radii, setup), sweeping);
  const ContactNumbers numbers = contact_numbers(measured, radii.sum());
  require_touch(run, numbers);

  Document document("contact-radius", run);
  document.sweep(measured.swept, run.format);
  add_lost_atoms(document, measured.motion);
  add_contact_radius(document, numbers, setup);
  document.text("radius_source", radii.source);
  for (const std::string& w : contact_disagreements(numbers, run.units)) document.warn(w);
  add_plan(document, plan);
  document.left_out("force, velocities", "not needed for the contact radius; only positions are read");
  const std::vector<double> delta = approach(measured.motion, radii.sum());
  Table table = contact_table(measured, delta);
  add_laws(document, table, delta, radii, material, plan);
  tell_choice(document, chosen);
  return choice_code(chosen, emit(values, document, &table));
}

}  // namespace

extern const Command contact_radius_command;
const Command contact_radius_command{
    "contact-radius",
    "DUMP",
    "contact radius from the atoms at the contact plane",
    "Three definitions, each with its error: gyration, a = sqrt(2) r_g of the atoms of both bodies in\n"
    "a layer about the contact plane; alpha, sqrt(A/pi) with the area A that these atoms cover; and\n"
    "neighbours, the same of the atoms that have one of the other body within a cutoff. Zero while\n"
    "one of the bodies has no such atoms. In the table, a_hertz and a_jkr are the laws' radii.",
    "  mdana contact-radius sample-data/adhesive-tiny/dump.lammpstrj.gz\n"
    "  mdana contact-radius dump.lammpstrj --units metal --masses 1=107.87 --layer 2.64 -o a.csv",
    add_options,
    run_command,
    /*on_ranks=*/true};

}  // namespace mdana::cli
