// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/output_directory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;

fs::path without_slash(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

bool is_report(const fs::path& directory) {
  return fs::is_regular_file(directory / "index.html") &&
         fs::is_regular_file(directory / "results.json");
}

}  // namespace

OutputDirectory::OutputDirectory(const fs::path& place) : place_(without_slash(place)) {
  if (fs::exists(place_) && !is_report(place_) &&
      !(fs::is_directory(place_) && fs::is_empty(place_)))
    throw InputError(fmt::format("{}: exists and is not a report; it is not replaced",
                                 place.string()));
  if (!fs::is_directory(place_.parent_path()))
    throw InputError(fmt::format("{}: no such directory", place_.parent_path().string()));
  temporary_ = place_.parent_path() /
               fmt::format(".{}.{}.part", place_.filename().string(), ::getpid());
  fs::create_directory(temporary_);
}

OutputDirectory::~OutputDirectory() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void OutputDirectory::commit() {
  const fs::path replaced = temporary_.string() + ".old";
  if (fs::exists(place_)) fs::rename(place_, replaced);
  fs::rename(temporary_, place_);
  temporary_.clear();
  fs::remove_all(replaced);
}

}  // namespace mdana
