// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/hdf5_file.hpp"

#ifdef MDANA_WITH_HDF5
#include "reports/hdf5_tables.hpp"
#endif

namespace mdana {

#ifdef MDANA_WITH_HDF5

struct StudyHdf5::File {
  explicit File(const std::filesystem::path& path)
      : root(hdf5::create_file(path)), runs(root.make_group("runs", true)), tables(root.make_group("tables", true)) {}

  hdf5::Group root, runs, tables;
};

StudyHdf5::StudyHdf5(const std::filesystem::path& file) : file_(std::make_unique<File>(file)) {}

bool StudyHdf5::available() { return true; }

void StudyHdf5::add_run(const ReportedRun& run, const RunRecord& record) {
  hdf5::Group group = file_->runs.make_group(run.file, true);
  group.set_text("name", run.name);
  group.set_text("group", run.group);
  group.set_text("interaction", std::string(name(run.scene.interaction)));
  hdf5::put_text(group, "document", to_text(run.document));
  hdf5::Group results = group.make_group("results", true);
  hdf5::put_numbers(results, run.document);
  for (const NamedTable& named : record.tables) {
    hdf5::Group columns = group.make_group(named.name, true);
    hdf5::put_table(columns, named.table, run.units());
  }
}

void StudyHdf5::add_table(const NamedTable& named, Units units) {
  hdf5::Group columns = file_->tables.make_group(named.name, true);
  hdf5::put_table(columns, named.table, units);
}

void StudyHdf5::finish(const nlohmann::ordered_json& document) {
  hdf5::put_text(file_->root, "document", to_text(document));
  hdf5::flush(file_->root);
}

#else

struct StudyHdf5::File {};

StudyHdf5::StudyHdf5(const std::filesystem::path&) {}
bool StudyHdf5::available() { return false; }
void StudyHdf5::add_run(const ReportedRun&, const RunRecord&) {}
void StudyHdf5::add_table(const NamedTable&, Units) {}
void StudyHdf5::finish(const nlohmann::ordered_json&) {}

#endif

StudyHdf5::~StudyHdf5() = default;

}  // namespace mdana
