// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/study_options.hpp"

#include <iostream>

#include <fmt/format.h>

#include "reports/cli/signals.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

std::size_t jobs_option(const Values& values, std::size_t cores) {
  const long jobs = values["jobs"].as<long>();
  if (jobs < 0) throw UsageError("--jobs must be at least 1");
  return jobs > 0 ? static_cast<std::size_t>(jobs) : cores;
}

}  // namespace

void add_study_options(Options& options, const char* output, const char* json) {
  options.add_options()                                                                              //
      ("output,o", po::value<std::string>()->value_name("OUT")->required(), output)                  //
      ("jobs", po::value<long>()->default_value(0, "all cores")->value_name("N"), "runs at a time")  //
      ("json", po::bool_switch(), json);
  add_resource_options(options);
}

ReportOptions study_options(const Values& values) {
  ReportOptions options;
  options.input = values["input"].as<std::string>();
  options.output = values["output"].as<std::string>();
  set_resources(values, options.sweeping);
  options.jobs = jobs_option(values, options.sweeping.threads);
  options.sweeping.stop = &stop_signal();
  options.tell = [](const std::string& what) { std::cerr << what << "\n"; };
  return options;
}

int resumably(const std::function<int()>& work) try {
  return work();
} catch (const Interrupted& stopped) {
  std::cerr << "mdana: stopped; the results of runs that were done are kept: the same command goes on from there\n";
  return code_after(stopped.signal);
}

int tell_report(const Values& values, const ReportDone& done) {
  for (const std::string& failure : done.failures) std::cerr << failure << "\n";
  print(values["json"].as<bool>() ? done.json
                                  : (std::filesystem::path(values["output"].as<std::string>()) / "index.html").string() + "\n");
  return !done.failures.empty() ? failed : done.damaged ? damaged_input : cli::done;
}

std::size_t count_option(const Values& values, const char* name) {
  const long count = values[name].as<long>();
  if (count < 1 || static_cast<std::size_t>(count) > most_tasks)
    throw UsageError(fmt::format("--{} {}: 1 to {} expected", name, count, most_tasks));
  return static_cast<std::size_t>(count);
}

}  // namespace mdana::cli
