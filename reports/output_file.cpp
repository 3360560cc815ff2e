// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string_view>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace mdana {
namespace {

/// The bytes are on the disk before the name is.
bool sync(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const int result = ::fsync(descriptor);
  const int error = errno;
  ::close(descriptor);
  errno = error;
  return result == 0;
}

/// Tells processes of different machines apart that write to one directory with the same number.
std::size_t machine() {
  static const std::size_t hash = [] {
    char name[256] = {};
    ::gethostname(name, sizeof(name) - 1);
    return std::hash<std::string_view>{}(name) & 0xffffffff;
  }();
  return hash;
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& place)
    : place_(place),
      temporary_(place.parent_path() /
                 fmt::format(".{}-{:x}.part.{}", ::getpid(), machine(), place.filename().string())) {}

OutputFile::~OutputFile() {
  if (!renamed_) ::unlink(temporary_.c_str());
}

std::string OutputFile::told(std::string what) const {
  const std::string name = temporary_.string();
  const std::size_t at = what.find(name);
  return at == what.npos ? what : what.replace(at, name.size(), place_.string());
}

void OutputFile::commit() {
  if (!sync(temporary_)) fail("write");
  if (::rename(temporary_.c_str(), place_.c_str()) != 0) fail("create");
  renamed_ = true;
}

void OutputFile::fail(const char* doing) const {
  throw std::runtime_error(
      fmt::format("{}: cannot {}: {}", place_.string(), doing, std::strerror(errno)));
}

}  // namespace mdana
