// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/law_catalogue.hpp"
#include "reports/extreme.hpp"

namespace mdana {

std::vector<ExtremeCase> extreme_laws() {
  std::vector<ExtremeCase> cases;
  for (const LawCase& c : law_catalogue()) {
    ExtremeCase extreme;
    extreme.member = c.law;
    extreme.what = c.what;
    extreme.computed = c.computed;
    extreme.exact = c.exact;
    extreme.digits = c.digits;
    extreme.needed = c.needed;
    extreme.evaluations = c.evaluations;
    extreme.seconds = c.seconds;
    extreme.unresolved = c.unresolved;
    extreme.verdict = c.kept() ? ExtremeCase::Verdict::kept : ExtremeCase::Verdict::lost;
    cases.push_back(std::move(extreme));
  }
  return cases;
}

}  // namespace mdana
