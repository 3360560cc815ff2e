// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/reported.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "reports/collision_summary.hpp"
#include "reports/study/provenance.hpp"

namespace mdana {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double same_velocity = 0.01;  ///< relative: runs of one velocity
constexpr double z_95 = 1.959963984540054;

using Runs = std::span<const ReportedRun* const>;

/// A column of labels in the order in which they come first.
template <class Label>
void add_labels(Table& table, const std::string& name, Runs runs, Label&& label) {
  std::vector<std::string> words;
  for (const ReportedRun* run : runs) words.push_back(label(*run));
  if (!words.empty()) table.add_words(name, words);
}

template <class Number>
void add_number(Table& table, const std::string& name, Dimension dimension, Runs runs, Number&& number) {
  std::vector<double> values;
  for (const ReportedRun* run : runs) values.push_back(number(*run));
  table.add_column({name, dimension}, std::move(values));
}

double mean_radius(const ReportedRun& run) {
  if (const Value* r = run.number("R_agg")) return r->value;
  const Value *a = run.number("radius.body1"), *b = run.number("radius.body2");
  if (a && b) return (a->value + b->value) / 2;
  return run.scene.radii.size() == 2 ? (run.scene.radii[0] + run.scene.radii[1]) / 2 : unknown;
}

double orientation(const ReportedRun& run, std::size_t body, std::size_t k) {
  return body < run.scene.orientations.size() ? run.scene.orientations[body][k] : unknown;
}

std::string state(const ReportedRun& run) { return run.left_out ? "not run" : run.measured() ? "measured" : "failed"; }

void add_scene(Table& table, Runs runs) {
  add_labels(table, "run", runs, [](const ReportedRun& r) { return r.name; });
  add_labels(table, "group", runs, [](const ReportedRun& r) { return r.group; });
  add_labels(table, "interaction", runs, [](const ReportedRun& r) { return std::string(name(r.scene.interaction)); });
  add_labels(table, "state", runs, state);
  add_labels(table, "outcome", runs, [](const ReportedRun& r) { return r.text("outcome"); });
  add_number(table, "radius", dimension::length, runs, mean_radius);
  add_number(table, "velocity", dimension::velocity, runs, [](const ReportedRun& r) { return r.velocity(); });
  add_number(table, "seed", {}, runs, [](const ReportedRun& r) { return r.scene.seed.value_or(unknown); });
  for (const std::size_t body : {0, 1})
    for (const std::size_t k : {0, 1, 2, 3})
      add_number(table, fmt::format("orientation_{}{}", "wxyz"[k], body + 1), {}, runs,
                 [&](const ReportedRun& r) { return orientation(r, body, k); });
}

/// The first file that a run was made from.
std::string origin(const ReportedRun& run, const char* what) {
  const auto inputs = run.document.find("inputs");
  return inputs == run.document.end() || inputs->empty() ? std::string() : (*inputs)[0].value(what, "");
}

/// What a row was made from, and by what.
void add_origin(Table& table, Runs runs) {
  add_labels(table, "dump", runs, [](const ReportedRun& r) { return origin(r, "path"); });
  add_labels(table, "dump_hash", runs, [](const ReportedRun& r) { return origin(r, "hash"); });
  add_labels(table, "program", runs, [](const ReportedRun& r) { return r.measured() ? program_identity() : std::string(); });
}

/// Names of all numbers with their dimensions, in the order in which they come first.
std::vector<PublishedValue> names_of(Runs runs) {
  std::vector<PublishedValue> all;
  for (const ReportedRun* run : runs)
    for (const PublishedValue& n : run->numbers)
      if (std::ranges::find(all, n.name, &PublishedValue::name) == all.end()) all.push_back(n);
  return all;
}

/// Runs of one group and one velocity.
std::vector<std::vector<const ReportedRun*>> by_velocity(Runs runs) {
  std::map<std::string, std::vector<const ReportedRun*>> groups;
  for (const ReportedRun* run : runs) {
    const std::string outcome = run->text("outcome");
    if (!run->aggregate() && run->measured() && (outcome == "bounce" || outcome == "stick") && run->velocity() > 0)
      groups[run->group].push_back(run);
  }
  std::vector<std::vector<const ReportedRun*>> all;
  for (auto& [group, members] : groups) {
    std::ranges::stable_sort(members, {}, &ReportedRun::velocity);
    for (const ReportedRun* run : members) {
      const bool same = !all.empty() && all.back().front()->group == group &&
                        run->velocity() <= (1 + same_velocity) * all.back().front()->velocity();
      if (!same) all.emplace_back();
      all.back().push_back(run);
    }
  }
  return all;
}

std::array<double, 11> velocity_row(const std::vector<const ReportedRun*>& runs) {
  std::vector<double> e;
  std::size_t stuck = 0;
  double velocity = 0;
  for (const ReportedRun* run : runs) {
    const bool sticks = run->text("outcome") == "stick";
    const Value* number = run->number("e");
    stuck += sticks;
    velocity += run->velocity() / static_cast<double>(runs.size());
    if (sticks)
      e.push_back(0);
    else if (number && !std::isnan(number->value))
      e.push_back(number->value);
  }
  const RootMeanSquare rms = root_mean_square(e);
  const BinomialShare share = wilson(stuck, runs.size());
  const auto n = static_cast<double>(runs.size()), s = static_cast<double>(stuck);
  return {velocity, n, n - s, s, rms.value.value, rms.value.error.value_or(unknown), rms.spread,
          share.value, 0.5 * (share.high - share.low) / z_95, share.low, share.high};
}

}  // namespace

