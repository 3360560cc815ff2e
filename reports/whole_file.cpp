// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/whole_file.hpp"

#include <vector>

#include <fmt/format.h>

#include "readers/byte_source.hpp"
#include "readers/input_error.hpp"

namespace mdana {

WholeFile read_whole(const std::filesystem::path& path) {
  constexpr std::size_t most_bytes = std::size_t{64} << 20;
  const auto source = open_bytes(path);
  WholeFile file;
  std::vector<char> piece(std::size_t{1} << 16);
  for (std::size_t n = piece.size(); n == piece.size();) {
    n = source->read(piece);
    file.text.append(piece.data(), n);
    if (file.text.size() > most_bytes)
      throw InputError(fmt::format("{}: larger than {} MB: too large for a table or a document", path.string(),
                                   most_bytes >> 20));
  }
  if (const std::string damage = source->damage(); !damage.empty())
    throw InputError(fmt::format("{}: {}", path.string(), damage));
  file.record = source->record();
  return file;
}

}  // namespace mdana
