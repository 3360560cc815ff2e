// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/network.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "reports/accuracy_subjects.hpp"
#include "reports/cli/error_option.hpp"
#include "reports/plan.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

auto number(const char* name) { return po::value<double>()->value_name(name); }

std::optional<double> ratio_option(const Values& values) {
  if (!values.count("poisson-ratio")) return std::nullopt;
  const double nu = values["poisson-ratio"].as<double>();
  if (!(nu > -1 && nu <= 0.5))
    throw UsageError(fmt::format("--poisson-ratio {:g}: must be above -1 and at most 0.5", nu));
  return nu;
}

std::optional<double> filling_option(const Values& values) {
  const auto filling = positive_option(values, "compacted");
  if (filling && *filling >= 1)
    throw UsageError(fmt::format("--compacted {:g}: must be below 1", *filling));
  return filling;
}

void add_options(Options& options) {
  add_run_options(options);
  options.add_options()  //
      ("grain-radius", number("LENGTH"),
       "of every grain (default: the column radius, else that of the scene)")                  //
      ("grain-modulus", number("E"), "Young's modulus of the grains (default: of the scene)")  //
      ("poisson-ratio", number("NU"), "of the grains (default: of the scene)")                 //
      ("surface-energy", number("GAMMA"),
       "of one surface of the grains (default: of the scene)")  //
      ("rolling-displacement", number("XI_C"),
       "where rolling becomes inelastic, for the yield stress (default: of the scene)")  //
      ("contacts", po::value<std::string>()->value_name("FILE"),
       "local dump of the contacts' ids and forces, which then come before the overlap's; contacts "
       "that it "
       "gives no force are by the overlap")  //
      ("contact-columns", po::value<std::vector<std::string>>()->value_name("ID,ID,FORCE"),
       "its columns (default: c_ids[1],c_ids[2],c_pair[2], as sample-data/generate has them)")  //
      ("strong", number("SHARE"),
       "forces above this share of the pull-off force F_c count as strong (default: 0.1)")  //
      ("compacted", number("PHI"),
       "local filling factor above which a grain is compacted (default: that which 1 % of the "
       "first "
       "frame's are above)")  //
      ("aggregate-modulus", number("E*"),
       "reduced modulus of the two aggregates, for their Poisson's ratio");
  add_error_option(options, "the frame stride");
  add_output_options(options, true);
}

void set_list(const Values& values, NetworkOptions& options) {
  if (values.count("contacts")) options.contacts = values["contacts"].as<std::string>();
  if (!values.count("contact-columns")) return;
  if (options.contacts.empty()) throw UsageError("--contact-columns: without --contacts");
  const std::vector<std::string> names = names_option(values, "contact-columns");
  if (names.size() != 3)
    throw UsageError(
        fmt::format("--contact-columns: {} names; ID,ID,FORCE is expected", names.size()));
  std::ranges::copy(names, options.contact_columns.begin());
}

NetworkOptions network_options(const Values& values) {
  NetworkOptions options{{.radius = positive_option(values, "grain-radius"),
                          .density = {},
                          .surface_energy = positive_option(values, "surface-energy"),
                          .modulus = positive_option(values, "grain-modulus"),
                          .poisson_ratio = ratio_option(values),
                          .rolling_displacement = positive_option(values, "rolling-displacement")},
                         positive_option(values, "strong"),
                         filling_option(values),
                         positive_option(values, "aggregate-modulus"),
                         {}};
  set_list(values, options);
  return options;
}

/// In the first frame used, of the core if it has two grains.
Value coordination(const Table& table) {
  const bool core = table.column("core_grains")[0] > 1;
  const std::string name = core ? "coordination_core" : "coordination";
  return {table.column(name)[0], table.column(name + "_error")[0], dimension::none};
}

int run_command(const Values& values) {
  check_output(values, true);
  const RunOptions options = run_options(values);
  SweepOptions sweeping = sweep_options(values);
  const NetworkOptions wanted = network_options(values);
  const Run run = prepare_run(options);
  require_two_bodies(run);
  const Radii radii = find_radii(run, options);
  DumpQuestion question{run, options, sweeping};
  question.network = wanted;
  std::optional<Recommendation> chosen;  // the subject reads the first frame
  if (wanted_error(values)) chosen = choose_stride(values, network_subject(question), sweeping);
  const NetworkSetup setup = network_setup(run, radii, wanted);
  const MeasuredNetwork measured = measure_network(run, radii, setup, sweeping);

  Document document("network", run);
  document.sweep(measured.swept, run.format);
  PlanWishes given;
  given.grains = wanted.grains.radius.has_value();
  add_plan(document, plan_command(run, "network", given));
  document.text("radius_source", radii.source);
  add_network(document, setup, measured);
  add_aggregate_constants(document, setup, wanted, coordination(measured.table));
  tell_choice(document, chosen);
  return choice_code(chosen, emit(values, document, &measured.table));
}

}  // namespace

extern const Command network_command;
const Command network_command{
    "network",
    "DUMP",
    "contacts of the grains of two aggregates",
    "Contacts by the overlap of grains, their normal forces by JKR, coordination, fabric, contacts "
    "made\n"
    "and broken since the first frame, filling factors; and elastic constants and yield stress by "
    "the\n"
    "estimates of Arakawa et al. 2024. The table (-o FILE.csv) has a row a frame; its columns are "
    "told in\n"
    "analyses/contact_network/contact_network.md.",
    "  mdana network sample-data/aggregate-tiny/dump.lammpstrj.gz\n"
    "  mdana network sample-data/aggregate-tiny/dump.lammpstrj.gz --frames 0:1 --json\n"
    "  mdana network sample-data/aggregate-tiny/dump.lammpstrj.gz --contacts "
    "sample-data/aggregate-tiny/contacts.dump.gz\n"
    "  mdana network dump.lammpstrj --units si --grain-radius 1e-7 -o network.csv",
    add_options,
    run_command,
    /*on_ranks=*/true};

}  // namespace mdana::cli
