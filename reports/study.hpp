// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analyses/sweep.hpp"
#include "reports/plan.hpp"

namespace mdana {

/// What is done with every run, and with all together.
struct StudySettings {
  bool accuracy = true;           ///< error of each number against run time: about twenty passes more
  bool stability = true;          ///< digits that the printed digits of the dump fix: four passes more
  bool defects = true;            ///< crystal structure of spheres
  std::vector<std::string> laws;  ///< of collisions, fitted to the e and sticking of each group
  bool sizes = true;              ///< E* against R of the Hertz runs
  bool aggregates = true;         ///< E* and Y of the aggregates together
  std::vector<std::string> figures;  ///< kinds of pooled figures; empty: all that there are data for

  bool draws(std::string_view kind) const { return figures.empty() || std::ranges::find(figures, kind) != figures.end(); }
};

/// A run as study.toml has it. Paths count from the directory of the study.
struct PlannedRun {
  std::string name, group;
  std::filesystem::path scene;
  std::string frames;         ///< as --frames; empty: all
  std::filesystem::path log;  ///< of LAMMPS, for potential energies; empty: none
};

struct StudyPlan {
  std::filesystem::path directory;  ///< absolute
  std::filesystem::path file;       ///< study.toml; empty: the runs were looked for
  std::string title;
  StudySettings settings;
  std::vector<PlannedRun> runs;     ///< names differ
};

/// A study file, or the scene files in and below a directory. Throws InputError with file, line and key.
StudyPlan read_study(const std::filesystem::path& input);

/// The same as a study file to be edited, with comments; it names dumps that no scene file names.
std::string study_toml(const StudyPlan& plan);

struct ReportOptions {
  std::filesystem::path input, output;
  std::string only;          ///< runs by name, * and ? stand for anything; empty: all
  std::size_t jobs = 1;      ///< runs at a time
  SweepOptions sweeping;     ///< threads: of all runs together
  std::function<void(const std::string&)> tell;  ///< a line on what is being done
};

/// A run of a study and how far it is.
struct RunOutlook {
  std::string name;
  RunOptions options;     ///< dump and scene, absolute; empty if the run fails
  PlanWishes wishes;
  std::string frames;     ///< as --frames; empty: all
  bool cached = false;    ///< its result is there and right
  std::string state;      ///< "to run: no result yet"
};

/// Without an output there are no results. Throws InputError.
std::vector<RunOutlook> study_outlook(const ReportOptions& options);

/// What would be run, and why, a line a run.
std::string planned_report(const ReportOptions& options);

struct ReportDone {
  std::string json;                   ///< results.json
  std::vector<std::string> failures;  ///< "NAME: reason"
  bool damaged = false;               ///< some input was
};

/// Runs what is not in the cache of the output, or was made from something else, and writes the report.
/// A run that fails does not stop the others. What is done is kept whenever the program ends. Throws
/// InputError, also if another process writes there, and Interrupted. The working directory is that of the
/// study afterwards, from which paths in results count.
ReportDone make_report(const ReportOptions& options);

/// A study is divided into so many tasks at most.
inline constexpr std::size_t most_tasks = 100000;

/// One of the tasks that a study is divided into, each of which does some of its runs.
struct TaskChoice {
  std::size_t task = 1, of = 1;  ///< 1 <= task <= of
};

/// What is done by which task.
struct TaskRuns {
  TaskChoice choice;
  std::vector<std::size_t> runs;     ///< of the study, from 0
  std::vector<std::size_t> besides;  ///< runs of other tasks whose E* and R it needs, and does itself unless they are there
};

/// The tasks of a study, for each number of them, by the sizes of its dumps, the same in every process. Throws InputError.
std::vector<std::vector<TaskRuns>> study_tasks(const std::filesystem::path& study, std::span<const std::size_t> numbers);

struct TaskDone {
  std::string json;                   ///< task.json
  std::filesystem::path file;         ///< where it is
  std::vector<std::string> failures;  ///< "NAME: reason"
};

/// Analyses the runs of one task whose results are neither in its shard, OUT/shards/K-of-M, nor in another or in the
/// cache of the report. No other task writes to that directory; files are put there by renaming alone. Throws as make_report.
TaskDone run_task(const ReportOptions& options, const TaskChoice& choice);

/// Runs of a task that no shard has.
struct MissingRuns {
  TaskChoice choice;
  bool begun = false;               ///< there is a shard
  std::vector<std::string> runs;    ///< by name
  std::size_t all = 0;              ///< runs of the task
};

struct MergeDone {
  std::vector<MissingRuns> missing;
  std::optional<ReportDone> report;  ///< nothing if runs are missing and `partial` is false
};

/// Gathers the results of all shards and writes the report that make_report would have written; runs are not analysed.
/// `of`: the division that missing runs are told of; 0: that of the shards. Throws as make_report.
MergeDone merge_tasks(const ReportOptions& options, std::size_t of, bool partial);

/// The command of a task; without an output "OUT" stands for it.
std::string command_of(const ReportOptions& options, const TaskChoice& choice);

/// What a report and the files that it was made from are now, a line for each that differs.
struct Verified {
  std::vector<std::string> changes;
  std::size_t inputs = 0, outputs = 0;  ///< files looked at
};
/// Throws InputError if there is no report.
Verified verify_report(const std::filesystem::path& output);

}  // namespace mdana
