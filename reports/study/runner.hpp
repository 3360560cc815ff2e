// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reports/study/states.hpp"

namespace mdana {

/// Analyses what is to be run and what waits for it, `options.jobs` at a time, each in a process, and tells of it. Records, and
/// the reasons of those that fail, are in the cache as soon as they are known. Throws Interrupted.
void analyse_runs(std::vector<StudyRun>& runs, RunCache& cache, FileHashes& hashes, const ReportOptions& options);

}  // namespace mdana
