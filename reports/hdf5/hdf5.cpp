// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/hdf5.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/atomic_file.hpp"
#include "reports/sink.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
void put(hdf5::Dataset dataset, std::span<const T> values) {
  if (!values.empty()) dataset.write({{0}, {values.size()}}, values);
}

template <class T>
void put_number(hdf5::Group& group, const std::string& name, hdf5::Kind kind, T value) {
  group.make_dataset(name, {kind, {}}).write({}, std::span<const T>(&value, 1));
}

bool all_numbers(const Json& json) {
  return json.is_array() && !json.empty() &&
         std::ranges::all_of(json, [](const Json& entry) { return entry.is_number(); });
}

bool has_numbers(const Json& json) {
  if (json.is_object()) return std::ranges::any_of(json, has_numbers);
  return json.is_number() || all_numbers(json);
}

/// Numbers by their names, objects as groups; what an object with a value does not know is NaN.
void put_numbers(hdf5::Group& group, const Json& object) {
  for (const auto& [name, json] : object.items()) {
    if (name.empty() || name == "." || name.find('/') != name.npos) continue;
    if (json.is_object() && has_numbers(json)) {
      hdf5::Group inner = group.make_group(name, true);
      put_numbers(inner, json);
    } else if (json.is_number_integer()) {
      put_number(group, name, hdf5::Kind::integer, json.get<std::int64_t>());
    } else if (json.is_number()) {
      put_number(group, name, hdf5::Kind::real, json.get<double>());
    } else if (json.is_null() && object.contains("value")) {
      put_number(group, name, hdf5::Kind::real, std::numeric_limits<double>::quiet_NaN());
    } else if (all_numbers(json)) {
      const auto values = json.get<std::vector<double>>();
      put(group.make_dataset(name, {hdf5::Kind::real, {values.size()}}),
          std::span<const double>(values));
    }
  }
}

/// The labels of a column whose values are indices into them.
hdf5::Dataset put_labels(hdf5::Group& group, const ColumnSpec& spec, std::span<const double> values) {
  std::vector<std::string> labels;
  for (const double value : values)
    labels.push_back(spec.labels.at(static_cast<std::size_t>(value)));
  std::size_t width = 1;
  for (const std::string& label : spec.labels) width = std::max(width, label.size());
  hdf5::Dataset dataset =
      group.make_dataset(spec.name, {hdf5::Kind::text, {labels.size()}, {}, width});
  if (!labels.empty())
    dataset.write({{0}, {labels.size()}}, std::span<const std::string>(labels));
  return dataset;
}

void put_table(hdf5::Group& file, const Table& table, Units units) {
  hdf5::Group group = file.make_group("table", true);
  for (std::size_t k = 0; k < table.columns().size(); ++k) {
    const ColumnSpec& spec = table.columns()[k];
    const std::span<const double> values = table.column(k);
    if (!spec.labels.empty()) {
      put_labels(group, spec, values);
      continue;
    }
    hdf5::Dataset dataset = group.make_dataset(spec.name, {hdf5::Kind::real, {values.size()}});
    if (!values.empty()) dataset.write({{0}, {values.size()}}, values);
    dataset.set_text("unit", symbol(units, spec.dimension));
    const Dimension d = spec.dimension;
    dataset.set_integers("dimension", std::vector<std::int64_t>{d.mass, d.length, d.time});
  }
}

void write(const std::filesystem::path& path, const Document& document, const Table* table) {
  write_file_by(path, [&](const std::filesystem::path& temporary) {
    hdf5::Group file = hdf5::create_file(temporary);
    const std::string text = document.to_json();
    file.make_dataset("document", {hdf5::Kind::text, {}, {}, text.size()})
        .write({}, std::span<const std::string>(&text, 1));
    hdf5::Group results = file.make_group("results", true);
    put_numbers(results, document.content());
    if (table) put_table(file, *table, document.units());
    hdf5::flush(file);
  });
}

}  // namespace

extern const Sink hdf5_sink;
const Sink hdf5_sink{"hdf5", ".h5", "all of it", false, write};

}  // namespace mdana
