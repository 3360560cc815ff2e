// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "reports/study.hpp"

namespace mdana {

/// The study's numbers: {mdana_version, command, directory, runs: [...]}, each run with the names of
/// the single commands besides `accuracy`, `stability`, `left_out`; a failed one with `failure`.
nlohmann::ordered_json study_json(const Study& study);

}  // namespace mdana
