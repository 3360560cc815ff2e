// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace mdana {

/// A file that is made whole or not at all: written under a temporary name beside its place, renamed
/// by `commit`, removed without it. The temporary name ends as the name itself.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& place);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::filesystem::path& path() const { return temporary_; }

  /// Does what writes the file; a std::runtime_error about it under its temporary name is told of the place.
  template <class Work>
  void writing(Work&& work) const {
    try {
      work();
    } catch (const std::runtime_error& error) {
      const std::string what = told(error.what());
      if (what == error.what()) throw;
      throw std::runtime_error(what);
    }
  }

  /// The file must be closed. Throws std::runtime_error naming the place and the reason.
  void commit();

 private:
  std::string told(std::string what) const;
  [[noreturn]] void fail(const char* doing) const;

  std::filesystem::path place_, temporary_;
  bool renamed_ = false;
};

}  // namespace mdana
