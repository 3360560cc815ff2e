// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace mdana {

/// Writes a file whole or not at all: under a temporary name beside it, then renamed.
/// Throws std::runtime_error naming the path and the reason.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace mdana
