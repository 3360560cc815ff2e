// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace mdana {

/// Which bytes a result was made from.
struct InputRecord {
  std::string path;
  std::uint64_t size = 0;  ///< bytes on disk
  std::string hash;        ///< "xxh3:" and 32 hexadecimal digits (XXH3, 128 bit) of those bytes
  bool changed = false;    ///< another program wrote to it while it was read
};

/// The hash of bytes in memory, as InputRecord has it.
std::string content_hash(std::string_view bytes);

/// Reads the whole file. Throws InputError if it cannot be opened.
InputRecord input_record(const std::filesystem::path& file);

}  // namespace mdana
