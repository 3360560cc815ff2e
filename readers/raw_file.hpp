// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "readers/input_record.hpp"
#include "readers/mapping.hpp"

namespace mdana {

/// The bytes of a file in their order, each hashed once as it is first read.
class RawFile {
 public:
  /// Throws InputError if the file cannot be opened or is not a regular file.
  explicit RawFile(const std::filesystem::path& path);
  ~RawFile();
  RawFile(const RawFile&) = delete;
  RawFile& operator=(const RawFile&) = delete;

  /// Bytes read; fewer than asked for only at the end of the file.
  std::size_t read(std::span<char> into);

  /// The whole file as mapped memory; nothing if it is empty or cannot be mapped.
  std::optional<std::string_view> mapped();
  /// Counts mapped bytes as read. Those behind a gap are hashed when `record` reads the gap.
  void passed(std::string_view bytes);

  /// How much of the file was read or passed, 0 to 1.
  double share() const;

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t position() const { return position_; }
  void seek(std::uint64_t position);

  /// Path, size and hash of the whole file; reads what has not been read yet, unless a hash that is
  /// known from before may be assumed.
  InputRecord record();
  void assume_hash(std::string hash) { assumed_hash_ = std::move(hash); }

 private:
  void release(std::uint64_t position);
  bool changed() const;

  struct Hash;
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t position_ = 0;
  std::unique_ptr<Hash> hash_;
  std::uint64_t size_ = 0;  ///< when it was opened
  std::int64_t modified_ = 0;  ///< when it was opened, in nanoseconds
  std::string assumed_hash_;
  std::unique_ptr<Mapping> map_;
  std::uint64_t passed_ = 0;  ///< mapped bytes
  std::uint64_t released_ = 0;  ///< mapped bytes before it are given back
};

}  // namespace mdana
