// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "readers/input_record.hpp"

namespace mdana {

/// The files of a report and what they were made from.
inline constexpr const char* manifest_name = "manifest.json";

/// Makes the directory of a report if it is not there. Throws InputError if something else than a report is in the place.
void make_report_place(const std::filesystem::path& place);

/// The directory of a report: a cache that stays, and files that are replaced together. One process at a time.
class ReportDirectory {
 public:
  /// Makes it if it is not there. Throws InputError if something else than a report is in the place, or another
  /// process writes there.
  explicit ReportDirectory(const std::filesystem::path& place);
  ~ReportDirectory();
  ReportDirectory(const ReportDirectory&) = delete;
  ReportDirectory& operator=(const ReportDirectory&) = delete;

  std::filesystem::path cache() const { return place_ / "cache"; }

  /// Where new files are written; empty at first.
  const std::filesystem::path& fresh() const { return fresh_; }

  /// Puts the new files in their places, removes older ones of the report, and writes the manifest last, with
  /// the hashes of inputs and outputs.
  void commit(const nlohmann::ordered_json& study, const std::vector<InputRecord>& inputs);

 private:
  std::filesystem::path place_, fresh_;
  int lock_ = -1;
};

}  // namespace mdana
