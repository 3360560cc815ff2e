// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analyses/defects.hpp"
#include "analyses/sweep.hpp"
#include "reports/document.hpp"
#include "reports/line_history.hpp"

namespace mdana {

/// What the frames of a run show of defects.
struct DefectHistory {
  std::vector<std::int64_t> steps;
  std::vector<double> times;                    ///< [time]; empty if they are not known
  std::vector<double> delta;                    ///< [length]; empty unless there are two bodies
  Table table;                                  ///< of the analysis
  std::vector<std::vector<FaultPlane>> planes;  ///< of each frame
  LineHistory lines;                            ///< empty if they were not asked for
};

/// Plastic defects of a frame, hcp atoms and bulk defects, count from this many more than in the first
/// frame on.
inline constexpr double least_new_defects = 5;

/// Index of the first frame with new plastic defects; nothing if there is none.
std::optional<std::size_t> first_defect(const DefectHistory& history);

/// Index of the first frame after contact from which on no atom touches the other body.
std::optional<std::size_t> separation(const DefectHistory& history);

/// `frames`, `first_defect`, `at_separation`, and what of it a terminal shows; warnings where the
/// atoms are no fcc or hcp crystal.
void add_defects(Document& document, const DefectHistory& history);

/// step, [time,] [delta,] the analysis' columns, and the turn of each lattice since the first frame.
Table defect_table(const DefectHistory& history);

}  // namespace mdana
