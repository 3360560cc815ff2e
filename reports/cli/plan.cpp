// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/input_error.hpp"
#include "reports/cli/measuring_options.hpp"
#include "reports/cli/signals.hpp"
#include "reports/cli/study_options.hpp"
#include "reports/plan_document.hpp"
#include "reports/task_plan.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;
namespace fs = std::filesystem;

void add_options(Options& options) {
  add_run_options(options);
  options.add_options()                                                                          //
      ("for", po::value<std::string>()->default_value("report")->value_name("COMMAND"),
       fmt::format("what is asked for: {}", fmt::join(planned_commands(), ", ")).c_str())        //
      ("report", po::value<std::string>()->default_value("")->value_name("OUT"),
       "of a study: the directory of its report; runs whose results are there cost nothing")     //
      ("only", po::value<std::string>()->default_value("")->value_name("NAME"),
       "of a study: these runs only (* and ? stand for anything)")                               //
      ("tasks", po::bool_switch(), "of a study: how it is divided into tasks for mdana run")     //
      ("of", po::value<long>()->value_name("M"), "with --tasks: into how many (default: as many as are sensible)");
  add_material_options(options);
  add_potential_options(options);
  add_output_options(options, true);
}

PlanWishes wishes_of(const Values& values, const Scene& scene) {
  const std::string command = values["for"].as<std::string>();
  const auto parts = parts_of(command);
  if (!parts) throw UsageError(fmt::format("--for {}: one of {} expected", command, fmt::join(planned_commands(), ", ")));
  PlanWishes wishes;
  wishes.parts = *parts;
  wishes.insist = command != "report";
  wishes.potential = potential_options(values);
  const Material material = material_options(values, scene);
  wishes.modulus = material.modulus.has_value();
  wishes.surface_energy = material_options(values, {}).surface_energy;
  return wishes;
}

CostedPlan plan_of(const Run& run, const PlanWishes& wishes, const SweepOptions& sweeping) {
  CostedPlan planned{plan_run(run, wishes), {}};
  planned.cost = estimate_cost(run, planned.plan, wishes, sweeping);
  return planned;
}

/// How long the plan itself took.
class Watch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void tell_time(Document& document, const Watch& watch) {
  document.json("seconds", watch.seconds());
  document.line("planned", fmt::format("in {:.2f} s", watch.seconds()));
}

int plan_dump(const Values& values, const SweepOptions& sweeping) {
  const Watch watch;
  const RunOptions options = run_options(values);
  wishes_of(values, {});  // a usage error comes before work
  const Run run = prepare_run(options);
  const CostedPlan planned = plan_of(run, wishes_of(values, run.scene), sweeping);
  Document document("plan", run);
  add_costed_plan(document, run, planned);
  tell_time(document, watch);
  const Table table = cost_table(planned.cost);
  return emit(values, document, &table);
}

PlannedOfStudy plan_run_of_study(const RunOutlook& outlook, SweepOptions sweeping) {
  PlannedOfStudy planned{outlook.name, outlook.state, outlook.cached, {}, {}, {}};
  try {
    if (outlook.options.dump.empty()) throw InputError(outlook.state);
    if (!outlook.frames.empty()) sweeping.choice = parse_frame_choice(outlook.frames);
    const Run run = prepare_run(outlook.options);
    planned.planned = plan_of(run, outlook.wishes, sweeping);
    Document document("plan", run);
    add_costed_plan(document, run, planned.planned);
    planned.document = document.content();
  } catch (const InputError& error) {
    planned.failure = error.what();
  }
  return planned;
}

/// The study's tasks in all divisions that are tried, or in the one that is asked for besides one alone.
int plan_tasks(const Values& values, const ReportOptions& options, const std::vector<PlannedOfStudy>& runs, Document& document,
               const Watch& watch) {
  std::vector<std::size_t> numbers = tried_divisions(runs.size());
  if (values.count("of")) numbers = {1, count_option(values, "of")};
  const auto divisions = study_tasks(options.input, numbers);
  std::vector<TaskCosts> costs;
  for (const auto& division : divisions) costs.push_back(costs_of(division, runs));
  const std::size_t chosen = values.count("of") ? 1 : sensible(costs);
  add_task_plan(document, runs, divisions, chosen, options);
  tell_time(document, watch);
  const Table table = task_table(divisions[chosen], costs[chosen]);
  return emit(values, document, &table);
}

int plan_study(const Values& values, const SweepOptions& sweeping) {
  const Watch watch;
  if (values["for"].as<std::string>() != "report") throw UsageError("--for: a study is planned for its report");
  const bool tasks = values["tasks"].as<bool>();
  if (tasks && !values["only"].as<std::string>().empty()) throw UsageError("--tasks: of the whole study, without --only");
  if (!tasks && values.count("of")) throw UsageError("--of: needs --tasks");
  ReportOptions options;
  options.input = values["input"].as<std::string>();
  options.output = values["report"].as<std::string>();
  options.only = values["only"].as<std::string>();
  std::vector<PlannedOfStudy> runs;
  for (const RunOutlook& outlook : study_outlook(options)) runs.push_back(plan_run_of_study(outlook, sweeping));
  Document document("plan");
  if (tasks) return plan_tasks(values, options, runs, document, watch);
  add_study_plan(document, runs);
  tell_time(document, watch);
  const Table table = study_cost_table(runs);
  return emit(values, document, &table);
}

bool is_study(const fs::path& input) { return fs::is_directory(input) || input.extension() == ".toml"; }

int run_command(const Values& values) {
  check_output(values, true);
  SweepOptions sweeping = sweep_options(values);
  sweeping.progress = nullptr;
  if (is_study(values["input"].as<std::string>())) return plan_study(values, sweeping);
  if (values["tasks"].as<bool>() || values.count("of")) throw UsageError("--tasks: of a study file or a directory");
  return plan_dump(values, sweeping);
}

}  // namespace

extern const Command plan_command;
const Command plan_command{
    "plan",
    "DUMP|STUDY|DIR",
    "what will be computed and what is left out, why, and what it takes, before it is done",
    "Of a dump: which analyses its scene calls for, from which columns and how many frames, in which time and\n"
    "memory, and what is left out with the reason. Decided by the first header, the scene file and this build;\n"
    "the same plan drives the commands and stands in their results. Times come from a few frames that are\n"
    "analysed on this machine. Of a study file or a directory: of all its runs, or (--tasks) how they are divided into tasks for\n"
    "mdana run. Nothing is written but -o.",
    "  mdana plan sample-data/adhesive-tiny/dump.lammpstrj.gz\n"
    "  mdana plan sample-data/adhesive-tiny/dump.lammpstrj.gz --for force --json\n"
    "  mdana plan sample-data\n"
    "  mdana plan --tasks sample-data --of 2\n"
    "  mdana plan runs/study.toml --report report -o plan.csv",
    add_options,
    run_command};

}  // namespace mdana::cli
