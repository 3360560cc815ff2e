// SPDX-License-Identifier: GPL-3.0-or-later
// A study that several processes do, each its runs into a shard of its own, and the report that is made of the shards.
#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/atomic_file.hpp"
#include "reports/study/finish.hpp"
#include "reports/study/provenance.hpp"
#include "reports/study/runner.hpp"
#include "reports/study/shards.hpp"
#include "reports/study/shares.hpp"
#include "reports/study/working_directory.hpp"
#include "reports/version.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* task_name = "task.json";

/// Runs of other shares are elsewhere.
void keep_share(std::vector<StudyRun>& runs, const Share& share) {
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (std::ranges::find(share.runs, k) == share.runs.end()) runs[k].state = RunState::elsewhere;
}

Json run_json(const StudyRun& run) {
  Json json{{"name", run.plan->name}, {"state", run.done() ? "done" : "failed"}};
  if (!run.done()) json["reason"] = run.why;
  return json;
}

Json task_json(const TaskChoice& choice, const std::vector<StudyRun>& runs, const Share& share, double seconds) {
  Json json{{"command", "run"}, {"mdana_version", version}, {"provenance", provenance()}, {"task", choice.task},
            {"of", choice.of}, {"seconds", seconds}, {"runs", Json::array()}, {"besides", Json::array()}};
  for (const std::size_t k : share.runs) json["runs"].push_back(run_json(runs[k]));
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (runs[k].done() && std::ranges::find(share.runs, k) == share.runs.end()) json["besides"].push_back(runs[k].plan->name);
  return json;
}

std::vector<fs::path> all_caches(const fs::path& place) {
  std::vector<fs::path> caches{place / "cache"};
  for (const fs::path& shard : shards_in(place)) caches.push_back(shard);
  return caches;
}

bool is_missing(const StudyRun& run) { return run.state == RunState::to_run || run.state == RunState::waiting; }

/// Those that failed where they were run, and then those that wait for them.
void settle_as_done(std::vector<StudyRun>& runs, RunCache& cache, FileHashes& hashes) {
  for (bool changed = true; changed;) {
    changed = false;
    settle(runs, cache, hashes);
    for (StudyRun& run : runs) {
      if (run.state != RunState::to_run) continue;
      const auto reason = cache.failure(run.file, key_of(run.task));
      if (!reason) continue;
      run.state = RunState::failed;
      run.why = *reason;
      changed = true;
    }
  }
}

std::vector<MissingRuns> find_missing(const std::vector<StudyRun>& runs, const fs::path& place, std::size_t of) {
  std::vector<MissingRuns> missing;
  const std::vector<Share> shares = share_out(runs, of);
  for (std::size_t k = 0; k < of; ++k) {
    MissingRuns m{{k + 1, of}, fs::exists(shard_of(place, {k + 1, of})), {}, shares[k].runs.size()};
    for (const std::size_t run : shares[k].runs)
      if (is_missing(runs[run])) m.runs.push_back(runs[run].plan->name);
    if (!m.runs.empty()) missing.push_back(std::move(m));
  }
  return missing;
}

/// Told in the report.
void leave_out(std::vector<StudyRun>& runs, const std::vector<MissingRuns>& missing) {
  for (StudyRun& run : runs)
    for (const MissingRuns& m : missing)
      if (std::ranges::find(m.runs, run.plan->name) != m.runs.end()) {
        run.state = RunState::left_out;
        run.why = fmt::format("task {} of {} has not {} (mdana run --task {} --of {})", m.choice.task, m.choice.of,
                              m.begun ? "done it" : "begun", m.choice.task, m.choice.of);
      }
}

std::size_t division(std::size_t of, const fs::path& place) {
  if (of > 0) return of;
  if (const std::size_t found = division_of(shards_in(place)); found > 0) return found;
  throw InputError(fmt::format("{}: results of runs are missing, and there are no shards; mdana run STUDY --task K --of M -o {} "
                               "makes them", place.string(), place.string()));
}

}  // namespace

std::vector<std::vector<TaskRuns>> study_tasks(const fs::path& study, std::span<const std::size_t> numbers) {
  const StudyPlan plan = read_study(study);
  const WorkingDirectory in_study(plan.directory);
  const std::vector<StudyRun> runs = open_runs(plan, "");
  std::vector<std::vector<TaskRuns>> all;
  for (const std::size_t of : numbers) {
    all.emplace_back();
    for (const Share& share : share_out(runs, of)) all.back().push_back({{all.back().size() + 1, of}, share.runs, share.besides});
  }
  return all;
}

TaskDone run_task(const ReportOptions& options, const TaskChoice& choice) {
  const auto start = std::chrono::steady_clock::now();
  const fs::path place = without_slash(options.output), shard = shard_of(place, choice);
  const StudyPlan plan = read_study(options.input);
  make_report_place(place);
  fs::create_directories(shard);
  fs::current_path(plan.directory);
  FileHashes hashes(shard / hashes_name);
  hashes.add(place / "cache" / hashes_name);
  std::vector<StudyRun> runs = open_runs(plan, "");
  const Share share = share_out(runs, choice.of)[choice.task - 1];
  keep_share(runs, share);
  RunCache cache(shard, all_caches(place));
  analyse_runs(runs, cache, hashes, options);
  cache.gather();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  TaskDone done{to_text(task_json(choice, runs, share, seconds.count())), shard / task_name, {}};
  write_file(done.file, done.json);
  for (const std::size_t k : share.runs)
    if (runs[k].state == RunState::failed) done.failures.push_back(fmt::format("{}: {}", runs[k].plan->name, runs[k].why));
  return done;
}

MergeDone merge_tasks(const ReportOptions& options, std::size_t of, bool partial) {
  const fs::path place = without_slash(options.output);
  const StudyPlan plan = read_study(options.input);
  ReportDirectory directory(place);
  fs::current_path(plan.directory);
  FileHashes hashes = known_hashes(place);
  std::vector<StudyRun> runs = open_runs(plan, "");
  RunCache cache(directory.cache(), shards_in(place));
  settle_as_done(runs, cache, hashes);
  hashes.save();
  cache.gather();
  MergeDone done;
  if (std::ranges::any_of(runs, is_missing)) done.missing = find_missing(runs, place, division(of, place));
  if (!done.missing.empty() && !partial) return done;
  leave_out(runs, done.missing);
  done.report = finish_report(plan, runs, cache, directory, options);
  return done;
}

std::string command_of(const ReportOptions& options, const TaskChoice& choice) {
  return fmt::format("mdana run {} --task {} --of {} -o {}", options.input.string(), choice.task, choice.of,
                     options.output.empty() ? "OUT" : options.output.string());
}

}  // namespace mdana
