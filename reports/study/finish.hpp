// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/study/outputs.hpp"
#include "reports/study/report_directory.hpp"

namespace mdana {

/// Writes the report of runs whose records are there, puts it in its place and tidies the cache.
ReportDone finish_report(const StudyPlan& plan, const std::vector<StudyRun>& runs, RunCache& cache, ReportDirectory& directory,
                         const ReportOptions& options);

}  // namespace mdana
