// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/snapshots.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace mdana {
namespace {

constexpr double least_square = 2;  ///< diameters: no square inside a solid is empty

constexpr double growth = 1.25;
constexpr int most_sizes = 60;         ///< a million times the first

using Square = std::pair<long, long>;  ///< row, column

/// Atoms of body 1 and 2 in each square, row by row.
std::map<Square, std::array<std::size_t, 2>> counted(const Snapshot& snapshot, double size) {
  std::map<Square, std::array<std::size_t, 2>> squares;
  for (std::size_t body = 0; body < 2; ++body)
    for (const Eigen::Vector2d& p : snapshot.at[body])
      ++squares[{std::lround(std::floor(p.y() / size)), std::lround(std::floor(p.x() / size))}][body];
  return squares;
}

std::string number(double value) {
  std::string text = fmt::format("{:.4g}", value);
  return text.starts_with('-') ? "\u2212" + text.substr(1) : text;
}

}  // namespace

Snapshot with_squares(const Snapshot& snapshot, double size) {
  Snapshot coarse = snapshot;
  coarse.squares = true;
  coarse.size = size;
  coarse.at = {};
  for (const auto& [square, atoms] : counted(snapshot, size))
    coarse.at[atoms[1] > atoms[0]].emplace_back((static_cast<double>(square.second) + 0.5) * size,
                                                (static_cast<double>(square.first) + 0.5) * size);
  return coarse;
}

Snapshot snapshot_of(const Slice& slice) {
  Snapshot snapshot;
  snapshot.thickness = snapshot.size = slice.diameter;
  snapshot.atoms = slice.size();
  snapshot.at = slice.at;
  return snapshot;
}

void limit(std::vector<Snapshot>& snapshots, std::size_t most) {
  const auto too_many = [&](const std::vector<Snapshot>& all) {
    return std::ranges::any_of(all, [&](const Snapshot& s) { return s.count() > most; });
  };
  if (!too_many(snapshots)) return;
  double size = 0;
  for (const Snapshot& s : snapshots) size = std::max(size, least_square * s.thickness);
  std::vector<Snapshot> coarse = snapshots;
  for (int k = 0; k < most_sizes; ++k, size *= growth) {
    std::ranges::transform(snapshots, coarse.begin(), [&](const Snapshot& s) { return with_squares(s, size); });
    if (!too_many(coarse)) break;
  }
  snapshots = std::move(coarse);
}

std::vector<Strip> strips(const std::vector<Eigen::Vector2d>& squares, double size) {
  std::vector<Strip> rows;
  for (const Eigen::Vector2d& p : squares) {
    const bool next = !rows.empty() && std::abs(rows.back().height - p.y()) < 0.5 * size &&
                      std::abs(rows.back().to - (p.x() - 0.5 * size)) < 0.5 * size;
    if (next)
      rows.back().to = p.x() + 0.5 * size;
    else
      rows.push_back({p.x() - 0.5 * size, p.x() + 0.5 * size, p.y()});
  }
  return rows;
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
                                 figure.of, number(first.thickness), length);
  if (first.squares)
    text += fmt::format("Squares of {} {} stand for the {} {}s in it, each for those of the body that has most there. ",
                        number(first.size), length, first.atoms, figure.of);
  char letter = 'a';
  for (const Snapshot& s : figure.snapshots) {
    const std::string when = moment(s, figure.units);
    text += fmt::format("{}({}) {}: step {}{}{}", letter == 'a' ? "" : "; ", letter, s.label, s.step, when.empty() ? "" : ", ", when);
    ++letter;
  }
  return text + ".";
}

Table snapshot_table(const SnapshotFigure& figure) {
  std::vector<std::string> labels;
  std::vector<double> snapshot, step, body, x, y, size;
  for (const Snapshot& s : figure.snapshots) {
    for (std::size_t b = 0; b < 2; ++b)
      for (const Eigen::Vector2d& p : s.at[b]) {
        snapshot.push_back(static_cast<double>(labels.size()));
        step.push_back(static_cast<double>(s.step));
        body.push_back(static_cast<double>(b + 1));
        x.push_back(p.x());
        y.push_back(p.y());
        size.push_back(s.size);
      }
    labels.push_back(s.label);
  }
  Table table;
  if (labels.empty()) return table;
  table.add_column({"snapshot", dimension::none, std::move(labels)}, std::move(snapshot));
  table.add_column({"step", dimension::none}, std::move(step));
  table.add_column({"body", dimension::none}, std::move(body));
  table.add_column({"x", dimension::length}, std::move(x));
  table.add_column({"y", dimension::length}, std::move(y));
  table.add_column({"size", dimension::length}, std::move(size));
  return table;
}

SnapshotFigure within(SnapshotFigure figure, std::size_t bytes) {
  double size = 0;
  for (const Snapshot& s : figure.snapshots) size = std::max(size, s.squares ? s.size : least_square / growth * s.size);
  for (int k = 0; k < most_sizes && snapshot_picture(figure).size() > bytes; ++k) {
    size *= growth;
    for (Snapshot& s : figure.snapshots) s = with_squares(s, size);
  }
  return figure;
}

}  // namespace mdana
