// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace mdana {

/// Which bytes a result was made from.
struct InputRecord {
  std::string path;
  std::uint64_t size = 0;  ///< bytes on disk
  std::string hash;        ///< "xxh3:" and 32 hexadecimal digits (XXH3, 128 bit) of those bytes
};

}  // namespace mdana
