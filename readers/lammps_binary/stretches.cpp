// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/lammps_binary/stretches.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::lammps_binary {
namespace {

constexpr std::size_t piece = std::size_t{1} << 18;  ///< of a file that is not mapped

}  // namespace

Stretches::Stretches(std::unique_ptr<ByteSource> bytes, std::string path)
    : bytes_(std::move(bytes)), path_(std::move(path)) {
  if ((mapped_ = bytes_->mapped())) {
    rest_ = *mapped_;
  }
}

/// The next bytes of a mapped file, fewer at its end.
std::string_view Stretches::pass(std::size_t count) {
  const std::string_view bytes = rest_.substr(0, count);
  bytes_->passed(bytes);
  rest_.remove_prefix(bytes.size());
  position_ += bytes.size();
  return bytes;
}

std::size_t Stretches::read(std::span<char> into) {
  if (mapped_) return pass(into.size()).copy(into.data(), into.size());
  const std::size_t got = bytes_->read(into);
  position_ += got;
  return got;
}

std::optional<std::string_view> Stretches::view(std::size_t count, std::size_t padding) {
  if (!mapped_ || rest_.size() < count || rest_.size() - count < padding) return std::nullopt;
  return pass(count);
}

std::size_t Stretches::append(std::size_t count, std::vector<char>& storage) {
  const std::size_t before = storage.size();
  std::size_t left = count;
  for (bool more = true; more && left > 0;) {
    const std::size_t wanted = std::min(left, mapped_ ? rest_.size() : piece);
    const std::size_t start = storage.size();
    storage.resize(start + wanted);
    const std::size_t got = read({storage.data() + start, wanted});
    storage.resize(start + got);
    left -= got;
    more = got > 0 && got == wanted;
  }
  return storage.size() - before;
}

std::uint64_t Stretches::skip(std::uint64_t count) {
  if (mapped_) return pass(static_cast<std::size_t>(count)).size();
  std::vector<char> scratch(static_cast<std::size_t>(std::min<std::uint64_t>(count, piece)));
  std::uint64_t skipped = 0;
  while (skipped < count) {
    const std::size_t wanted =
        static_cast<std::size_t>(std::min<std::uint64_t>(count - skipped, scratch.size()));
    const std::size_t got = read({scratch.data(), wanted});
    skipped += got;
    if (got < wanted) break;
  }
  return skipped;
}

std::optional<std::uint64_t> Stretches::offset() const {
  return mapped_ ? std::optional(position_) : std::nullopt;
}

void Stretches::jump(std::uint64_t offset) {
  position_ = std::min<std::uint64_t>(offset, mapped_->size());
  rest_ = mapped_->substr(position_);
}

void Stretches::mark() {
  marked_position_ = position_;
  marked_rest_ = rest_;
  if (!mapped_) bytes_->mark();
}

void Stretches::reset() {
  position_ = marked_position_;
  rest_ = marked_rest_;
  if (!mapped_) bytes_->reset();
}

void Stretches::fail(const std::string& what) const {
  throw InputError(fmt::format("{}: byte {}: {}", path_, position_, what));
}

void Stretches::ended(const std::string& where) const {
  check_damage();
  throw TruncatedInput(fmt::format("{}: the file ends {}", path_, where));
}

void Stretches::check_damage() const {
  const std::string damage = bytes_->damage();
  if (!damage.empty()) throw TruncatedInput(fmt::format("{}: {}", path_, damage));
}

}  // namespace mdana::lammps_binary
