// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "reports/document.hpp"
#include "reports/defect_view.hpp"
#include "reports/figure.hpp"
#include "reports/snapshots.hpp"

namespace mdana {

struct NamedTable {
  std::string name;  ///< "frames"
  Table table;
};

/// All that a study says of one run, complete: pages, figures, tables and documents are made from it.
struct RunRecord {
  nlohmann::ordered_json document;      ///< as in results.json
  std::vector<PublishedValue> numbers;  ///< with their dimensions
  std::vector<NamedTable> tables;
  std::vector<Figure> figures;          ///< of this run alone
  std::vector<PublishedValue> parts;    ///< of an aggregate: what fits of several need besides its tables
  std::vector<Snapshot> snapshots;      ///< start, maximum compression, end
  std::vector<ViewedFrame> views;       ///< start of lattice defects, maximum compression, end; none without defects

  /// Null if there is none.
  const Table* table(std::string_view name) const;
  const Value* number(std::string_view name) const;
};

/// Records of runs as files, a file a run, each with what it was made from (its key) and a checksum. Doubles
/// keep their bits. Files are whole or not there.
class RunCache {
 public:
  explicit RunCache(std::filesystem::path directory) : directory_(std::move(directory)) {}

  /// What the record of that name was made from; nothing if there is none, or if it is damaged.
  std::optional<nlohmann::ordered_json> key(const std::string& name) const;

  /// Throws InputError if there is none, or if it is damaged.
  RunRecord load(const std::string& name) const;

  void store(const std::string& name, const nlohmann::ordered_json& key, const RunRecord& record) const;

  /// Removes what is not among the names.
  void keep_only(const std::vector<std::string>& names) const;

 private:
  std::filesystem::path file(const std::string& name) const { return directory_ / (name + ".run"); }

  std::filesystem::path directory_;
};

}  // namespace mdana