const Value* ReportedRun::number(std::string_view wanted) const {
  const auto at = std::ranges::find(numbers, wanted, &PublishedValue::name);
  return at == numbers.end() ? nullptr : &at->value;
}

bool ReportedRun::weak(std::string_view wanted) const {
  const auto rows = document.find("stability");
  return rows != document.end() && std::ranges::any_of(*rows, [&](const auto& r) {
           return r["quantity"] == wanted && r.value("weak", false);
         });
}

std::string ReportedRun::text(const char* wanted) const {
  const auto at = document.find(wanted);
  return at != document.end() && at->is_string() ? at->get<std::string>() : std::string();
}

Units ReportedRun::units() const { return parse_units(text("units")).value_or(Units::lj); }

double ReportedRun::velocity() const {
  if (scene.impact_velocity) return *scene.impact_velocity;
  const Value* speed = number("speed_before");
  return speed ? speed->value : unknown;
}

Table runs_table(Runs runs) {
  Table table;
  add_scene(table, runs);
  for (const PublishedValue& n : names_of(runs)) {
    add_number(table, n.name, n.value.dimension, runs, [&](const ReportedRun& r) {
      const Value* value = r.number(n.name);
      return value ? value->value : unknown;
    });
    add_number(table, n.name + "_error", n.value.dimension, runs, [&](const ReportedRun& r) {
      const Value* value = r.number(n.name);
      return value ? value->error.value_or(unknown) : unknown;
    });
  }
  add_labels(table, "weak", runs, [](const ReportedRun& r) {
    std::string names;  // of numbers of which the dump fixes fewer than three digits
    for (const PublishedValue& n : r.numbers)
      if (r.weak(n.name)) names += (names.empty() ? "" : " ") + n.name;
    return names;
  });
  add_origin(table, runs);
  return table;
}

Table velocities_table(Runs runs) {
  const auto cells = by_velocity(runs);
  std::vector<const ReportedRun*> first;
  for (const auto& cell : cells) first.push_back(cell.front());
  Table table;
  add_labels(table, "group", first, [](const ReportedRun& r) { return r.group; });
  const ColumnSpec specs[] = {{"velocity", dimension::velocity}, {"runs", {}}, {"bounce", {}}, {"stick", {}}, {"e_rms", {}},
                              {"e_rms_error", {}}, {"e_spread", {}}, {"sticking", {}}, {"sticking_error", {}},
                              {"sticking_low", {}}, {"sticking_high", {}}};
  for (std::size_t k = 0; k < std::size(specs); ++k) {
    std::vector<double> column;
    for (const auto& cell : cells) column.push_back(velocity_row(cell)[k]);
    table.add_column(specs[k], std::move(column));
  }
  return table;
}

Table rows_with(const Table& table, const std::string& column, const std::string& label) {
  const auto spec = std::ranges::find(table.columns(), column, &ColumnSpec::name);
  Table kept(table.columns());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (spec->labels.at(static_cast<std::size_t>(table.column(column)[i])) != label) continue;
    std::vector<double> row;
    for (std::size_t k = 0; k < table.columns().size(); ++k) row.push_back(table.column(k)[i]);
    kept.add_row(row);
  }
  return kept;
}

}  // namespace mdana
