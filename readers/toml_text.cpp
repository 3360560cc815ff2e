// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/toml_text.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{16} << 20;  ///< a study of 10^5 runs
constexpr int most_dots = 32;  ///< in one key, each of which is a table more

/// The line of a key with more dots; 0 if there is none. Counts in texts and comments, too.
std::size_t line_of_deep_key(std::string_view text) {
  int dots = 0;
  std::size_t line = 1;
  for (const char c : text) {
    line += c == '\n';
    if (c == '.' && ++dots > most_dots) return line;
    if (std::string_view("\n=,[]{}#").find(c) != std::string_view::npos) dots = 0;
  }
  return 0;
}

}  // namespace

std::string toml_text(const std::filesystem::path& file) {
  if (std::filesystem::file_size(file) > most_bytes)
    throw InputError(fmt::format("{}: larger than {} MB: too large for a file of settings",
                                 file.string(), most_bytes >> 20));
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream) throw InputError(fmt::format("{}: cannot be read", file.string()));
  if (const std::size_t line = line_of_deep_key(text))
    throw InputError(fmt::format("{}:{}: more than {} dots in a row: no key is that deep",
                                 file.string(), line, most_dots));
  return text;
}

}  // namespace mdana
