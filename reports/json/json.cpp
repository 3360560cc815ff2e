// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/atomic_file.hpp"
#include "reports/sink.hpp"

namespace mdana {
namespace {

void write(const std::filesystem::path& path, const Document& document, const Table*) {
  write_file(path, document.to_json());
}

}  // namespace

extern const Sink json_sink;
const Sink json_sink{"json", ".json", "the document", false, false, write};

}  // namespace mdana
