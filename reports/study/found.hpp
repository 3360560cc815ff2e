// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/study.hpp"

namespace mdana {

/// The scene files in a directory and below it. Throws InputError if there is none.
StudyPlan find_runs(const std::filesystem::path& directory);

}  // namespace mdana
