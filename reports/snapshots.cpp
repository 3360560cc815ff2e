// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/snapshots.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace mdana {
namespace {

constexpr double least_row = 1.25;  ///< diameters: layers of a lattice are at most one apart, so no row is empty
constexpr double room = 1.6;        ///< diameters between two atoms that end a strip
constexpr double growth = 1.25;
constexpr int most_heights = 60;  ///< a million times the first

std::vector<Strip> pieces(const Snapshot& snapshot, std::size_t body) {
  if (snapshot.row > 0) return snapshot.strips[body];
  std::vector<Strip> all;
  for (const Eigen::Vector3d& p : snapshot.at[body])
    all.push_back({p.x() - 0.5 * snapshot.diameter, p.x() + 0.5 * snapshot.diameter, p.y()});
  return all;
}

/// Pieces in rows of a height, from below, those that are near put together.
std::vector<Strip> in_rows(std::vector<Strip> all, double row, double gap) {
  for (Strip& s : all) s.height = (std::floor(s.height / row) + 0.5) * row;
  std::ranges::sort(all, {}, [](const Strip& s) { return std::pair(s.height, s.from); });
  std::vector<Strip> strips;
  for (const Strip& s : all)
    if (!strips.empty() && strips.back().height == s.height && s.from - strips.back().to <= gap)
      strips.back().to = std::max(strips.back().to, s.to);
    else
      strips.push_back(s);
  return strips;
}

std::size_t drawn(const Snapshot& s) {
  return s.row > 0 ? s.strips[0].size() + s.strips[1].size() : s.at[0].size() + s.at[1].size();
}

std::string number(double value) {
  std::string text = fmt::format("{:.4g}", value);
  return text.starts_with('-') ? "\u2212" + text.substr(1) : text;
}

}  // namespace

Snapshot with_rows(const Snapshot& snapshot, double row) {
  Snapshot rows = snapshot;
  rows.row = row;
  rows.at = {};
  for (const std::size_t body : {0, 1})
    rows.strips[body] = in_rows(pieces(snapshot, body), row, room * snapshot.diameter);
  return rows;
}

Snapshot snapshot_of(const Slice& slice) {
  Snapshot snapshot;
  snapshot.diameter = slice.diameter;
  snapshot.atoms = slice.size();
  snapshot.at = slice.at;
  return snapshot;
}

void limit(std::vector<Snapshot>& snapshots, std::size_t most) {
  const auto too_many = [&](const std::vector<Snapshot>& all) {
    return std::ranges::any_of(all, [&](const Snapshot& s) { return drawn(s) > most; });
  };
  if (!too_many(snapshots)) return;
  double row = 0;
  for (const Snapshot& s : snapshots) row = std::max(row, least_row * s.diameter);
  std::vector<Snapshot> rows = snapshots;
  for (int k = 0; k < most_heights; ++k, row *= growth) {
    std::ranges::transform(snapshots, rows.begin(), [&](const Snapshot& s) { return with_rows(s, row); });
    if (!too_many(rows)) break;
  }
  snapshots = std::move(rows);
}

std::string moment(const Snapshot& snapshot, Units units) {
  std::string text;
  if (std::isfinite(snapshot.time)) text = fmt::format("t = {} {}", number(snapshot.time), symbol(units, dimension::time));
  if (!std::isfinite(snapshot.delta)) return text;
  return fmt::format("{}{}δ = {} {}", text, text.empty() ? "" : ", ", number(snapshot.delta),
                     symbol(units, dimension::length));
}

std::string caption(const SnapshotFigure& figure) {
  if (figure.snapshots.empty()) return {};
  const Snapshot& first = figure.snapshots.front();
  const std::string length = symbol(figure.units, dimension::length);
  std::string text = fmt::format("Slice through both centres, one {} ({} {}) thick, the line of centres upwards, coloured by body. ",
                                 figure.of, number(first.diameter), length);
  if (first.row > 0)
    text += fmt::format("Rows of {} {} stand for the {} {}s in it. ", number(first.row), length, first.atoms, figure.of);
  char letter = 'a';
  for (const Snapshot& s : figure.snapshots) {
    const std::string when = moment(s, figure.units);
    text += fmt::format("{}({}) {}: step {}{}{}", letter == 'a' ? "" : "; ", letter, s.label, s.step, when.empty() ? "" : ", ", when);
    ++letter;
  }
  return text + ".";
}

Table snapshot_table(const SnapshotFigure& figure) {
  Table table;
  if (figure.snapshots.empty()) return table;
  const bool rows = figure.snapshots.front().row > 0;
  std::vector<std::string> labels;
  for (const Snapshot& s : figure.snapshots) labels.push_back(s.label);
  std::vector<ColumnSpec> columns{{"snapshot", dimension::none, std::move(labels)}, {"step", dimension::none}, {"body", dimension::none}};
  for (const char* name : rows ? std::array{"x_from", "x_to", "y", "height"} : std::array{"x", "y", "z", "diameter"})
    columns.push_back({name, dimension::length});
  table = Table(std::move(columns));
  for (std::size_t k = 0; k < figure.snapshots.size(); ++k)
    for (const std::size_t body : {0, 1}) {
      const Snapshot& s = figure.snapshots[k];
      const std::array head{static_cast<double>(k), static_cast<double>(s.step), static_cast<double>(body + 1)};
      for (const Eigen::Vector3d& p : s.at[body]) table.add_row(std::array{head[0], head[1], head[2], p.x(), p.y(), p.z(), s.diameter});
      for (const Strip& p : s.strips[body]) table.add_row(std::array{head[0], head[1], head[2], p.from, p.to, p.height, s.row});
    }
  return table;
}

SnapshotFigure within(SnapshotFigure figure, std::size_t bytes) {
  double row = 0;
  for (const Snapshot& s : figure.snapshots) row = std::max(row, s.row > 0 ? s.row * growth : least_row * s.diameter);
  for (int k = 0; k < most_heights && snapshot_picture(figure).size() > bytes; ++k, row *= growth)
    for (Snapshot& s : figure.snapshots) s = with_rows(s, row);
  return figure;
}

}  // namespace mdana
