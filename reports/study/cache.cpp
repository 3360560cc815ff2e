// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/cache.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "readers/input_record.hpp"
#include "reports/atomic_file.hpp"
#include "reports/document.hpp"
#include "reports/study/cached_pictures.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view title = "mdana-run 2 ";
constexpr const char* ending = ".run";

/// JSON has no infinities; null is NaN.
Json exact(double value) {
  if (std::isfinite(value)) return value;
  if (std::isnan(value)) return nullptr;
  return value > 0 ? "inf" : "-inf";
}

double exact_double(const Json& json) {
  if (json.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (!json.is_string()) return json.get<double>();
  return json.get<std::string>() == "inf" ? std::numeric_limits<double>::infinity()
                                          : -std::numeric_limits<double>::infinity();
}

template <class Range>
Json exact_list(const Range& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(exact(value));
  return list;
}

std::vector<double> exact_doubles(const Json& json) {
  std::vector<double> values;
  values.reserve(json.size());
  for (const Json& value : json) values.push_back(exact_double(value));
  return values;
}

Json dimension_json(Dimension d) { return {d.mass, d.length, d.time}; }

Dimension dimension_of(const Json& json) {
  Dimension d;
  d.mass = json.at(0);
  d.length = json.at(1);
  d.time = json.at(2);
  return d;
}

Json table_json(const NamedTable& named) {
  Json columns = Json::array();
  for (std::size_t k = 0; k < named.table.columns().size(); ++k) {
    const ColumnSpec& spec = named.table.columns()[k];
    columns.push_back({{"name", spec.name}, {"dimension", dimension_json(spec.dimension)}, {"labels", spec.labels},
                       {"values", exact_list(named.table.column(k))}});
  }
  return {{"name", named.name}, {"columns", std::move(columns)}};
}

NamedTable table_of(const Json& json) {
  NamedTable named{json.at("name"), {}};
  for (const Json& column : json.at("columns"))
    named.table.add_column({column.at("name"), dimension_of(column.at("dimension")), column.at("labels")},
                           exact_doubles(column.at("values")));
  return named;
}

Json figure_json(const Figure& f) {
  Json series = Json::array();
  for (const Series& s : f.series)
    series.push_back({{"label", s.label}, {"style", static_cast<int>(s.style)}, {"x", exact_list(s.x)},
                      {"y", exact_list(s.y)}, {"y_error", exact_list(s.y_error)}});
  return {{"name", f.name}, {"title", f.title}, {"x_label", f.x_label}, {"y_label", f.y_label}, {"alt", f.alt},
          {"log_x", f.log_x}, {"log_y", f.log_y}, {"x_name", f.x_name}, {"y_name", f.y_name}, {"series", std::move(series)}};
}

Figure figure_of(const Json& json) {
  Figure f{json.at("name"), json.at("title"), json.at("x_label"), json.at("y_label"), json.at("alt"), {},
           json.at("log_x"), json.at("log_y"), json.at("x_name"), json.at("y_name")};
  for (const Json& s : json.at("series"))
    f.series.push_back({s.at("label"), exact_doubles(s.at("x")), exact_doubles(s.at("y")),
                        static_cast<Series::Style>(s.at("style").get<int>()), exact_doubles(s.at("y_error"))});
  return f;
}

Json number_json(const PublishedValue& n) {
  return {{"name", n.name}, {"value", exact(n.value.value)},
          {"error", n.value.error ? Json::array({exact(*n.value.error)}) : Json::array()},
          {"dimension", dimension_json(n.value.dimension)}};
}

PublishedValue number_of(const Json& json) {
  PublishedValue n{json.at("name"), {exact_double(json.at("value")), {}, dimension_of(json.at("dimension"))}};
  if (!json.at("error").empty()) n.value.error = exact_double(json.at("error").at(0));
  return n;
}

Json record_json(const RunRecord& record) {
  Json json{{"document", record.document}, {"numbers", Json::array()}, {"parts", Json::array()},
            {"tables", Json::array()}, {"figures", Json::array()}, {"snapshots", Json::array()}, {"views", Json::array()}};
  for (const PublishedValue& n : record.numbers) json["numbers"].push_back(number_json(n));
  for (const PublishedValue& n : record.parts) json["parts"].push_back(number_json(n));
  for (const NamedTable& t : record.tables) json["tables"].push_back(table_json(t));
  for (const Figure& f : record.figures) json["figures"].push_back(figure_json(f));
  for (const Snapshot& s : record.snapshots) json["snapshots"].push_back(cached(s));
  for (const ViewedFrame& v : record.views) json["views"].push_back(cached(v));
  return json;
}

RunRecord record_of(const Json& json) {
  RunRecord record;
  record.document = json.at("document");
  for (const Json& n : json.at("numbers")) record.numbers.push_back(number_of(n));
  for (const Json& n : json.at("parts")) record.parts.push_back(number_of(n));
  for (const Json& t : json.at("tables")) record.tables.push_back(table_of(t));
  for (const Json& f : json.at("figures")) record.figures.push_back(figure_of(f));
  for (const Json& s : json.at("snapshots")) record.snapshots.push_back(cached_snapshot(s));
  for (const Json& v : json.at("views")) record.views.push_back(cached_view(v));
  return record;
}

/// On one line; bytes that are not UTF-8 are replaced as in every document.
std::string line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

/// The lines below the title, if the checksum in the title is theirs.
std::optional<std::string> body_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string first;
  if (!std::getline(stream, first) || !first.starts_with(title)) return std::nullopt;
  std::ostringstream rest;
  rest << stream.rdbuf();
  std::string body = std::move(rest).str();
  if (content_hash(body) != std::string_view(first).substr(title.size())) return std::nullopt;
  return body;
}

