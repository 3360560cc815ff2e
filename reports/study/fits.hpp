// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/compressed.hpp"
#include "reports/plan.hpp"
#include "reports/study.hpp"
#include "reports/study/law_curves.hpp"
#include "reports/study/reported.hpp"

namespace mdana {

/// What runs say together.
struct StudyFits {
  nlohmann::ordered_json sizes;        ///< E* against R; null if there are none
  nlohmann::ordered_json laws;         ///< a document a group and law
  nlohmann::ordered_json aggregates;   ///< a document a filling factor
  std::vector<NamedTable> tables;      ///< "sizes", "fillings"
  std::vector<LawCurve> curves;        ///< of fitted laws
  std::vector<LeftOut> left_out;
};

StudyFits fit_study(std::span<const ReportedRun* const> runs, std::vector<CompressedRun> aggregates,
                    const StudySettings& settings);

}  // namespace mdana
