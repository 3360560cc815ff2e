// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/atomic_file.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace mdana {
namespace {

/// A file that vanishes unless it is renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target)
      : target_(target),
        path_(target.parent_path() / fmt::format(".{}.{}.part", target.filename().string(),
                                                 ::getpid())),
        descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail("create");
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

  void write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t n = ::write(descriptor_, text.data(), text.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail("write");
      text.remove_prefix(static_cast<std::size_t>(n));
    }
  }

  void commit() {
    if (::fsync(descriptor_) != 0) fail("write");
    const int result = ::close(descriptor_);
    descriptor_ = -1;
    if (result != 0) fail("write");
    if (::rename(path_.c_str(), target_.c_str()) != 0) fail("create");
    renamed_ = true;
  }

 private:
  [[noreturn]] void fail(std::string_view doing) const {
    throw std::runtime_error(
        fmt::format("{}: cannot {}: {}", target_.string(), doing, std::strerror(errno)));
  }
  std::filesystem::path target_, path_;
  int descriptor_;
  bool renamed_ = false;
};

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view text) {
  TemporaryFile file(path);
  file.write(text);
  file.commit();
}

void write_file_by(const std::filesystem::path& path,
                   const std::function<void(const std::filesystem::path& temporary)>& write) {
  TemporaryFile file(path);
  write(file.path());
  file.commit();
}

}  // namespace mdana
