// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

namespace mdana {

/// A file as memory. If another program cuts it meanwhile, to look behind its new end stops this program: it says so,
/// with the file's name, on standard error and exits with 1.
class Mapping {
 public:
  /// Of the first `size` bytes; null if they cannot be mapped.
  static std::unique_ptr<Mapping> of(int descriptor, std::size_t size, const std::filesystem::path& path);
  ~Mapping();
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  std::string_view bytes() const { return bytes_; }

 private:
  explicit Mapping(std::string_view bytes) : bytes_(bytes) {}
  std::string_view bytes_;
};

}  // namespace mdana
