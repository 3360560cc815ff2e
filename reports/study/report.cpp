// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <set>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/study/outputs.hpp"
#include "reports/study/report_directory.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;

fs::path without_slash(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

constexpr const char* hashes_name = "hashes.json";

std::string brief(double seconds) { return fmt::format("{:.1f} s", seconds); }

/// What was read must be what was hashed before. Throws InputError.
void require_same_files(const RunTask& task, const RunRecord& record) {
  for (const auto& input : record.document.at("inputs"))
    for (const InputRecord& file : task.files)
      if (file.path == input.value("path", "") && file.hash != input.value("hash", ""))
        throw InputError(fmt::format("{}: changed while the report was made; run it again", file.path));
}

/// Runs what is to be run, and tells of it.
class Runner {
 public:
  Runner(std::vector<StudyRun>& runs, const RunCache& cache, const ReportOptions& options)
      : runs_(runs), cache_(cache), options_(options) {}

  /// First those that wait for no other, then those that wait for them.
  void run() {
    do {
      settle(runs_, cache_);
      for (std::size_t k = 0; k < runs_.size(); ++k) {
        const StudyRun& run = runs_[k];
        if (run.done()) tell(k, "from the cache");
        if (run.state == RunState::failed) tell(k, "failed: " + run.why);
        if (run.state == RunState::left_out) tell(k, run.why);
      }
    } while (run_those_to_run());
    tell_total();
  }

 private:
  /// Whether there were any.
  bool run_those_to_run() {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < runs_.size(); ++k)
      if (runs_[k].state == RunState::to_run) chosen.push_back(k);
    if (chosen.empty()) return false;
    const std::size_t jobs = std::min(options_.jobs, chosen.size());
    SweepOptions sweeping = options_.sweeping;
    sweeping.threads = std::max<std::size_t>(1, sweeping.threads / jobs);
    std::vector<Work> works;
    for (const std::size_t k : chosen)
      works.push_back([this, k, sweeping] {
        const RunRecord record = analyse_task(runs_[k].task, sweeping);
        require_same_files(runs_[k].task, record);
        cache_.store(runs_[k].file, key_of(runs_[k].task), record);
      });
    run_in_processes(works, jobs, options_.sweeping.stop, [&](const WorkDone& done) { take(chosen[done.index], done); });
    return true;
  }

  void take(std::size_t k, const WorkDone& done) {
    StudyRun& run = runs_[k];
    run.seconds = done.seconds;
    run.state = done.failure.empty() ? RunState::cached : RunState::failed;
    ++anew_;
    tell(k, done.failure.empty() ? fmt::format("done in {} (run because: {})", brief(done.seconds), run.why) : "failed: " + done.failure);
    run.why = done.failure;
  }

  /// Once of each run.
  void tell(std::size_t k, const std::string& what) {
    if (told_.insert(k).second) options_.tell(fmt::format("[{}/{}] {}: {}", told_.size(), runs_.size(), runs_[k].plan->name, what));
  }

  void tell_total() {
    const auto count = [&](RunState state) { return std::ranges::count(runs_, state, &StudyRun::state); };
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
    const auto failed = count(RunState::failed), left_out = count(RunState::left_out);
    options_.tell(fmt::format("{} run{}: {} analysed anew, {} from the cache, {} failed{}, in {}", runs_.size(),
                              runs_.size() == 1 ? "" : "s", anew_,
                              std::ranges::count_if(runs_, [](const StudyRun& r) { return r.done() && r.seconds == 0; }),
                              failed, left_out > 0 ? fmt::format(", {} not asked for", left_out) : "", brief(seconds.count())));
  }

  std::vector<StudyRun>& runs_;
  const RunCache& cache_;
  const ReportOptions& options_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::set<std::size_t> told_;
  std::size_t anew_ = 0;
};

