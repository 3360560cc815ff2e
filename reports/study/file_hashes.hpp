// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "readers/input_record.hpp"

namespace mdana {

/// Hashes of files, kept from one report to the next: a file is read again only if size, times or inode are
/// others, or if it was changed so shortly before that the clock cannot tell.
class FileHashes {
 public:
  /// What the file at `place` says; nothing if it is not there or not whole.
  explicit FileHashes(const std::filesystem::path& place);
  /// No file is read: records have neither size nor hash.
  FileHashes() = default;

  /// Those that another process kept, besides.
  void add(const std::filesystem::path& place);

  /// Throws InputError if the file cannot be opened.
  InputRecord record(const std::filesystem::path& file);

  void save() const;

 private:
  std::filesystem::path place_;
  nlohmann::ordered_json known_ = nlohmann::ordered_json::object();
};

}  // namespace mdana
