// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>

namespace mdana {

/// A nameless file in $TMPDIR (else /tmp) that goes with its owner, whatever ends the program. Throws
/// std::runtime_error, naming the directory, if it cannot be made, is full or does not give back what
/// was written.
class TemporaryFile {
 public:
  TemporaryFile();
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::uint64_t at, std::span<const std::byte> bytes);
  void read(std::uint64_t at, std::span<std::byte> bytes) const;

 private:
  std::string folder_;
  int descriptor_ = -1;
};

/// Records one behind the other in a temporary file, by number.
template <class Record>
class RecordFile {
  static_assert(std::is_trivially_copyable_v<Record>);

 public:
  void write(std::uint64_t first, std::span<const Record> records) {
    file_.write(first * sizeof(Record), std::as_bytes(records));
  }
  void read(std::uint64_t first, std::span<Record> records) const {
    file_.read(first * sizeof(Record), std::as_writable_bytes(records));
  }

 private:
  TemporaryFile file_;
};

}  // namespace mdana
