// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

namespace mdana {

/// Takes the bytes of a new file in their order.
class ByteSink {
 public:
  virtual ~ByteSink() = default;

  /// Throws std::runtime_error naming the file if the bytes cannot be written; so does `finish`.
  virtual void write(std::string_view bytes) = 0;

  /// Ends the file; without it the file is not whole.
  virtual void finish() = 0;
};

/// Makes a new file, or empties the one that is there; it is compressed as its name says: `.gz` by
/// gzip, `.zst` by zstd, any other not at all.
/// Throws std::runtime_error if it cannot be made, or if this mdana was built without zstd.
std::unique_ptr<ByteSink> create_bytes(const std::filesystem::path& path);

std::unique_ptr<ByteSink> create_plain(const std::filesystem::path& path);

/// Compress what goes into another sink, whose name is for messages.
std::unique_ptr<ByteSink> gzip_into(std::unique_ptr<ByteSink> file, const std::string& name);
std::unique_ptr<ByteSink> zstd_into(std::unique_ptr<ByteSink> file, const std::string& name);

}  // namespace mdana
