// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "reports/study/reported.hpp"

namespace mdana {

/// results.h5: /document; /runs/NAME with document, results and a group a table; /tables of all runs.
class StudyHdf5 {
 public:
  /// Writes nothing in a build without HDF5.
  explicit StudyHdf5(const std::filesystem::path& file);
  ~StudyHdf5();

  static bool available();

  void add_run(const ReportedRun& run, const RunRecord& record);
  void add_table(const NamedTable& table, Units units);
  void finish(const nlohmann::ordered_json& document);

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace mdana
