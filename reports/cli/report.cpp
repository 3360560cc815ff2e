// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <iostream>

#include <fmt/format.h>

#include "reports/cli/command.hpp"
#include "reports/cli/signals.hpp"
#include "reports/study.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

void add_options(Options& options) {
  options.add_options()                                                                          //
      ("output,o", po::value<std::string>()->value_name("OUT")->required(),
       "directory of the report: index.html, results.json, .csv, .h5, runs, figures, tables, cache")  //
      ("jobs", po::value<long>()->default_value(0, "all cores")->value_name("N"), "runs at a time")  //
      ("only", po::value<std::string>()->default_value("")->value_name("NAME"),
       "analyse these runs only (* and ? stand for anything); others are told as far as their results are there")  //
      ("dry-run", po::bool_switch(), "tell what would be analysed and why, and write nothing")       //
      ("json", po::bool_switch(), "print results.json on the standard output");
  add_resource_options(options);
}

std::size_t jobs_option(const Values& values, std::size_t cores) {
  const long jobs = values["jobs"].as<long>();
  if (jobs < 0) throw UsageError("--jobs must be at least 1");
  return jobs > 0 ? static_cast<std::size_t>(jobs) : cores;
}

int make(const ReportOptions& options, const std::string& place, bool json) {
  const ReportDone done = make_report(options);
  for (const std::string& failure : done.failures) std::cerr << failure << "\n";
  print(json ? done.json : (std::filesystem::path(place) / "index.html").string() + "\n");
  return !done.failures.empty() ? failed : done.damaged ? damaged_input : cli::done;
}

int run_command(const Values& values) {
  ReportOptions options;
  options.input = values["input"].as<std::string>();
  options.output = values["output"].as<std::string>();
  options.only = values["only"].as<std::string>();
  set_resources(values, options.sweeping);
  options.jobs = jobs_option(values, options.sweeping.threads);
  options.sweeping.stop = &stop_signal();
  options.tell = [](const std::string& what) { std::cerr << what << "\n"; };
  if (values["dry-run"].as<bool>()) return print(planned_report(options)), done;
  try {
    return make(options, values["output"].as<std::string>(), values["json"].as<bool>());
  } catch (const Interrupted& stopped) {
    std::cerr << "mdana: stopped; the results of runs that were done are kept: the same command goes on from there\n";
    return stopped.signal == SIGTERM ? resumable : interrupted;
  }
}

}  // namespace

extern const Command report_command;
const Command report_command{
    "report",
    "STUDY",
    "a whole study in one page, with tables and figures",
    "Of all runs of a study file (mdana study init writes one), or in a directory (a scene.toml with its dump\n"
    "each): one page, documents, tables, and figures as SVG, PDF, gnuplot script and CSV. Runs are analysed side by\n"
    "side. Results are kept in OUT/cache: only what is new, or was made from other files, settings or another mdana, is\n"
    "analysed anew, and a report that was stopped goes on. A run that fails is told in the page (exit code 1).",
    "  mdana report sample-data -o report\n"
    "  mdana report sample-data -o report --dry-run\n"
    "  mdana report runs/study.toml -o runs-report --only 'hertz*' --json",
    add_options,
    run_command};

}  // namespace mdana::cli
