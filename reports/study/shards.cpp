// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/shards.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace mdana {
namespace {

namespace fs = std::filesystem;

/// M of "K-of-M".
std::optional<std::size_t> division(const std::string& name) {
  std::size_t task = 0, of = 0;
  const char* end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data(), end, task);
  const std::string_view middle = "-of-";
  if (error != std::errc() || !std::string_view(rest, end).starts_with(middle)) return std::nullopt;
  const auto [last, second] = std::from_chars(rest + middle.size(), end, of);
  const bool one = second == std::errc() && last == end && task >= 1 && task <= of && of <= most_tasks;
  return one ? std::optional(of) : std::nullopt;
}

}  // namespace

fs::path shard_of(const fs::path& place, const TaskChoice& task) {
  return place / "shards" / fmt::format("{}-of-{}", task.task, task.of);
}

std::vector<fs::path> shards_in(const fs::path& place) {
  std::vector<fs::path> shards;
  std::error_code not_there;
  for (const auto& entry : fs::directory_iterator(place / "shards", not_there))
    if (division(entry.path().filename().string()) && entry.is_directory()) shards.push_back(entry.path());
  std::ranges::sort(shards);
  return shards;
}

std::size_t division_of(const std::vector<fs::path>& shards) {
  std::map<std::size_t, std::size_t> counts;
  for (const fs::path& shard : shards) ++counts[division(shard.filename().string()).value_or(0)];
  std::size_t best = 0;
  for (const auto& [of, count] : counts)
    if (count >= counts[best]) best = of;
  return best;
}

FileHashes known_hashes(const fs::path& place) {
  FileHashes hashes(place / "cache" / hashes_name);
  for (const fs::path& shard : shards_in(place)) hashes.add(shard / hashes_name);
  return hashes;
}

fs::path without_slash(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

}  // namespace mdana
