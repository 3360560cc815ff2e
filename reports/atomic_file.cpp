// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/atomic_file.hpp"

#include <stdexcept>

#include "readers/byte_sink.hpp"
#include "readers/ranks.hpp"
#include "reports/output_file.hpp"

namespace mdana {

void write_file(const std::filesystem::path& path, std::string_view text) {
  write_file_by(path, [&](const std::filesystem::path& temporary) {
    const auto bytes = create_plain(temporary);
    bytes->write(text);
    bytes->finish();
  });
}

void write_file_by(const std::filesystem::path& path,
                   const std::function<void(const std::filesystem::path& temporary)>& write) {
  if (!is_first_rank()) return;
  OutputFile file(path);
  file.writing([&] { write(file.path()); });
  file.commit();
}

}  // namespace mdana
