// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/csv.hpp"

#include "reports/atomic_file.hpp"
#include "reports/sink.hpp"

namespace mdana {
namespace {

void write(const std::filesystem::path& path, const Document&, const Table* table) {
  write_file(path, to_csv(*table));
}

}  // namespace

extern const Sink csv_sink;
const Sink csv_sink{"csv", ".csv", "the table", true, false, write};

}  // namespace mdana
