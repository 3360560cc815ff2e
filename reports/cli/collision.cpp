// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include <fmt/format.h>

#include "analyses/energy.hpp"
#include "analyses/far_side.hpp"
#include "analyses/motion.hpp"
#include "readers/input_error.hpp"
#include "reports/cli/measuring_options.hpp"
#include "reports/collision_summary.hpp"
#include "reports/compressed.hpp"
#include "reports/exchange.hpp"
#include "reports/overlays.hpp"
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
    analyses.push_back(make_far_side());
    const bool energies = run_.first.has_column("vx");
    if (energies)
      analyses.push_back(make_energy(choose_potential(run_, potential_).column));
    else
      document.left_out("energies", "the dump has no velocities");
    const MotionParts parts = energies ? parts_for_energy(run_) : parts_for(source_);
    measured_ = measure_motion(run_, parts, std::move(analyses), sweeping);
    curve_ = touching_force_curve(run_, measured_.motion, source_, radii_);
    restitution_ = restitution(measured_.motion, curve_);
    if (energies)
      energy_ = measure_energy(run_, measured_, measured_.swept.tables.back(), radii_, potential_);
  }

  /// Into the document and the table.
  void tell(Document& document, Table& table, const Material& material, const SweepOptions& sweeping,
            bool final_clusters) const {
    table = all_columns();
    document.sweep(measured_.swept, run_.format);
    tell_bodies(document);
    add_force(document, curve_, source_, radii_);
    tell_time_of_compression(document);
    add_restitution(document, restitution_);
    add_overlays(document, table, curve_, elastic(material));
    tell_plasticity(document, material);
    if (energy_) tell_energy(document, sweeping, final_clusters);
    if (setup_) tell_contact(document);
    add_lost_atoms(document, measured_.motion);
    warn_of_force(document, curve_);
  }

  SeriesOutcome outcome() const {
    return {run_.dump.string(), {}, curve_.outcome, restitution_.e, restitution_.e_total,
            restitution_.speed_before};
  }

 private:
  void tell_bodies(Document& document) const {
    const auto [first, second] = body_motion(measured_.swept.tables[0], 0);
    document.number("mass.body1", {first.mass, {}, dimension::mass});
    document.number("mass.body2", {second.mass, {}, dimension::mass});
    document.number("radius.body1", {radii_.value[0], {}, dimension::length});
    document.number("radius.body2", {radii_.value[1], {}, dimension::length});
  }

  void tell_time_of_compression(Document& document) const {
    const MaximumCompression m = maximum_compression(approach_by_membership(measured_.motion), radii_.sum());
    if (m.time_reason.empty())
      document.number("t_max", m.time);
    else
      document.left_out("t_max", m.time_reason);
  }

  Table all_columns() const {
    Table all = force_table(curve_, measured_.motion, measured_.swept.tables[0]);
    for (std::size_t t = 1; t <= contact_tables_ + 1; ++t) add(measured_.swept.tables[t], all);
    if (energy_)
      add(energy_table(energy_->curve, measured_.motion.steps, measured_.motion.times), all);
    return all;
  }

  ElasticContact elastic(const Material& material) const {
    const double reduced = radii_.value[0] * (radii_.value[1] / radii_.sum());
    return {reduced, material.modulus.value_or(0), material.surface_energy.value_or(0)};
  }

  void tell_energy(Document& document, const SweepOptions& sweeping, bool final_clusters) const {
    add_energy(document, *energy_);
    add_rotation(document, energy_->curve, curve_);
    if (const auto windows = energy_windows(curve_))
      add_exchange(document, {run_, measured_, curve_, restitution_, energy_->curve, windows->after,
                              sweeping, final_clusters});
    else
      document.left_out("exchanged atoms", "no frame before contact, or no turn");
  }

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
    PlasticSigns signs = plastic_signs(curve_, elastic(material));
    const Table& far_side = measured_.swept.tables[contact_tables_ + 1];
    const auto windows = energy_windows(curve_);
    judge_bumps(signs, {far_side_growth(far_side, 1, windows), far_side_growth(far_side, 2, windows)},
                setup_ ? setup_->spacing : 0);
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
    document.number("far_side.body1", signs.bump[0]);
    document.number("far_side.body2", signs.bump[1]);
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
  Restitution restitution_;
  std::optional<MeasuredEnergy> energy_;
};

/// What the command line asks of every run.
struct Wishes {
  RunOptions run;
  SweepOptions sweeping;
  ContactOptions contact;
  PotentialOptions potential;
};

