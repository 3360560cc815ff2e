// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/file_hashes.hpp"

#include <ctime>
#include <fstream>

#include <fmt/format.h>
#include <sys/stat.h>

#include "reports/atomic_file.hpp"
#include "reports/document.hpp"

namespace mdana {
namespace {

constexpr std::time_t too_young = 2;  ///< [s] since a change, as coarse as clocks of file systems are

/// What tells one state of a file from another; empty if it may change unnoticed.
std::string state_of(const std::filesystem::path& file) {
  struct stat s {};
  if (::stat(file.c_str(), &s) != 0 || std::time(nullptr) - s.st_ctim.tv_sec <= too_young) return {};
  return fmt::format("{} {} {}.{:09} {}.{:09}", s.st_ino, s.st_size, s.st_mtim.tv_sec, s.st_mtim.tv_nsec, s.st_ctim.tv_sec,
                     s.st_ctim.tv_nsec);
}

}  // namespace

FileHashes::FileHashes(const std::filesystem::path& place) : place_(place) { add(place); }

void FileHashes::add(const std::filesystem::path& place) {
  std::ifstream stream(place);
  const auto json = nlohmann::ordered_json::parse(stream, nullptr, false);
  if (!json.is_object()) return;
  for (const auto& [name, entry] : json.items())
    if (entry.is_object() && entry.contains("state") && entry.contains("size") && entry["size"].is_number_unsigned() &&
        entry.contains("hash") && entry["hash"].is_string() && (!known_.contains(name) || known_[name]["state"] != state_of(name)))
      known_[name] = entry;
}

InputRecord FileHashes::record(const std::filesystem::path& file) {
  if (place_.empty()) return {file.string(), 0, {}};
  const std::string state = state_of(file), name = std::filesystem::absolute(file).string();
  const auto known = known_.find(name);
  if (!state.empty() && known != known_.end() && (*known)["state"] == state)
    return {file.string(), (*known)["size"].get<std::uint64_t>(), (*known)["hash"].get<std::string>()};
  InputRecord record = input_record(file);
  if (!state.empty() && state == state_of(file))
    known_[name] = {{"state", state}, {"size", record.size}, {"hash", record.hash}};
  else
    known_.erase(name);
  return record;
}

void FileHashes::save() const { write_file(place_, to_text(known_)); }

}  // namespace mdana
