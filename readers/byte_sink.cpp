// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/byte_sink.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace mdana {
namespace {

class Plain final : public ByteSink {
 public:
  explicit Plain(const std::filesystem::path& path)
      : name_(path.string()),
        descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail("create");
    buffer_.reserve(capacity);
  }
  ~Plain() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Plain(const Plain&) = delete;
  Plain& operator=(const Plain&) = delete;

  void write(std::string_view bytes) override {
    if (buffer_.size() + bytes.size() > capacity) flush();
    if (bytes.size() >= capacity)
      put(bytes);
    else
      buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  }

  void finish() override {
    flush();
    const int result = ::close(descriptor_);
    descriptor_ = -1;
    if (result != 0) fail("write");
  }

 private:
  static constexpr std::size_t capacity = std::size_t{1} << 18;  // bytes

  void flush() {
    put({buffer_.data(), buffer_.size()});
    buffer_.clear();
  }

  void put(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail("write");
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
  }

  [[noreturn]] void fail(std::string_view doing) const {
    throw std::runtime_error(fmt::format("{}: cannot {}: {}", name_, doing, std::strerror(errno)));
  }

  std::string name_;
  int descriptor_;
  std::vector<char> buffer_;
};

}  // namespace

std::unique_ptr<ByteSink> create_plain(const std::filesystem::path& path) {
  return std::make_unique<Plain>(path);
}

std::unique_ptr<ByteSink> create_bytes(const std::filesystem::path& path) {
  const std::string name = path.string();
  if (name.ends_with(".gz")) return gzip_into(create_plain(path), name);
  if (name.ends_with(".zst")) return zstd_into(create_plain(path), name);
  return create_plain(path);
}

}  // namespace mdana
