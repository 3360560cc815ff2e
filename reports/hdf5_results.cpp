// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/hdf5_results.hpp"

#include <fmt/format.h>

#include "readers/input_error.hpp"
#ifdef MDANA_WITH_HDF5
#include "readers/hdf5.hpp"
#endif

namespace mdana {

#ifdef MDANA_WITH_HDF5

namespace {

/// A column of a table; none if there is no such column.
std::vector<double> column(const hdf5::Group& table, const std::string& name) {
  if (!table.has_dataset(name)) return {};
  const hdf5::Dataset dataset = table.dataset(name);
  std::vector<double> values(dataset.shape().at(0));
  dataset.read({{0}, {values.size()}}, values);
  return values;
}

}  // namespace

bool holds_results(const std::filesystem::path& path) { return hdf5::open_file(path).has_dataset("document"); }

std::string hdf5_document(const std::filesystem::path& path) {
  const hdf5::Group file = hdf5::open_file(path);
  if (!file.has_dataset("document"))
    throw InputError(fmt::format("{}: no results of mdana: it has no dataset 'document'", path.string()));
  const std::vector<std::string> texts = file.dataset("document").read_texts({});
  return texts.empty() ? std::string() : texts.front();
}

std::vector<MotionSample> hdf5_motion(const std::filesystem::path& path) {
  const hdf5::Group file = hdf5::open_file(path);
  if (!file.has_group("table")) return {};
  const hdf5::Group table = file.group("table");
  const std::vector<double> times = column(table, "time"), delta = column(table, "delta");
  const std::vector<double> v = column(table, "v"), F = column(table, "F");
  std::vector<MotionSample> rows;
  for (std::size_t i = 0; i < std::min(times.size(), delta.size()); ++i) {
    rows.push_back({times[i], {delta[i], {}}, {}, {}});
    if (i < v.size()) rows.back().velocity.value = v[i];
    if (i < F.size()) rows.back().force.value = F[i];
  }
  return rows;
}

#else

bool holds_results(const std::filesystem::path&) { return false; }

std::string hdf5_document(const std::filesystem::path& path) {
  throw InputError(fmt::format("{}: this build does not read HDF5; give the JSON document instead", path.string()));
}

std::vector<MotionSample> hdf5_motion(const std::filesystem::path& path) { return hdf5_document(path), std::vector<MotionSample>(); }

#endif

}  // namespace mdana
