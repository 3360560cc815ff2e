// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "readers/byte_source.hpp"

namespace mdana::lammps_binary {

/// The bytes of a binary file, stretch by stretch; knows where it is for messages. Memory grows
/// with the bytes that are there, not with those that are asked for.
class Stretches {
 public:
  Stretches(std::unique_ptr<ByteSource> bytes, std::string path);

  /// Bytes delivered; fewer than asked for only at the end.
  std::size_t read(std::span<char> into);

  /// The next `count` bytes where they are mapped, if they and `padding` more are there; else
  /// nothing is passed.
  std::optional<std::string_view> view(std::size_t count, std::size_t padding);

  /// Adds up to `count` bytes to the storage. Returns how many.
  std::size_t append(std::size_t count, std::vector<char>& storage);

  /// Passes over up to `count` bytes. Returns how many.
  std::uint64_t skip(std::uint64_t count);

  /// Bytes before this place, and a jump to another one; of mapped files only.
  std::optional<std::uint64_t> offset() const;
  void jump(std::uint64_t offset);

  void mark();
  void reset();

  [[noreturn]] void fail(const std::string& what) const;  ///< InputError with the place
  /// TruncatedInput; if the compressed data are damaged, it says that instead.
  [[noreturn]] void ended(const std::string& where) const;

  /// Throws TruncatedInput if the compressed data met so far are damaged.
  void check_damage() const;

  const std::string& path() const { return path_; }
  ByteSource& bytes() { return *bytes_; }
  const ByteSource& bytes() const { return *bytes_; }

 private:
  std::string_view pass(std::size_t count);

  std::unique_ptr<ByteSource> bytes_;
  std::string path_;
  std::optional<std::string_view> mapped_;
  std::string_view rest_;  ///< all that is left of a mapped file
  std::uint64_t position_ = 0;
  std::string_view marked_rest_;
  std::uint64_t marked_position_ = 0;
};

}  // namespace mdana::lammps_binary