std::string with_checksum(const std::string& body) { return fmt::format("{}{}\n{}", title, content_hash(body), body); }

std::optional<Json> key_in(const fs::path& file) {
  const auto body = body_of(file);
  if (!body) return std::nullopt;
  return Json::parse(body->substr(0, body->find('\n')));
}

fs::path failure_file(const fs::path& directory, const std::string& name) { return directory / (name + ".failed"); }

/// What such a file says, if it is of that key.
std::optional<std::string> failure_in(const fs::path& file, const Json& key) {
  std::ifstream stream(file);
  const Json json = Json::parse(stream, nullptr, false);
  if (!json.is_object() || !json.contains("key") || json["key"] != key) return std::nullopt;
  return json.value("reason", "failed");
}

}  // namespace

const Table* RunRecord::table(std::string_view name) const {
  const auto at = std::ranges::find(tables, name, &NamedTable::name);
  return at == tables.end() ? nullptr : &at->table;
}

const Value* RunRecord::number(std::string_view name) const {
  const auto at = std::ranges::find(numbers, name, &PublishedValue::name);
  return at == numbers.end() ? nullptr : &at->value;
}

RunCache::RunCache(fs::path directory, const std::vector<fs::path>& others) : directory_(std::move(directory)) {
  std::error_code ignored;  // a directory that is not there has nothing
  for (const fs::path& other : others)
    for (const auto& entry : fs::directory_iterator(other, ignored)) others_.emplace(entry.path().filename().string(), entry.path());
}

fs::path RunCache::file(const std::string& name) const {
  const auto at = adopted_.find(name + ending);
  return at == adopted_.end() ? directory_ / (name + ending) : at->second;
}

std::optional<Json> RunCache::key(const std::string& name) const { return key_in(file(name)); }

RunRecord RunCache::load(const std::string& name) const {
  const auto body = body_of(file(name));
  if (!body) throw InputError(fmt::format("{}: not a whole result of a run; remove it and run the report again", file(name).string()));
  return record_of(Json::parse(std::string_view(*body).substr(body->find('\n') + 1)));
}

void RunCache::store(const std::string& name, const Json& key, const RunRecord& record) const {
  write_file(directory_ / (name + ending), with_checksum(line(key) + line(record_json(record))));
  std::error_code ignored;
  fs::remove(failure_file(directory_, name), ignored);
}

void RunCache::adopt(const std::string& name, const Json& key) {
  if (others_.empty() || this->key(name) == key) return;
  const auto [first, last] = others_.equal_range(name + ending);
  const auto at = std::find_if(first, last, [&](const auto& other) { return key_in(other.second) == key; });
  if (at != last) adopted_[at->first] = at->second;
}

void RunCache::gather() {
  for (const auto& [name, place] : adopted_)
    if (const auto body = body_of(place)) write_file(directory_ / name, with_checksum(*body));
  adopted_.clear();
}

void RunCache::store_failure(const std::string& name, const Json& key, const std::string& reason) const {
  write_file(failure_file(directory_, name), to_text(Json{{"key", key}, {"reason", reason}}));
}

std::optional<std::string> RunCache::failure(const std::string& name, const Json& key) const {
  if (const auto own = failure_in(failure_file(directory_, name), key)) return own;
  const auto [first, last] = others_.equal_range(failure_file({}, name).string());
  for (auto at = first; at != last; ++at)
    if (const auto other = failure_in(at->second, key)) return other;
  return std::nullopt;
}

void RunCache::keep_only(const std::vector<std::string>& names) const {
  for (const auto& entry : fs::directory_iterator(directory_))
    if (const fs::path& path = entry.path(); path.filename().string().starts_with('.') ||  // left by one that was killed
        ((path.extension() == ending || path.extension() == ".failed") && std::ranges::find(names, path.stem().string()) == names.end()))
      fs::remove(path);
}

}  // namespace mdana
