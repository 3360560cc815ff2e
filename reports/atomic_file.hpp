// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace mdana {

/// Writes a file whole or not at all: under a temporary name beside it, then renamed. Does nothing on other ranks than the
/// first.
/// Throws std::runtime_error naming the path and the reason.
void write_file(const std::filesystem::path& path, std::string_view text);

/// The same for a file that something else writes: `write` is given the temporary name.
void write_file_by(const std::filesystem::path& path,
                   const std::function<void(const std::filesystem::path& temporary)>& write);

}  // namespace mdana
