// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/study/page.hpp"

namespace mdana {

/// The snapshots of a run, for its files.
SnapshotFigure snapshot_figure(const ReportedRun& run, const RunRecord& record);

/// Its snapshots and the 3-D view of its defects for the page, as small as a page of so many runs needs.
std::vector<PageFigure> run_pictures(const ReportedRun& run, const RunRecord& record, std::size_t runs);

/// Lengths of dislocation lines by family in the frames of the view, as HTML; a sentence for a run without defects,
/// and nothing if they were not looked for.
std::string structure_text(const ReportedRun& run);

}  // namespace mdana
