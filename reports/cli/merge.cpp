// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/cli/study_options.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

void add_options(Options& options) {
  add_study_options(options, "directory of the report and its shards, as mdana run had it",
                    "print results.json on the standard output; if runs are missing, the list of them");
  options.add_options()                                                                                  //
      ("of", po::value<long>()->value_name("M"), "tell missing runs by tasks of M (default: as the shards are)")  //
      ("partial", po::bool_switch(), "make the report of what is there; it tells what is missing");
}

std::string missing_text(const MissingRuns& m, const ReportOptions& options) {
  return fmt::format("task {} of {} {}: {} of {} runs missing: {}\n  {}\n", m.choice.task, m.choice.of,
                     m.begun ? "is not done" : "has not begun", m.runs.size(), m.all, fmt::join(m.runs, ", "),
                     command_of(options, m.choice));
}

nlohmann::ordered_json missing_json(const std::vector<MissingRuns>& missing, const ReportOptions& options) {
  auto list = nlohmann::ordered_json::array();
  for (const MissingRuns& m : missing)
    list.push_back({{"task", m.choice.task}, {"of", m.choice.of}, {"begun", m.begun}, {"runs", m.runs}, {"of_runs", m.all},
                    {"command", command_of(options, m.choice)}});
  return {{"command", "merge"}, {"missing", std::move(list)}};
}

int merge(const Values& values, const ReportOptions& options) {
  const std::size_t of = values.count("of") ? count_option(values, "of") : 0;
  const MergeDone merged = merge_tasks(options, of, values["partial"].as<bool>());
  for (const MissingRuns& m : merged.missing) std::cerr << missing_text(m, options);
  if (merged.report) return tell_report(values, *merged.report);
  std::cerr << "mdana: runs are missing: no report was written (--partial makes it of what is there)\n";
  if (values["json"].as<bool>()) print(to_text(missing_json(merged.missing, options)));
  return failed;
}

int run_command(const Values& values) {
  const ReportOptions options = study_options(values);
  return resumably([&] { return merge(values, options); });
}

}  // namespace

extern const Command merge_command;
const Command merge_command{
    "merge",
    "STUDY",
    "the report of a study whose runs were done by several tasks",
    "Gathers what the tasks of mdana run left in OUT/shards into OUT/cache and writes the report into OUT: the same files as\n"
    "mdana report would write. No run is analysed. Runs that no shard has are listed with the commands that make them, and no\n"
    "report is written (exit code 1); with --partial it is, and says what is missing.",
    "  mdana merge sample-data -o report\n"
    "  mdana merge runs/study.toml -o runs-report --partial",
    add_options,
    run_command};

}  // namespace mdana::cli
