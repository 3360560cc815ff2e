// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/study/states.hpp"
#include "reports/study/workers.hpp"

namespace mdana {

struct WrittenReport {
  std::string json;      ///< results.json
  bool damaged = false;  ///< some input was
};

/// Writes all files of a report into a directory, from the records in the cache alone: page, documents,
/// tables, figures. Of `options`, jobs and stop count.
WrittenReport write_report(const StudyPlan& plan, const std::vector<StudyRun>& runs, const RunCache& cache,
                         const std::filesystem::path& directory, const ReportOptions& options);

}  // namespace mdana
