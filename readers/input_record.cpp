// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/input_record.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include "readers/raw_file.hpp"

namespace mdana {

std::string content_hash(std::string_view bytes) {
  const XXH128_hash_t h = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("xxh3:{:016x}{:016x}", h.high64, h.low64);
}

InputRecord input_record(const std::filesystem::path& file) { return RawFile(file).record(); }

}  // namespace mdana
