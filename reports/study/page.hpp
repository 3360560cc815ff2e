// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/study/fits.hpp"

namespace mdana {

/// A figure for the page.
struct PageFigure {
  std::string name, alt;
  std::string html;  ///< see live_figure
};

/// What the page shows of a study.
struct PageContent {
  std::string title, place;
  struct Section {
    const ReportedRun* run;
    std::vector<PageFigure> figures;
    std::string structure = {};  ///< HTML; see run_pictures.hpp
  };
  std::vector<Section> sections;
  std::vector<PageFigure> pooled;
  const StudyFits& fits;
  std::vector<LeftOut> left_out;       ///< of the study
};

/// The report as one page of HTML.
std::string study_page(const PageContent& content);

}  // namespace mdana
