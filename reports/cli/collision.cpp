// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/energy.hpp"
#include "readers/input_error.hpp"
#include "reports/cli/measuring_options.hpp"
#include "reports/plasticity.hpp"

namespace mdana::cli {
namespace {

/// All that one pass over the dump can measure.
class Collision {
 public:
  Collision(const Run& run, const RunOptions& options, const PotentialOptions& potential)
      : run_(run),
        radii_(find_radii(run, options)),
        source_(best_force_source(run)),
        potential_(potential) {}

  void measure(const ContactOptions& contact, const SweepOptions& sweeping, Document& document) {
    std::vector<std::unique_ptr<Analysis>> analyses;
    plan_contact(contact, analyses, document);
    contact_tables_ = analyses.size();
    const bool energies = run_.first.has_column("vx");
    if (energies)
      analyses.push_back(make_energy(choose_potential(run_, potential_).column));
    else
      document.left_out("energies", "the dump has no velocities");
    const MotionParts parts = energies ? parts_for_energy(run_) : parts_for(source_);
    measured_ = measure_motion(run_, parts, std::move(analyses), sweeping);
    curve_ = touching_force_curve(run_, measured_.motion, source_, radii_);
    if (energies)
      energy_ = measure_energy(run_, measured_, measured_.swept.tables.back(), radii_, potential_);
  }

  void tell(Document& document, const Material& material) const {
    document.sweep(measured_.swept, run_.format);
    add_force(document, curve_, source_, radii_);
    add_restitution(document, restitution(measured_.motion, curve_));
    tell_plasticity(document, material);
    if (energy_) add_energy(document, *energy_);
    if (setup_) tell_contact(document);
    warn_of_force(document, curve_);
  }

  Table table() const {
    Table all = force_table(curve_, measured_.motion, measured_.swept.tables[0]);
    for (std::size_t t = 1; t <= contact_tables_; ++t) add(measured_.swept.tables[t], all);
    if (energy_)
      add(energy_table(energy_->curve, measured_.motion.steps, measured_.motion.times), all);
    return all;
  }

 private:
  void plan_contact(const ContactOptions& contact, std::vector<std::unique_ptr<Analysis>>& analyses,
                    Document& document) {
    try {
      setup_ = contact_setup(run_, contact);
      analyses = contact_analyses(radii_, *setup_);
    } catch (const InputError& error) {
      document.left_out("contact radius", error.what());
    }
  }

  void tell_contact(Document& document) const {
    const ContactNumbers numbers = contact_numbers(measured_, radii_.sum());
    if (!numbers.touch())
      return document.left_out("contact radius",
                               "the layer about the contact plane never holds atoms of both bodies");
    add_contact_radius(document, numbers, *setup_);
    for (const std::string& w : contact_disagreements(numbers, run_.units)) document.warn(w);
  }

  void tell_plasticity(Document& document, const Material& material) const {
    const double reduced = radii_.value[0] * (radii_.value[1] / radii_.sum());
    const PlasticSigns signs = plastic_signs(
        curve_, {reduced, material.modulus.value_or(0), material.surface_energy.value_or(0)});
    document.number("p_c_max", signs.pressure());
    document.text("p_c_law", signs.pressure_jkr ? "JKR, over E*" : "Hertz, over E*");
    document.number("p_c.hertz", signs.pressure_hertz);
    if (signs.pressure_jkr)
      document.number("p_c.jkr", *signs.pressure_jkr);
    else
      document.left_out("p_c by JKR", "E* or gamma is not known; add --modulus, --surface-energy");
    document.number("delta_residual", signs.residual);
    document.text("plastic", std::string(name(signs.verdict)));
    document.json("plastic_reasons", signs.reasons);
    document.left_out("far-side bump", "this version does not look for one");
  }

  /// Columns that the table does not have yet.
  static void add(const Table& more, Table& all) {
    for (std::size_t k = 0; k < more.columns().size(); ++k)
      if (!all.has(more.columns()[k].name)) {
        const auto column = more.column(k);
        all.add_column(more.columns()[k], {column.begin(), column.end()});
      }
  }

  const Run& run_;
  Radii radii_;
  ForceSource source_;
  const PotentialOptions& potential_;
  std::optional<ContactSetup> setup_;  ///< nothing: the contact radius cannot be measured
  std::size_t contact_tables_ = 0;
  MeasuredMotion measured_;
  ForceCurve curve_;
  std::optional<MeasuredEnergy> energy_;
};

void add_options(Options& options) {
  add_run_options(options);
  add_contact_options(options);
  add_material_options(options);
  add_potential_options(options);
  add_output_options(options, true);
}

int run_command(const Values& values) {
  check_output(values, true);
  const RunOptions options = run_options(values);
  const SweepOptions sweeping = sweep_options(values);
  const ContactOptions contact = contact_options(values);
  const PotentialOptions potential = potential_options(values);
  material_options(values, {});  // a usage error comes before work
  const Run run = prepare_run(options);
  require_two_bodies(run);
  Document document("collision", run);
  Collision collision(run, options, potential);
  collision.measure(contact, sweeping, document);
  collision.tell(document, material_options(values, run.scene));
  const Table table = collision.table();
  return emit(values, document, &table);
}

}  // namespace

extern const Command collision_command;
const Command collision_command{
    "collision",
    "DUMP",
    "all of a collision in one pass: force, e, plasticity, energies, contact radius",
    "What force, energy and contact-radius tell, from one pass over the dump in one document, and\n"
    "signs of plastic deformation besides: the pressure at the centre of the contact against E*,\n"
    "and the delta that is left where the force vanishes. What the dump does not allow is left out,\n"
    "and said. The table (-o FILE.csv) has a row a frame.",
    "  mdana collision sample-data/adhesive-tiny/dump.lammpstrj.gz\n"
    "  mdana collision run/dump.lammpstrj.gz --log run/log.lammps --modulus 65.5 --json\n"
    "  mdana collision run/dump.lammpstrj.gz --physical argon -o collision.csv",
    add_options,
    run_command};

}  // namespace mdana::cli
