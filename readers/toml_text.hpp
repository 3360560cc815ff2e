// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace mdana {

/// The text of a TOML file, which a parser that goes down a level a table can take: throws InputError
/// if it is large or nests tables deeply.
std::string toml_text(const std::filesystem::path& file);

}  // namespace mdana
