// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "readers/byte_source.hpp"

namespace mdana {

/// Lines of a text, one by one or thousands at a time, with their numbers. Throws InputError at a line
/// or at lines of one call that are longer than those of any dump.
class LineReader {
 public:
  explicit LineReader(std::unique_ptr<ByteSource> bytes);

  /// The next line without its end (LF or CRLF), valid until the next call; nothing at the end of
  /// the text. A last line without LF counts as cut off: see `unfinished`.
  std::optional<std::string_view> line();

  /// The next line as `line` gives it, which is not passed over.
  std::optional<std::string_view> peek();

  /// Up to `count` whole lines, ends included: where they are mapped, or copied to `storage`. At
  /// least `lead` readable bytes precede them, and `padding` follow. Ends before a line that begins
  /// with `stop`, if that is not empty.
  static constexpr std::size_t lead = 32;
  struct Lines {
    std::size_t count;
    std::string_view text;
  };
  Lines take(std::size_t count, std::vector<char>& storage, std::size_t padding = 0,
             std::string_view stop = {});

  /// Passes over up to `count` whole lines. Returns how many.
  std::size_t skip(std::size_t count, std::string_view stop = {});

  /// Bytes before the next line, and a jump to a line that begins there; of mapped files only.
  std::optional<std::uint64_t> offset() const;
  void jump(std::uint64_t offset, std::uint64_t lines_before);

  std::uint64_t number() const { return number_; }  ///< of the line last delivered, from 1
  bool unfinished() const { return unfinished_; }   ///< the text ended within a line
  bool met_too_long() const { return met_too_long_; }  ///< a line that nothing goes on behind

  void mark();
  void reset();

  ByteSource& bytes() { return *bytes_; }
  const ByteSource& bytes() const { return *bytes_; }

 private:
  [[noreturn]] void too_long(std::string_view what);
  bool refill();
  std::optional<std::size_t> next_newline();
  void deliver(std::size_t bytes);
  template <class Sink>
  std::size_t pass(std::size_t count, std::string_view stop, Sink&& sink);

  std::unique_ptr<ByteSource> bytes_;
  std::optional<std::string_view> mapped_;
  std::vector<char> buffer_;  ///< unused if the file is mapped
  std::string_view rest_;     ///< not yet delivered: in the buffer, or all that is left of the file
  std::uint64_t number_ = 0;
  bool unfinished_ = false;
  bool met_too_long_ = false;
  std::vector<char> marked_copy_;
  std::string_view marked_rest_;
  std::uint64_t marked_number_ = 0;
};

}  // namespace mdana
