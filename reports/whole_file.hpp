// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "readers/input_record.hpp"

namespace mdana {

/// A small file, decompressed, and what it was.
struct WholeFile {
  std::string text;
  InputRecord record;
};

/// Throws InputError if it cannot be read or is larger than 64 MB.
WholeFile read_whole(const std::filesystem::path& path);

}  // namespace mdana
