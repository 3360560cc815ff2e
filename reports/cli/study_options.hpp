// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/cli/command.hpp"
#include "reports/study.hpp"

namespace mdana::cli {

/// -o OUT, --jobs, --json, --threads and --memory of commands that work on a whole study, and their values.
void add_study_options(Options& options, const char* output, const char* json);
ReportOptions study_options(const Values& values);

/// Runs the work; what is done is kept if a signal stops it, and that is told.
int resumably(const std::function<int()>& work);

/// Prints the document or the path, and each failure on the standard error.
int tell_report(const Values& values, const ReportDone& done);

/// The number of an option, 1 to most_tasks. Throws UsageError.
std::size_t count_option(const Values& values, const char* name);

}  // namespace mdana::cli
