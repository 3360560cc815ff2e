// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "readers/byte_source.hpp"
#include "readers/raw_file.hpp"

namespace mdana {

/// Decompresses gzip (RFC 1952), members one after another, checksums verified.
std::unique_ptr<ByteSource> open_gzip(std::unique_ptr<RawFile> file);

}  // namespace mdana
