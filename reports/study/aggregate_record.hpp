// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/compressed.hpp"
#include "reports/study/task.hpp"

namespace mdana {

/// A run of two aggregates: what mdana compress tells of it, with the split that Arakawa et al. 2024 have.
RunRecord aggregate_record(const RunTask& task, const Run& run, const SweepOptions& sweeping);
inline constexpr Split study_split = Split::sign;

/// What fits of several runs need of one, of its record: as it was measured but for the dump's tables.
CompressedRun compressed_of(const std::string& name, const RunRecord& record);

}  // namespace mdana
