// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

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

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& place)
    : place_(place),
      temporary_(place.parent_path() /
                 fmt::format(".{}.part.{}", ::getpid(), place.filename().string())) {}

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
