// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "readers/scene.hpp"
#include "reports/study/cache.hpp"
#include "reports/study/file_hashes.hpp"
#include "reports/study/task.hpp"

namespace mdana {

/// Whether the result of a run is there. Of a run that is elsewhere, in another task, it is not known.
enum class RunState { cached, to_run, waiting, failed, left_out, elsewhere };

/// A run of a study and how far it is.
struct StudyRun {
  const PlannedRun* plan = nullptr;
  std::string file;                   ///< name of its files
  Scene scene;
  RunTask task;
  std::vector<std::size_t> partners;  ///< Hertz runs of the same radius, one of which gives E* and R
  RunState state = RunState::to_run;
  std::string why;                    ///< it is to be run, waits, failed or is left out
  double seconds = 0;                 ///< of the analysis; 0 if it was not run anew
  bool hashed = false;                ///< task.files are known

  bool done() const { return state == RunState::cached; }
};

/// Runs with their scenes; files are not hashed. One that cannot be read is failed already. Paths count from
/// the working directory. `only` as ReportOptions has it; throws InputError if no run is called so.
std::vector<StudyRun> open_runs(const StudyPlan& plan, const std::string& only);

/// Hashes files, and settles whether the result that the cache has, or can take over, is what a run would give; waiting: that
/// depends on partners that are to be run. Left-out runs stay so unless their result is there, or one that is not
/// left out waits for them; likewise those elsewhere, which are not looked at before.
void settle(std::vector<StudyRun>& runs, RunCache& cache, FileHashes& hashes);

}  // namespace mdana
