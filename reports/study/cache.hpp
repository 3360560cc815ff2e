// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
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
/// keep their bits. Files are whole or not there. Runs that failed leave the reason.
class RunCache {
 public:
  /// `others`: directories of other caches, as they are now, whose records can be taken over.
  explicit RunCache(std::filesystem::path directory, const std::vector<std::filesystem::path>& others = {});

  /// What the record of that name was made from; nothing if there is none, or if it is damaged.
  std::optional<nlohmann::ordered_json> key(const std::string& name) const;

  /// Throws InputError if there is none, or if it is damaged.
  RunRecord load(const std::string& name) const;

  void store(const std::string& name, const nlohmann::ordered_json& key, const RunRecord& record) const;

  /// If there is no record of that name and key here, but in another directory, that one counts from now on.
  void adopt(const std::string& name, const nlohmann::ordered_json& key);

  /// Copies what was adopted.
  void gather();

  /// Why a run failed: kept until there is a record of it. Nothing if it did not fail with that key, here or in another directory.
  void store_failure(const std::string& name, const nlohmann::ordered_json& key, const std::string& reason) const;
  std::optional<std::string> failure(const std::string& name, const nlohmann::ordered_json& key) const;

  /// Removes what is not among the names.
  void keep_only(const std::vector<std::string>& names) const;

 private:
  std::filesystem::path file(const std::string& name) const;  ///< that counts

  std::filesystem::path directory_;
  std::multimap<std::string, std::filesystem::path> others_;  ///< by names of files
  std::map<std::string, std::filesystem::path> adopted_;      ///< likewise
};

}  // namespace mdana