Wishes wishes(const Values& values) {
  material_options(values, {});  // a usage error comes before work
  return {run_options(values), sweep_options(values), contact_options(values),
          potential_options(values)};
}

struct Told {
  Document document;
  Table table;
  SeriesOutcome outcome;
};

Told analyse(const Values& values, const Wishes& wishes) {
  const Run run = prepare_run(wishes.run);
  require_two_bodies(run);
  Told told{Document("collision", run), {}, {}};
  Collision collision(run, wishes.run, wishes.potential);
  collision.measure(wishes.contact, wishes.sweeping, told.document);
  collision.tell(told.document, told.table, material_options(values, run.scene), wishes.sweeping,
                 values["final-clusters"].as<bool>());
  told.outcome = collision.outcome();
  return told;
}

std::string brief(const SeriesOutcome& outcome, Units units) {
  if (!outcome.failure.empty()) return "failed";
  const bool known = !std::isnan(outcome.e.value);
  return fmt::format("{}{}", name(*outcome.outcome),
                     known ? ", e = " + to_text(outcome.e, units) : std::string());
}

/// The runs of a series; one that cannot be analysed does not stop the others.
class Series {
 public:
  void add(const Values& values, const Wishes& wishes) {
    try {
      const Told told = analyse(values, wishes);
      document_.set_units(told.document.units());
      runs_.push_back(told.document.content());
      outcomes_.push_back(told.outcome);
      document_.line(told.outcome.dump, brief(told.outcome, told.document.units()));
      for (const std::string& w : told.document.warnings())
        document_.warn(told.outcome.dump + ": " + w);
      damaged_ = damaged_ || told.document.damaged();
    } catch (const InputError& error) {
      fail(wishes.run.dump.string(), error.what());
    }
  }

  int emit(const Values& values) {
    document_.json("runs", std::move(runs_));
    add_summary(document_, outcomes_);
    const Table table = outcome_table(outcomes_);
    const int code = cli::emit(values, document_, &table);
    return failed_ ? failed : damaged_ ? damaged_input : code;
  }

 private:
  void fail(const std::string& dump, const std::string& what) {
    runs_.push_back({{"dump", dump}, {"failure", what}});
    outcomes_.push_back({dump, what, {}, unknown_, unknown_, unknown_});
    document_.line(dump, "failed");
    std::cerr << fmt::format("mdana: {}: failed: {}\n", dump, what);
    failed_ = true;
  }

  static constexpr Value unknown_{std::numeric_limits<double>::quiet_NaN(), {}, dimension::none};
  Document document_{"collision"};
  nlohmann::ordered_json runs_ = nlohmann::ordered_json::array();
  std::vector<SeriesOutcome> outcomes_;
  bool failed_ = false, damaged_ = false;
};

int run_series(const Values& values, const std::vector<std::string>& more, Wishes each) {
  Series series;
  series.add(values, each);
  for (const std::string& dump : more) {
    each.run.dump = dump;
    series.add(values, each);
  }
  return series.emit(values);
}

void add_options(Options& options) {
  add_run_options(options);
  add_contact_options(options);
  add_material_options(options);
  add_potential_options(options);
  add_membership_options(options);
  add_output_options(options, true);
}

int run_command(const Values& values) {
  check_output(values, true);
  const Wishes wanted = wishes(values);
  if (values.count("more"))
    return run_series(values, values["more"].as<std::vector<std::string>>(), wanted);
  const Told told = analyse(values, wanted);
  return emit(values, told.document, &told.table);
}

}  // namespace

extern const Command collision_command;
const Command collision_command{
    "collision",
    "DUMP...",
    "all of a collision in one pass: force, e, plasticity, energies, contact radius",
    "What force, energy and contact-radius tell, from one pass over the dump in one document, and\n"
    "signs of plastic deformation besides: the pressure at the centre of the contact against E*,\n"
    "and the delta that is left where the force vanishes. What the dump does not allow is left out,\n"
    "and said. The table (-o FILE.csv) has a row a frame. Of several runs, as with other orientations,\n"
    "also sticking probability and RMS e; the table has a row a run then.",
    "  mdana collision sample-data/adhesive-tiny/dump.lammpstrj.gz\n"
    "  mdana collision run/dump.lammpstrj.gz --log run/log.lammps --modulus 65.5 --json\n"
    "  mdana collision run/dump.lammpstrj.gz --physical argon -o collision.csv\n"
    "  mdana collision seed1/dump.lammpstrj.gz seed2/dump.lammpstrj.gz seed3/dump.lammpstrj.gz --json",
    add_options,
    run_command};

}  // namespace mdana::cli
