// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/atomic_file.hpp"

#include <stdexcept>

#include "readers/byte_sink.hpp"
#include "reports/output_file.hpp"

namespace mdana {

void write_file(const std::filesystem::path& path, std::string_view text) {
  OutputFile file(path);
  try {
    const auto bytes = create_plain(file.path());
    bytes->write(text);
    bytes->finish();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file.told(error.what()));
  }
  file.commit();
}

}  // namespace mdana
