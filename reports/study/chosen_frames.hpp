// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/defect_numbers.hpp"
#include "reports/study/cache.hpp"
#include "reports/study/task.hpp"

namespace mdana {

/// Snapshots of start, maximum compression and end into the record, by its table of frames (`step`, `delta`, `time` if
/// it is known); where there is a history with lattice defects, 3-D views of where they begin, of maximum compression and of
/// the end, with the dislocation lines, told in `defects.shown_frames` of its document. Reads these frames again.
void add_chosen_frames(RunRecord& record, const RunTask& task, const Run& run, const Table& frames, const Radii& radii,
                       const DefectHistory* history, const SweepOptions& sweeping);

}  // namespace mdana
