// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "readers/input_record.hpp"

namespace mdana {

/// The decompressed bytes of a file in their order, with one place to go back to.
class ByteSource {
 public:
  virtual ~ByteSource() = default;

  /// Bytes delivered; fewer than asked for only at the end.
  virtual std::size_t read(std::span<char> into) = 0;

  /// All bytes at once if the file can be mapped into memory; who uses them tells `passed`, in order.
  virtual std::optional<std::string_view> mapped() { return std::nullopt; }
  virtual void passed(std::string_view) {}

  /// How much of the file lies behind, 0 to 1.
  virtual double share() const = 0;

  virtual void mark() = 0;   ///< remembers this place
  virtual void reset() = 0;  ///< goes back to it

  /// What is wrong with the compressed data met so far ("gzip data end early ..."); else empty.
  virtual std::string damage() const { return {}; }

  virtual const std::filesystem::path& path() const = 0;

  virtual InputRecord record() = 0;

  /// The hash of the whole file is known: `record` need not read what was passed over.
  virtual void assume_hash(const std::string&) {}
};

/// Opens a file by its first bytes: gzip (any number of members), zstd (any
/// number of frames) or plain.
/// Throws InputError if it cannot be opened.
std::unique_ptr<ByteSource> open_bytes(const std::filesystem::path& path);

}  // namespace mdana
