// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/atomic_file.hpp"
#include "reports/hdf5_tables.hpp"
#include "reports/sink.hpp"

namespace mdana {
namespace {

void write(const std::filesystem::path& path, const Document& document, const Table* table) {
  write_file_by(path, [&](const std::filesystem::path& temporary) {
    hdf5::Group file = hdf5::create_file(temporary);
    hdf5::put_text(file, "document", document.to_json());
    hdf5::Group results = file.make_group("results", true);
    hdf5::put_numbers(results, document.content());
    if (table) {
      hdf5::Group columns = file.make_group("table", true);
      hdf5::put_table(columns, *table, document.units());
    }
    for (const FurtherTable& other : document.further_tables()) {
      hdf5::Group group = file.has_group(other.group) ? file.group(other.group) : file.make_group(other.group, true);
      hdf5::Group columns = group.make_group(other.name, true);
      hdf5::put_table(columns, other.table, document.units());
    }
    hdf5::flush(file);
  });
}

}  // namespace

extern const Sink hdf5_sink;
const Sink hdf5_sink{"hdf5", ".h5", "all of it", false, true, write};

}  // namespace mdana
