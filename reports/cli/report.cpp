// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include <fmt/format.h>
#include <unistd.h>

#include "reports/atomic_file.hpp"
#include "reports/cli/command.hpp"
#include "reports/cli/signals.hpp"
#include "reports/csv.hpp"
#include "reports/output_directory.hpp"
#include "reports/study.hpp"
#include "reports/study_figures.hpp"
#include "reports/study_json.hpp"
#include "reports/study_page.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

void add_options(Options& options) {
  options.add_options()                                                                          //
      ("output,o", po::value<std::string>()->value_name("OUT")->required(),
       "directory to make: index.html, results.json, tables, figures")              //
      ("json", po::bool_switch(), "print results.json on the standard output");
  add_resource_options(options);
}

void write_tables(const Study& study, const std::filesystem::path& directory) {
  for (const StudyRun& entry : study.runs) {
    if (!entry.result) continue;
    const MeasuredMotion& measured = entry.result->measured;
    Table table = force_table(entry.result->curve, measured.motion, measured.swept.tables[0]);
    add_contact_columns(table, measured);
    if (entry.overlay)
      add_law_column(table, entry.result->curve.delta, *entry.overlay->law, entry.overlay->contact);
    write_file(directory / (file_name(entry.name) + ".csv"), to_csv(table));
  }
  for (const AggregateRun& entry : study.aggregates)
    if (entry.result)
      write_file(directory / (file_name(entry.name) + ".csv"), to_csv(compression_table(*entry.result, Split::sign)));
}

int exit_code(const Study& study) {
  int code = done;
  for (const StudyRun& entry : study.runs) {
    if (!entry.result) return failed;
    if (!entry.result->measured.swept.damage.empty()) code = damaged_input;
  }
  for (const AggregateRun& entry : study.aggregates) {
    if (!entry.result) return failed;
    if (!entry.result->measured.swept.damage.empty()) code = damaged_input;
  }
  return code;
}

int run_command(const Values& values) {
  SweepOptions sweeping;
  set_resources(values, sweeping);
  sweeping.stop = &stop_signal();
  const std::filesystem::path place = values["output"].as<std::string>();
  Study study = find_study(values["input"].as<std::string>());
  OutputDirectory output(place);

  analyse_study(study, sweeping, [](const std::string& what) { std::cerr << what << "\n"; });
  std::filesystem::create_directory(output.path() / "figures");
  write_tables(study, output.path());
  const std::string json = to_text(study_json(study));
  write_file(output.path() / "results.json", json);
  write_file(output.path() / "index.html", study_page(study, output.path() / "figures"));
  output.commit();

  for (const StudyRun& entry : study.runs)
    if (!entry.result) std::cerr << fmt::format("{}: failed: {}\n", entry.name, entry.failure);
  for (const AggregateRun& entry : study.aggregates)
    if (!entry.result) std::cerr << fmt::format("{}: failed: {}\n", entry.name, entry.failure);
  print(values["json"].as<bool>() ? json : (place / "index.html").string() + "\n");
  return exit_code(study);
}

}  // namespace

extern const Command report_command;
const Command report_command{
    "report",
    "DIR",
    "one page on all runs in a directory",
    "Analyses every run (a scene.toml in DIR or one level below, with its dump) and writes one page\n"
    "with figures, tables, error against run time, numerical stability, and what was left out.",
    "  mdana report sample-data -o report\n"
    "  mdana report runs -o runs-report --json",
    add_options,
    run_command};

}  // namespace mdana::cli
