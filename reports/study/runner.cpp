// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/runner.hpp"

#include <algorithm>
#include <chrono>
#include <set>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/study/workers.hpp"

namespace mdana {
namespace {

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
  Runner(std::vector<StudyRun>& runs, RunCache& cache, FileHashes& hashes, const ReportOptions& options)
      : runs_(runs), cache_(cache), hashes_(hashes), options_(options) {}

  /// First those that wait for no other, then those that wait for them.
  void run() {
    do {
      settle(runs_, cache_, hashes_);
      hashes_.save();
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
    if (!run.done()) cache_.store_failure(run.file, key_of(run.task), run.why);
  }

  /// Once of each run.
  void tell(std::size_t k, const std::string& what) {
    if (told_.insert(k).second) options_.tell(fmt::format("[{}/{}] {}: {}", told_.size(), here(), runs_[k].plan->name, what));
  }

  /// Runs that are not elsewhere.
  std::size_t here() const {
    return runs_.size() - static_cast<std::size_t>(std::ranges::count(runs_, RunState::elsewhere, &StudyRun::state));
  }

  void tell_total() {
    const auto count = [&](RunState state) { return std::ranges::count(runs_, state, &StudyRun::state); };
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
    const auto failed = count(RunState::failed), left_out = count(RunState::left_out);
    options_.tell(fmt::format("{} run{}: {} analysed anew, {} from the cache, {} failed{}, in {}", here(),
                              here() == 1 ? "" : "s", anew_,
                              std::ranges::count_if(runs_, [](const StudyRun& r) { return r.done() && r.seconds == 0; }),
                              failed, left_out > 0 ? fmt::format(", {} not asked for", left_out) : "", brief(seconds.count())));
  }

  std::vector<StudyRun>& runs_;
  RunCache& cache_;
  FileHashes& hashes_;
  const ReportOptions& options_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::set<std::size_t> told_;
  std::size_t anew_ = 0;
};

}  // namespace

void analyse_runs(std::vector<StudyRun>& runs, RunCache& cache, FileHashes& hashes, const ReportOptions& options) {
  Runner(runs, cache, hashes, options).run();
}

}  // namespace mdana