/// All files that the report was made from.
std::vector<InputRecord> inputs_of(const StudyPlan& plan, const std::vector<StudyRun>& runs) {
  std::vector<InputRecord> inputs;
  if (!plan.file.empty()) inputs.push_back(input_record(plan.file.filename()));
  for (const StudyRun& run : runs)
    if (run.done())
      for (const InputRecord& file : run.task.files)
        if (std::ranges::find(inputs, file.path, &InputRecord::path) == inputs.end()) inputs.push_back(file);
  return inputs;
}

const char* in_words(RunState state) {
  switch (state) {
    case RunState::cached: return "cached";
    case RunState::to_run: return "to run";
    case RunState::waiting: return "to run if changed";
    case RunState::failed: return "fails";
    case RunState::left_out: break;
  }
  return "left out";
}

/// The working directory while it lives.
class WorkingDirectory {
 public:
  explicit WorkingDirectory(const fs::path& directory) : before_(fs::current_path()) { fs::current_path(directory); }
  ~WorkingDirectory() {
    std::error_code ignored;
    fs::current_path(before_, ignored);
  }
  WorkingDirectory(const WorkingDirectory&) = delete;
  WorkingDirectory& operator=(const WorkingDirectory&) = delete;

 private:
  fs::path before_;
};

RunOutlook outlook_of(const StudyRun& run) {
  RunOutlook outlook;
  outlook.name = run.plan->name;
  outlook.state = fmt::format("{}{}{}", in_words(run.state), run.why.empty() ? "" : ": ", run.why);
  outlook.cached = run.done();
  if (run.state == RunState::failed) return outlook;
  outlook.options.dump = fs::absolute(run.task.dump);
  outlook.options.scene = fs::absolute(run.task.scene);
  outlook.wishes = plan_wishes(run.task);
  outlook.wishes.modulus = !run.partners.empty();
  outlook.frames = run.task.frames;
  return outlook;
}

}  // namespace

std::vector<RunOutlook> study_outlook(const ReportOptions& options) {
  const bool results = !options.output.empty();
  const fs::path place = results ? without_slash(options.output) : fs::path();
  const StudyPlan plan = read_study(options.input);
  const WorkingDirectory in_study(plan.directory);
  FileHashes hashes = results ? FileHashes(place / "cache" / hashes_name) : FileHashes();
  std::vector<StudyRun> runs = open_runs(plan, options.only, hashes);
  if (results) settle(runs, RunCache(place / "cache"));
  std::vector<RunOutlook> all;
  for (const StudyRun& run : runs) all.push_back(outlook_of(run));
  return all;
}

std::string planned_report(const ReportOptions& options) {
  const std::vector<RunOutlook> runs = study_outlook(options);
  std::size_t width = 0;
  for (const RunOutlook& run : runs) width = std::max(width, run.name.size());
  std::string text;
  for (const RunOutlook& run : runs) text += fmt::format("{:<{}}  {}\n", run.name, width, run.state);
  return text;
}

ReportDone make_report(const ReportOptions& options) {
  const fs::path place = without_slash(options.output);
  const StudyPlan plan = read_study(options.input);
  ReportDirectory directory(place);
  fs::current_path(plan.directory);
  FileHashes hashes(directory.cache() / hashes_name);
  std::vector<StudyRun> runs = open_runs(plan, options.only, hashes);
  hashes.save();
  const RunCache cache(directory.cache());
  Runner(runs, cache, options).run();
  WrittenReport written = write_report(plan, runs, cache, directory.fresh(), options);
  ReportDone done{std::move(written.json), {}, written.damaged};
  directory.commit({{"directory", plan.directory.string()}}, inputs_of(plan, runs));
  std::vector<std::string> names;
  for (const StudyRun& run : runs) {
    names.push_back(run.file);
    if (run.state == RunState::failed) done.failures.push_back(fmt::format("{}: {}", run.plan->name, run.why));
  }
  if (options.only.empty()) cache.keep_only(names);
  return done;
}

}  // namespace mdana
