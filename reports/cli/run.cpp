// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include <fmt/format.h>

#include "reports/cli/study_options.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

void add_options(Options& options) {
  options.add_options()                                                                             //
      ("task", po::value<long>()->required()->value_name("K"), "the task, 1 to M")                  //
      ("of", po::value<long>()->required()->value_name("M"), "into how many tasks the study is divided");
  add_study_options(options, "directory of the report that all tasks and mdana merge share; this task writes to OUT/shards/K-of-M alone",
                    "print task.json on the standard output");
}

int run_task_command(const Values& values) {
  const TaskChoice choice{count_option(values, "task"), count_option(values, "of")};
  if (choice.task > choice.of) throw UsageError(fmt::format("--task {} --of {}: tasks are 1 to {}", choice.task, choice.of, choice.of));
  const ReportOptions options = study_options(values);
  return resumably([&] {
    const TaskDone task = run_task(options, choice);
    for (const std::string& failure : task.failures) std::cerr << failure << "\n";
    print(values["json"].as<bool>() ? task.json : task.file.string() + "\n");
    return task.failures.empty() ? done : failed;
  });
}

}  // namespace

extern const Command run_command;
const Command run_command{
    "run",
    "STUDY",
    "one task of a study that is divided into several, as in a batch system",
    "Analyses the runs of task K of the M that a study file, or a directory with runs, is divided into (mdana plan --tasks lists\n"
    "them): each task is a process of its own, on any machine that sees the files, and writes to a directory of its own.\n"
    "mdana merge makes the report of all. A task that was stopped (SIGTERM, SIGUSR1: exit code 75) or killed goes on when it\n"
    "is started again, and does no run twice; results that are in other shards or in OUT/cache are taken.",
    "  mdana run sample-data --task 1 --of 3 -o report\n"
    "  mdana run runs/study.toml --task 3 --of 16 --jobs 1 -o runs-report",
    add_options,
    run_task_command};

}  // namespace mdana::cli
