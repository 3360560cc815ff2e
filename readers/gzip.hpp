// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "readers/byte_source.hpp"
#include "readers/inflate.hpp"
#include "readers/raw_file.hpp"

namespace mdana {

/// ISA-L where mdana was built with it, else zlib.
std::unique_ptr<Inflate> fastest_inflate();

/// Decompresses gzip (RFC 1952), members one after another, checksums verified. Zero bytes behind
/// the last member are padding, as for gzip itself; anything else there is damage.
std::unique_ptr<ByteSource> open_gzip(std::unique_ptr<RawFile> file,
                                      std::unique_ptr<Inflate> inflate = fastest_inflate());

}  // namespace mdana
