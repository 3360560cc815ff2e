// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace mdana {

/// A directory that is made whole or not at all: filled under a temporary name beside its place,
/// renamed by `commit`, removed without it. An earlier report in its place is replaced then.
class OutputDirectory {
 public:
  /// Throws InputError if something else than a report is in the place.
  explicit OutputDirectory(const std::filesystem::path& place);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  const std::filesystem::path& path() const { return temporary_; }
  void commit();

 private:
  std::filesystem::path place_, temporary_;
};

}  // namespace mdana
