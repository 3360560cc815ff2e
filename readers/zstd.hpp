// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>

#include "readers/byte_source.hpp"
#include "readers/raw_file.hpp"

namespace mdana {

/// By the first four bytes: a zstd frame or a skippable one (RFC 8878).
bool is_zstd(std::string_view head);

/// Decompresses zstd, frames one after another, checksums verified where there are any. Of two
/// decompressors one reads and one waits at an earlier place; `reset` lets the second catch up with
/// the mark and exchanges them. Hence a reset for each of a dump's frames costs no more than
/// decompressing everything twice, and memory is that of two windows (2 x 2 MB at level 3, 2 x 8 MB
/// at level 19, never more than 2 x 128 MB); only a second reset to the same mark starts again at
/// the zstd frame that the mark lies in.
/// Throws InputError if mdana was built without zstd.
std::unique_ptr<ByteSource> open_zstd(std::unique_ptr<RawFile> file);

}  // namespace mdana
