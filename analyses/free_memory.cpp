// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/free_memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

namespace mdana {
namespace {

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

/// A number in a file of its own; without one, "max" for instance, no limit.
std::size_t number_in(const std::filesystem::path& file) {
  std::ifstream told(file);
  std::size_t number = 0;
  return told >> number ? number : no_limit;
}

std::size_t left(std::size_t limit, std::size_t used) {
  return limit == no_limit ? no_limit : limit - std::min(limit, used);
}

/// A line "name number" of a file; 0 if there is none.
std::size_t number_of(const std::filesystem::path& file, const std::string& name) {
  std::ifstream told(file);
  std::string word;
  for (std::size_t number = 0; told >> word >> number;)
    if (word == name) return number;
  return 0;
}

/// Control groups, as batch systems and containers set them, in one of their two versions. Caches of files count
/// as used there, but give way.
struct GroupFiles {
  const char *root, *limit, *used;
};
constexpr GroupFiles version_1{"/sys/fs/cgroup/memory", "memory.limit_in_bytes", "total_rss"};
constexpr GroupFiles version_2{"/sys/fs/cgroup", "memory.max", "anon"};

/// The least that a group and those above it leave.
std::size_t left_by_group(const GroupFiles& files, std::filesystem::path group) {
  std::size_t least = no_limit;
  for (;; group = group.parent_path()) {
    const std::filesystem::path folder = files.root / group;
    least = std::min(least, left(number_in(folder / files.limit), number_of(folder / "memory.stat", files.used)));
    if (group.empty()) return least;
  }
}

std::size_t left_by_groups() {
  std::size_t least = no_limit;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const auto path_behind = [&](const char* name) {
      return std::filesystem::path(line.substr(line.find(name) + std::string(name).size())).relative_path();
    };
    if (line.starts_with("0::")) least = std::min(least, left_by_group(version_2, path_behind("0::")));
    if (line.find(":memory:") != std::string::npos) least = std::min(least, left_by_group(version_1, path_behind(":memory:")));
  }
  return least;
}

/// What a limit of the address space (ulimit -v) leaves.
std::size_t left_of_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return no_limit;
  const std::size_t pages = number_in("/proc/self/statm");  // its first number: of the whole address space
  return left(limit.rlim_cur, pages == no_limit ? 0 : pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
}

std::size_t free_in_machine() {
  std::ifstream told("/proc/meminfo");
  std::string name, unit;
  for (std::size_t kilobytes = 0; told >> name >> kilobytes; std::getline(told, unit))
    if (name == "MemAvailable:") return kilobytes << 10;
  return std::size_t{1} << 30;
}

}  // namespace

std::size_t free_memory() {
  return std::min({free_in_machine(), left_by_groups(), left_of_address_space()});
}

}  // namespace mdana
