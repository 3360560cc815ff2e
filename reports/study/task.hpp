// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "reports/plan.hpp"
#include "reports/study.hpp"
#include "reports/study/cache.hpp"
#include "readers/input_record.hpp"

namespace mdana {

/// The Hertz run that E* and R of an adhesive run are taken from.
struct Companion {
  std::string name;
  std::string units;
  Value modulus, radius;
};

/// All that a result of one run depends on.
struct RunTask {
  std::string name;
  std::filesystem::path scene, dump, log;  ///< relative to the study; log may be empty
  std::string frames;
  bool accuracy = true, stability = true, defects = true, snapshots = true;
  std::optional<Companion> companion;
  std::vector<InputRecord> files;          ///< of scene, dump and log
};

/// What a report asks of such a run, before E* is known.
PlanWishes plan_wishes(const RunTask& task);

/// The same as a document: equal for equal results.
nlohmann::ordered_json key_of(const RunTask& task);

/// What differs between two keys, in words.
std::string difference(const nlohmann::ordered_json& before, const nlohmann::ordered_json& now);

/// Throws InputError, Interrupted.
RunRecord analyse_task(const RunTask& task, const SweepOptions& sweeping);

}  // namespace mdana
