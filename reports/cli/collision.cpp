// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/analysed_run.hpp"
#include "reports/cli/error_option.hpp"
#include "reports/cli/measuring_options.hpp"
#include "reports/collision_summary.hpp"

namespace mdana::cli {
namespace {

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
  std::optional<Recommendation> chosen = {};  ///< for --error
};

Told analyse(const Values& values, Wishes wishes) {
  const Run run = prepare_run(wishes.run);
  require_two_bodies(run);
  const Material material = material_options(values, run.scene);
  PlanWishes asked;
  asked.potential = wishes.potential;
  asked.layer = wishes.contact.layer;
  asked.modulus = material.modulus.has_value();
  asked.surface_energy = material_options(values, {}).surface_energy;
  RunWishes all;
  all.plan = plan_command(run, "collision", asked);
  all.radii = find_radii(run, wishes.run);
  all.contact = wishes.contact;
  all.potential = wishes.potential;
  const DumpQuestion question{run, wishes.run, wishes.sweeping, wishes.contact, wishes.potential};
  const auto chosen = choose_stride(values, collision_subject(question), wishes.sweeping);
  const AnalysedRun analysed = analyse_run(run, all, wishes.sweeping);
  const ElasticContact contact{analysed.radii.reduced(), material.modulus.value_or(0),
                               material.surface_energy.value_or(0)};
  Told told{Document("collision", run), {}, {}, chosen};
  told.table = add_collision(told.document, run, analysed, contact, wishes.sweeping, values["final-clusters"].as<bool>());
  tell_choice(told.document, chosen);
  told.outcome = {run.dump.string(), {}, analysed.curve.outcome, analysed.restitution.e, analysed.restitution.e_total,
                  analysed.restitution.speed_before};
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
      met_ = met_ && choice_code(told.chosen, done) == done;
    } catch (const InputError& error) {
      fail(wishes.run.dump.string(), error.what());
    }
  }

  int emit(const Values& values) {
    document_.json("runs", std::move(runs_));
    add_summary(document_, outcomes_);
    const Table table = outcome_table(outcomes_);
    const int code = cli::emit(values, document_, &table);
    return failed_ ? failed : damaged_ ? damaged_input : code == done && !met_ ? not_converged : code;
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
  bool failed_ = false, damaged_ = false, met_ = true;
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
  add_error_option(options, "the frame stride, run by run,");
  add_output_options(options, true);
}

int run_command(const Values& values) {
  check_output(values, true);
  const Wishes wanted = wishes(values);
  if (values.count("more"))
    return run_series(values, values["more"].as<std::vector<std::string>>(), wanted);
  const Told told = analyse(values, wanted);
  return choice_code(told.chosen, emit(values, told.document, &told.table));
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
    run_command,
    /*on_ranks=*/true};

}  // namespace mdana::cli
