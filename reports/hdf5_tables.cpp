// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/hdf5_tables.hpp"

#include <algorithm>
#include <limits>

namespace mdana::hdf5 {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
void put(Dataset dataset, std::span<const T> values) {
  if (!values.empty()) dataset.write({{0}, {values.size()}}, values);
}

template <class T>
void put_number(Group& group, const std::string& name, Kind kind, T value) {
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

/// The labels of a column whose values are indices into them.
Dataset put_labels(Group& group, const ColumnSpec& spec, std::span<const double> values) {
  std::vector<std::string> labels;
  for (const double value : values)
    labels.push_back(spec.labels.at(static_cast<std::size_t>(value)));
  std::size_t width = 1;
  for (const std::string& label : spec.labels) width = std::max(width, label.size());
  Dataset dataset =
      group.make_dataset(spec.name, {Kind::text, {labels.size()}, {}, width});
  if (!labels.empty())
    dataset.write({{0}, {labels.size()}}, std::span<const std::string>(labels));
  return dataset;
}

}  // namespace

void put_numbers(Group& group, const Json& object) {
  for (const auto& [name, json] : object.items()) {
    if (name.empty() || name == "." || name.find('/') != name.npos) continue;
    if (json.is_object() && has_numbers(json)) {
      Group inner = group.make_group(name, true);
      put_numbers(inner, json);
    } else if (json.is_number_integer()) {
      put_number(group, name, Kind::integer, json.get<std::int64_t>());
    } else if (json.is_number()) {
      put_number(group, name, Kind::real, json.get<double>());
    } else if (json.is_null() && object.contains("value")) {
      put_number(group, name, Kind::real, std::numeric_limits<double>::quiet_NaN());
    } else if (all_numbers(json)) {
      const auto values = json.get<std::vector<double>>();
      put(group.make_dataset(name, {Kind::real, {values.size()}}),
          std::span<const double>(values));
    }
  }
}

void put_table(Group& group, const Table& table, Units units) {
  for (std::size_t k = 0; k < table.columns().size(); ++k) {
    const ColumnSpec& spec = table.columns()[k];
    const std::span<const double> values = table.column(k);
    if (!spec.labels.empty()) {
      put_labels(group, spec, values);
      continue;
    }
    Dataset dataset = group.make_dataset(spec.name, {Kind::real, {values.size()}});
    if (!values.empty()) dataset.write({{0}, {values.size()}}, values);
    dataset.set_text("unit", symbol(units, spec.dimension));
    const Dimension d = spec.dimension;
    dataset.set_integers("dimension", std::vector<std::int64_t>{d.mass, d.length, d.time});
  }
}

void put_text(Group& group, const std::string& name, const std::string& text) {
  group.make_dataset(name, {Kind::text, {}, {}, std::max<std::size_t>(1, text.size())})
      .write({}, std::span<const std::string>(&text, 1));
}

}  // namespace mdana::hdf5
