// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "reports/study.hpp"
#include "reports/study/file_hashes.hpp"

namespace mdana {

/// What a task writes is in a directory of its own: OUT/shards/K-of-M. Records are those of a cache.
std::filesystem::path shard_of(const std::filesystem::path& place, const TaskChoice& task);

/// All that are there, of any division, in the order of their names.
std::vector<std::filesystem::path> shards_in(const std::filesystem::path& place);

/// The division that most of them are of, of equal ones the finest; 0 if there are none.
std::size_t division_of(const std::vector<std::filesystem::path>& shards);

/// What the cache of a report and its shards know of files; saved in the cache.
FileHashes known_hashes(const std::filesystem::path& place);
inline constexpr const char* hashes_name = "hashes.json";

/// As an absolute path whose last part is a name.
std::filesystem::path without_slash(const std::filesystem::path& path);

}  // namespace mdana
