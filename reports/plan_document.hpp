// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/plan_costs.hpp"

namespace mdana {

/// A plan and what it takes.
struct CostedPlan {
  Plan plan;
  PlanCost cost;
};

/// "12 ms", "3.4 s", "25 min"; "40 MB".
std::string time_text(double seconds);
std::string bytes_text(double bytes);

/// Scene, parts with columns and cost, what is left out, the estimate and where it comes from.
void add_costed_plan(Document& document, const Run& run, const CostedPlan& planned);

/// A row a part: what, passes, seconds, bytes.
Table cost_table(const PlanCost& cost);

/// A run of a study; `failure`: why there is no plan, else empty.
struct PlannedOfStudy {
  std::string name, state;
  bool cached = false;
  std::string failure;
  nlohmann::ordered_json document;
  CostedPlan planned;
};

/// Runs, each with its plan, and what those that are not in the cache take one after another.
void add_study_plan(Document& document, const std::vector<PlannedOfStudy>& runs);

/// A row a run: run, cached, frames, seconds, bytes.
Table study_cost_table(const std::vector<PlannedOfStudy>& runs);

}  // namespace mdana
