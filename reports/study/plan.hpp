// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/scene.hpp"
#include "reports/study.hpp"

namespace mdana {

/// A name fit for files: letters, digits, '-' and '_'.
std::string file_name(const std::string& text);

/// One for each run, all different.
std::vector<std::string> file_names(const StudyPlan& plan);

/// The marker of a directory that a report was written to; runs are not looked for there.
inline constexpr const char* report_marker = ".mdana-report";

/// "hertz, R = 5"; of what the scene says.
std::string group_of(const Scene& scene);

}  // namespace mdana
