// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "readers/input_error.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana::fuzz {

/// Writes the bytes to a file of that name in a folder of this process; the next file of the name
/// takes its place.
std::filesystem::path input_file(const std::string& name, std::string_view bytes);

/// Throws unless a message names the file, and is one that can be read.
void expect_clear(const InputError& error, const std::filesystem::path& file);

template <class Read>
void read_or_refuse(const std::filesystem::path& file, Read&& read) {
  try {
    read();
  } catch (const InputError& error) {
    expect_clear(error, file);
  }
}

/// As the commands read dumps: headers alone, every column of every atom, positions of selected
/// atoms, frames ahead, and on after faults as `mdana check` does.
void read_dump(const std::filesystem::path& file);

}  // namespace mdana::fuzz
