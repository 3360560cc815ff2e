// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/line_reader.hpp"

#include <algorithm>
#include <cstring>

namespace mdana {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 18;

struct Newlines {
  std::size_t count;
  std::size_t end;  ///< offset behind the last of them
};

/// At most `wanted` newlines of `text`.
Newlines find_newlines(std::string_view text, std::size_t wanted) {
  Newlines found{0, 0};
  while (found.count < wanted) {
    const void* newline = std::memchr(text.data() + found.end, '\n', text.size() - found.end);
    if (!newline) break;
    found.end = static_cast<std::size_t>(static_cast<const char*>(newline) - text.data()) + 1;
    ++found.count;
  }
  return found;
}

}  // namespace

LineReader::LineReader(std::unique_ptr<ByteSource> bytes)
    : bytes_(std::move(bytes)), buffer_(buffer_size) {}

/// Appends bytes to the undelivered ones, growing the buffer for a line longer than it.
bool LineReader::refill() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
  const std::size_t got = bytes_->read({buffer_.data() + end_, buffer_.size() - end_});
  end_ += got;
  unfinished_ = got == 0 && end_ > begin_;
  return got > 0;
}

std::optional<std::string_view> LineReader::line() {
  std::size_t seen = 0;  // searched before, relative to begin_
  while (true) {
    const std::string_view rest(buffer_.data() + begin_, end_ - begin_);
    const std::size_t newline = rest.find('\n', seen);
    if (newline != std::string_view::npos) {
      begin_ += newline + 1;
      ++number_;
      std::string_view text = rest.substr(0, newline);
      if (text.ends_with('\r')) text.remove_suffix(1);
      return text;
    }
    seen = rest.size();
    if (!refill()) return std::nullopt;
  }
}

template <class Sink>
std::size_t LineReader::pass(std::size_t count, Sink&& sink) {
  std::size_t passed = 0;
  while (passed < count) {
    const std::string_view rest(buffer_.data() + begin_, end_ - begin_);
    const Newlines found = find_newlines(rest, count - passed);
    sink(rest.substr(0, found.end));
    begin_ += found.end;
    passed += found.count;
    if (passed < count && !refill()) break;
  }
  number_ += passed;
  return passed;
}

std::size_t LineReader::take(std::size_t count, std::vector<char>& into) {
  into.clear();
  return pass(count, [&](std::string_view lines) {
    into.insert(into.end(), lines.begin(), lines.end());
  });
}

std::size_t LineReader::skip(std::size_t count) {
  return pass(count, [](std::string_view) {});
}

void LineReader::mark() {
  marked_rest_.assign(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
                      buffer_.begin() + static_cast<std::ptrdiff_t>(end_));
  marked_number_ = number_;
  bytes_->mark();
}

void LineReader::reset() {
  std::copy(marked_rest_.begin(), marked_rest_.end(), buffer_.begin());
  begin_ = 0;
  end_ = marked_rest_.size();
  number_ = marked_number_;
  unfinished_ = false;
  bytes_->reset();
}

}  // namespace mdana
