// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fits/force_law.hpp"
#include "reports/accuracy.hpp"
#include "reports/analysed_run.hpp"
#include "reports/stability.hpp"
#include "reports/study_aggregates.hpp"

namespace mdana {

/// What was not computed for a run, and why.
struct LeftOut {
  std::string what, reason;
};

/// A contact law drawn over the measured curves.
struct Overlay {
  const ForceLaw* law = nullptr;
  ElasticContact contact;
  std::string source;  ///< where its constants come from
};

/// One run of a study with all that the report says of it.
struct StudyRun {
  std::string name;
  std::filesystem::path dump;
  std::optional<Run> run;               ///< with `result`, unless the run failed
  std::optional<AnalysedRun> result;
  std::optional<Overlay> overlay;
  std::vector<AccuracyRow> accuracy;
  std::vector<StabilityRow> stability;
  std::vector<LeftOut> left_out;
  std::vector<std::string> warnings;
  std::string failure;                  ///< why there is no result
};

struct Study {
  std::filesystem::path directory;
  std::vector<StudyRun> runs;           ///< Hertz scenes first, then by name
  std::vector<AggregateRun> aggregates;
  AggregatesTogether together;          ///< the aggregates
};

/// The scene files in the directory and in its subdirectories (one level), and their dumps.
/// Throws InputError if there is none.
Study find_study(const std::filesystem::path& directory);

/// Analyses every run. Adhesive runs take E* and R from a Hertz run of the study whose scene has the
/// same radius. A run that fails keeps its reason and does not stop the others. `progress` is told
/// what is being done.
void analyse_study(Study& study, const SweepOptions& options,
                   const std::function<void(const std::string&)>& progress);

}  // namespace mdana
