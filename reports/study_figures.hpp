// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/figure.hpp"
#include "reports/study.hpp"

namespace mdana {

/// A name fit for files: letters, digits, '-' and '_'.
std::string file_name(const std::string& text);

/// The figures of an analysed run: force loop with overlay, contact radius with overlay and, for a
/// Hertz scene, the fit and its residuals.
std::vector<Figure> run_figures(const StudyRun& entry);

/// Error of each published number against run time, of one run.
Figure accuracy_figure(const StudyRun& entry);

}  // namespace mdana
