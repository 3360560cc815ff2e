// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/study/page.hpp"

namespace mdana {

/// The snapshots of a run, for its files.
SnapshotFigure snapshot_figure(const ReportedRun& run, const RunRecord& record);

/// Pictures of the runs of a page, as small as so many runs need: snapshots of all, 3-D views of defects of as
/// many as there is room for.
class RunPictures {
 public:
  explicit RunPictures(std::size_t runs) : runs_(runs) {}

  std::vector<PageFigure> of(const ReportedRun& run, const RunRecord& record);
  std::size_t without_view() const { return without_view_; }  ///< runs with defects, for which the page has no room

 private:
  std::size_t runs_, bytes_ = 0, without_view_ = 0;
};

/// Lengths of dislocation lines by family in the frames of the view, as HTML; a sentence for a run without defects,
/// and nothing if they were not looked for.
std::string structure_text(const ReportedRun& run);

}  // namespace mdana
