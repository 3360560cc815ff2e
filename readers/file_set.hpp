// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace mdana {

/// Files that are one trajectory: for each value of `*` the pieces `%` of its frames.
using FileSet = std::vector<std::vector<std::filesystem::path>>;

/// The files that a name such as "dump.*.%.gz" stands for, as LAMMPS' command dump means it: `*` is
/// the time step of a file, `%` the number of a piece (0, 1, 2 ...), both whole numbers and here in
/// the order of numbers. Nothing if there is a file of that very name or no such sign in it.
/// Throws InputError if no file matches, two match the same numbers, or pieces are missing.
std::optional<FileSet> find_file_set(const std::filesystem::path& name);

/// The number that stands for `*` in the name of one file of a set; nothing if the name of the set
/// has no such sign, or the file is not of the set.
std::optional<std::uint64_t> step_in_name(const std::filesystem::path& set,
                                          const std::filesystem::path& file);

}  // namespace mdana
