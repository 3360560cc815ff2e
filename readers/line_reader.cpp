// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/line_reader.hpp"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "readers/input_error.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace mdana {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 18;

// Of text, in bytes: more is not of a dump (a line of 4096 columns has some 100 kB).
constexpr std::size_t longest_line = std::size_t{1} << 24;
constexpr std::size_t longest_lines = std::size_t{1} << 29;  ///< taken at once

struct Newlines {
  std::size_t count;
  std::size_t end;  ///< offset behind the last of them
};

constexpr std::size_t stretch = 4096;  ///< bytes whose newlines are counted at once

#if defined(__SSE2__)
std::size_t newlines_of_stretch(const char* text) {
  const __m128i newline = _mm_set1_epi8('\n');
  __m128i counts[4] = {};  // of 64 bytes each, so that no byte overflows
  for (std::size_t i = 0; i < stretch; i += 64)
    for (std::size_t k = 0; k < 4; ++k) {
      const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(text + i + 16 * k));
      counts[k] = _mm_sub_epi8(counts[k], _mm_cmpeq_epi8(bytes, newline));
    }
  __m128i sum = _mm_setzero_si128();
  for (const __m128i& count : counts)
    sum = _mm_add_epi64(sum, _mm_sad_epu8(count, _mm_setzero_si128()));
  return static_cast<std::size_t>(_mm_cvtsi128_si64(_mm_add_epi64(sum, _mm_srli_si128(sum, 8))));
}
#else
std::size_t newlines_of_stretch(const char* text) {
  return static_cast<std::size_t>(std::count(text, text + stretch, '\n'));
}
#endif

/// At most `wanted` newlines of `text`: counted by stretches, the last ones looked for.
Newlines find_newlines(std::string_view text, std::size_t wanted) {
  std::size_t count = 0, at = 0;
  while (text.size() - at >= stretch) {
    const std::size_t more = newlines_of_stretch(text.data() + at);
    if (count + more >= wanted) break;
    count += more;
    at += stretch;
  }
  while (count < wanted) {
    const std::size_t newline = text.find('\n', at);
    if (newline == std::string_view::npos) return {count, text.rfind('\n') + 1};
    at = newline + 1;
    ++count;
  }
  return {count, at};
}

/// Of whole lines those before the first that begins with `stop`.
Newlines before(std::string_view lines, std::string_view stop, const Newlines& all) {
  std::size_t at = lines.find(stop);
  while (at != std::string_view::npos && at > 0 && lines[at - 1] != '\n')
    at = lines.find(stop, at + 1);
  if (at == std::string_view::npos) return all;
  const auto count = std::count(lines.begin(), lines.begin() + static_cast<long>(at), '\n');
  return {static_cast<std::size_t>(count), at};
}

std::string_view without_return(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace

LineReader::LineReader(std::unique_ptr<ByteSource> bytes) : bytes_(std::move(bytes)) {
  if ((mapped_ = bytes_->mapped())) {
    rest_ = *mapped_;
  } else {
    buffer_.resize(buffer_size);
    rest_ = {buffer_.data(), 0};
  }
}

void LineReader::too_long(std::string_view what) {
  met_too_long_ = true;
  throw InputError(fmt::format("{}:{}: {}: this is no text of atoms", bytes_->path().string(),
                               number_ + 1, what));
}

/// Appends bytes to the undelivered ones, growing the buffer for a line longer than it.
bool LineReader::refill() {
  std::size_t got = 0;
  if (!mapped_) {
    if (rest_.size() >= longest_line) too_long("a line of more than 16 MB");
    std::memmove(buffer_.data(), rest_.data(), rest_.size());
    if (rest_.size() == buffer_.size()) buffer_.resize(2 * buffer_.size());
    got = bytes_->read({buffer_.data() + rest_.size(), buffer_.size() - rest_.size()});
    rest_ = {buffer_.data(), rest_.size() + got};
  }
  unfinished_ = got == 0 && !rest_.empty();
  return got > 0;
}

void LineReader::deliver(std::size_t bytes) {
  if (mapped_) bytes_->passed(rest_.substr(0, bytes));
  rest_.remove_prefix(bytes);
}

/// Where the next line ends; nothing if no whole one is left.
std::optional<std::size_t> LineReader::next_newline() {
  std::size_t seen = 0;  // searched before
  while (true) {
    const std::string_view within = rest_.substr(0, longest_line);
    const std::size_t newline = within.find('\n', seen);
    if (newline != std::string_view::npos) return newline;
    if (within.size() < rest_.size()) too_long("a line of more than 16 MB");
    seen = rest_.size();
    if (!refill()) return std::nullopt;
  }
}

std::optional<std::string_view> LineReader::line() {
  const auto newline = next_newline();
  if (!newline) return std::nullopt;
  const std::string_view text = without_return(rest_.substr(0, *newline));
  deliver(*newline + 1);
  ++number_;
  return text;
}

std::optional<std::string_view> LineReader::peek() {
  const auto newline = next_newline();
  if (!newline) return std::nullopt;
  return without_return(rest_.substr(0, *newline));
}

template <class Sink>
std::size_t LineReader::pass(std::size_t count, std::string_view stop, Sink&& sink) {
  std::size_t passed = 0;
  while (passed < count) {
    Newlines found = find_newlines(rest_, count - passed);
    const std::size_t end = found.end;
    if (!stop.empty()) found = before(rest_.substr(0, end), stop, found);
    sink(rest_.substr(0, found.end));
    deliver(found.end);
    passed += found.count;
    if (found.end < end || (passed < count && !refill())) break;
  }
  number_ += passed;
  return passed;
}

LineReader::Lines LineReader::take(std::size_t count, std::vector<char>& storage,
                                   std::size_t padding, std::string_view stop) {
  storage.assign(lead, ' ');
  const bool led = mapped_ && *offset() >= lead;
  std::string_view text;  // of a mapped file it is one piece, since nothing is refilled
  const std::size_t got = pass(count, stop, [&](std::string_view lines) {
    text = lines;
    if (storage.size() + lines.size() > longest_lines)
      too_long(fmt::format("{} lines of more than 512 MB", count));
    if (!led || rest_.size() - lines.size() < padding)
      storage.insert(storage.end(), lines.begin(), lines.end());
  });
  if (storage.size() == lead) return {got, text};
  const std::size_t size = storage.size() - lead;
  storage.resize(storage.size() + padding);
  return {got, {storage.data() + lead, size}};
}

std::size_t LineReader::skip(std::size_t count, std::string_view stop) {
  return pass(count, stop, [](std::string_view) {});
}

std::optional<std::uint64_t> LineReader::offset() const {
  if (!mapped_) return std::nullopt;
  return mapped_->size() - rest_.size();
}

void LineReader::jump(std::uint64_t offset, std::uint64_t lines_before) {
  rest_ = mapped_->substr(std::min<std::uint64_t>(offset, mapped_->size()));
  number_ = lines_before;
  unfinished_ = false;
}

void LineReader::mark() {
  marked_number_ = number_;
  marked_rest_ = rest_;
  if (mapped_) return;
  marked_copy_.assign(rest_.begin(), rest_.end());
  bytes_->mark();
}

void LineReader::reset() {
  number_ = marked_number_;
  unfinished_ = false;
  rest_ = marked_rest_;
  if (mapped_) return;
  std::copy(marked_copy_.begin(), marked_copy_.end(), buffer_.begin());
  rest_ = {buffer_.data(), marked_copy_.size()};
  bytes_->reset();
}

}  // namespace mdana
