// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/scratch_file.hpp"

#include <fstream>
#include <random>
#include <stdexcept>

#include <fmt/format.h>

namespace mdana {

ScratchFile::ScratchFile(std::string_view bytes)
    : path_(std::filesystem::temp_directory_path() / fmt::format("mdana-scratch-{:08x}", std::random_device{}())) {
  std::ofstream file(path_, std::ios::binary);
  if (!(file << bytes).flush()) throw std::runtime_error(path_.string() + ": cannot be written");
}

ScratchFile::~ScratchFile() {
  std::error_code ignored;  // nothing can be done about it here
  std::filesystem::remove(path_, ignored);
}

}  // namespace mdana
