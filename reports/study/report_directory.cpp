// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/report_directory.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "readers/input_error.hpp"
#include "reports/atomic_file.hpp"
#include "reports/document.hpp"
#include "reports/study/plan.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A process that was killed holds the lock until its children have seen that.
constexpr int tries = 50;
constexpr std::chrono::milliseconds between_tries{20};

bool is_report(const fs::path& directory) {
  return fs::exists(directory / report_marker) ||
         (fs::is_regular_file(directory / "index.html") && fs::is_regular_file(directory / "results.json"));
}

/// As a program makes it that makes the directories of tasks' files before they run, or another task just now.
bool has_only_shards(const fs::path& directory) {
  return fs::is_directory(directory) && std::ranges::all_of(fs::directory_iterator(directory), [](const auto& entry) {
           return entry.path().filename() == "shards" || entry.path().filename() == report_marker;
         });
}

void require_place(const fs::path& place) {
  if (fs::exists(place) && !is_report(place) && !has_only_shards(place))
    throw InputError(fmt::format("{}: exists and is not a report; it is not replaced", place.string()));
  if (!fs::is_directory(place.parent_path()))
    throw InputError(fmt::format("{}: no such directory", place.parent_path().string()));
}

/// The open marker.
int mark(const fs::path& place) {
  const fs::path marker = place / report_marker;
  const int file = ::open(marker.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file < 0) throw std::runtime_error(fmt::format("{}: {}", marker.string(), std::strerror(errno)));
  return file;
}

int locked(const fs::path& place) {
  const int lock = mark(place);
  for (int k = 0; k < tries; ++k) {
    if (::flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
    std::this_thread::sleep_for(between_tries);
  }
  ::close(lock);
  throw InputError(fmt::format("{}: another mdana report is writing there; wait for it, or choose another -o", place.string()));
}

std::vector<fs::path> files_below(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), directory));
  std::ranges::sort(files);
  return files;
}

Json records_json(const std::vector<InputRecord>& records) {
  Json list = Json::array();
  for (const InputRecord& r : records) list.push_back({{"path", r.path}, {"size", r.size}, {"hash", r.hash}});
  return list;
}

/// Files that an earlier report wrote; none if there is no manifest, or it is not one.
std::vector<fs::path> earlier_files(const fs::path& place) try {
  std::ifstream stream(place / manifest_name);
  std::vector<fs::path> files;
  for (const Json& output : Json::parse(stream).at("outputs")) {
    const fs::path path = output.at("path").get<std::string>();
    if (path.is_relative() && std::ranges::find(path, "..") == path.end()) files.push_back(path);
  }
  return files;
} catch (const Json::exception&) {
  return {};
}

}  // namespace

void make_report_place(const fs::path& place) {
  require_place(place);
  fs::create_directory(place);
  ::close(mark(place));
}

ReportDirectory::ReportDirectory(const fs::path& place) : place_(place), fresh_(place / ".fresh") {
  make_report_place(place_);
  lock_ = locked(place_);
  fs::create_directory(cache());
  fs::remove_all(fresh_);
  fs::create_directory(fresh_);
}

ReportDirectory::~ReportDirectory() {
  std::error_code ignored;
  fs::remove_all(fresh_, ignored);
  ::close(lock_);
}

void ReportDirectory::commit(const Json& study, const std::vector<InputRecord>& inputs) {
  const std::vector<fs::path> files = files_below(fresh_);
  std::vector<InputRecord> outputs;
  for (const fs::path& file : files) {
    outputs.push_back(input_record(fresh_ / file));
    outputs.back().path = file.generic_string();
  }
  for (const fs::path& file : earlier_files(place_))
    if (std::ranges::find(files, file) == files.end()) fs::remove(place_ / file);
  for (const fs::path& file : files) {
    fs::create_directories((place_ / file).parent_path());
    fs::rename(fresh_ / file, place_ / file);
  }
  // In there nothing is left behind by a process that is killed.
  write_file(fresh_ / manifest_name,
             to_text(Json{{"study", study}, {"inputs", records_json(inputs)}, {"outputs", records_json(outputs)}}));
  fs::rename(fresh_ / manifest_name, place_ / manifest_name);
}

}  // namespace mdana
