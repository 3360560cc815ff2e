// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/raw_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#if defined(__x86_64__)
#include <xxh_x86dispatch.h>  // the widest instructions that the processor has
#else
#include <xxhash.h>
#endif

#include "readers/input_error.hpp"

namespace mdana {
namespace {

InputError system_error(const std::filesystem::path& path, std::string_view doing) {
  return InputError(fmt::format("{}: cannot {}: {}", path.string(), doing, std::strerror(errno)));
}

int open_for_reading(const std::filesystem::path& path) {
  // O_NONBLOCK: a pipe without a writer must not hang; it changes nothing for files.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) throw system_error(path, "open");
  struct stat status {};
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) return descriptor;
  ::close(descriptor);
  throw InputError(fmt::format("{}: not a file; give the path of a dump", path.string()));
}

struct stat status_of(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || status.st_size < 0) status = {};
  return status;
}

/// Of the last change [ns].
std::int64_t time_of(const struct stat& status) {
  return std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
}

}  // namespace

struct RawFile::Hash {
  Hash() { XXH3_128bits_reset(state); }
  ~Hash() { XXH3_freeState(state); }
  Hash(const Hash&) = delete;
  Hash& operator=(const Hash&) = delete;

  void add(std::string_view more) {
    XXH3_128bits_update(state, more.data(), more.size());
    bytes += more.size();
  }

  XXH3_state_t* state = XXH3_createState();
  std::uint64_t bytes = 0;  ///< hashed so far, from the start of the file
};

RawFile::RawFile(const std::filesystem::path& path)
    : path_(path), descriptor_(open_for_reading(path)), hash_(std::make_unique<Hash>()) {
  const struct stat status = status_of(descriptor_);
  size_ = static_cast<std::uint64_t>(status.st_size);
  modified_ = time_of(status);
}

double RawFile::share() const {
  const auto behind = static_cast<double>(std::max(passed_, position_));
  return size_ == 0 ? 1 : std::min(1.0, behind / static_cast<double>(size_));
}

RawFile::~RawFile() { ::close(descriptor_); }

std::optional<std::string_view> RawFile::mapped() {
  const auto size = static_cast<std::size_t>(status_of(descriptor_).st_size);
  if (!map_ && size > 0) map_ = Mapping::of(descriptor_, size, path_);
  if (!map_) return std::nullopt;
  return map_->bytes();
}

void RawFile::passed(std::string_view bytes) {
  const auto first = static_cast<std::uint64_t>(bytes.data() - map_->bytes().data());
  const std::uint64_t known = hash_->bytes - std::min(hash_->bytes, first);
  if (first <= hash_->bytes && known < bytes.size()) hash_->add(bytes.substr(known));
  passed_ = first + bytes.size();
  release(passed_);
}

/// Gives back the memory of mapped pages well behind `position`; they are read again if needed.
void RawFile::release(std::uint64_t position) {
  constexpr std::uint64_t step = std::uint64_t{1} << 24;  // a multiple of any page size
  if (position < released_) released_ = position / step * step;
  if (position < released_ + 2 * step) return;
  const std::uint64_t end = (position - step) / step * step;
  ::madvise(const_cast<char*>(map_->bytes().data()) + released_, end - released_, MADV_DONTNEED);
  released_ = end;
}

void RawFile::seek(std::uint64_t position) {
  if (position > hash_->bytes)
    throw std::logic_error("RawFile::seek goes back only, else bytes would escape the hash");
  position_ = position;
}

std::size_t RawFile::read(std::span<char> into) {
  std::size_t got = 0;
  while (got < into.size()) {
    const ssize_t n = ::pread(descriptor_, into.data() + got, into.size() - got,
                              static_cast<off_t>(position_ + got));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw system_error(path_, "read");
    if (n == 0) break;
    got += static_cast<std::size_t>(n);
  }
  if (position_ + got > hash_->bytes) {
    const std::size_t known = hash_->bytes - position_;
    hash_->add({into.data() + known, got - known});
  }
  position_ += got;
  return got;
}

bool RawFile::changed() const {
  const struct stat now = status_of(descriptor_);
  return static_cast<std::uint64_t>(now.st_size) != size_ || time_of(now) != modified_;
}

InputRecord RawFile::record() {
  if (!assumed_hash_.empty() && hash_->bytes < size_) return {path_.string(), size_, assumed_hash_, changed()};
  std::vector<char> rest(1 << 20);
  position_ = hash_->bytes;
  while (read(rest) == rest.size()) continue;
  const XXH128_hash_t h = XXH3_128bits_digest(hash_->state);
  return {path_.string(), hash_->bytes, fmt::format("xxh3:{:016x}{:016x}", h.high64, h.low64), changed()};
}

}  // namespace mdana
