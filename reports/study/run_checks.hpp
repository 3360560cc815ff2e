// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reports/accuracy_subjects.hpp"
#include "reports/stability.hpp"
#include "reports/study/cache.hpp"

namespace mdana {

/// All values of some knobs of a subject, one row a number and value.
std::vector<AccuracyRow> accuracy_rows(const AccuracySubject& subject, std::span<const Knob> knobs);

/// Puts both into the document of a record, and digits and verdict beside each number of it that they are known of.
void add_checks(RunRecord& record, const std::vector<AccuracyRow>& accuracy, const std::vector<StabilityRow>& stability);

}  // namespace mdana
