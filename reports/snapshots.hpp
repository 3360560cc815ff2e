// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analyses/slice.hpp"
#include "analyses/table.hpp"
#include "readers/units.hpp"

namespace mdana {

/// A frame as a picture: a slice of it, atom by atom, or as squares that many atoms are in.
struct Snapshot {
  std::string label;       ///< "maximum compression"
  std::int64_t step = 0;
  double time = std::numeric_limits<double>::quiet_NaN();   ///< [time]; NaN if it is not known
  double delta = std::numeric_limits<double>::quiet_NaN();  ///< mutual approach [length]
  bool squares = false;
  double thickness = 0;    ///< of the slice [length]
  double size = 0;         ///< of an atom or a square [length]
  std::size_t atoms = 0;   ///< in the slice
  std::array<std::vector<Eigen::Vector2d>, 2> at;  ///< of body 1, 2: centres; as in Slice

  std::size_t count() const { return at[0].size() + at[1].size(); }
};

Snapshot snapshot_of(const Slice& slice);

/// Each square of the body that most of its atoms are of.
Snapshot with_squares(const Snapshot& snapshot, double size);

/// At most `most` atoms each; more become squares of one size, at least two diameters, in all.
void limit(std::vector<Snapshot>& snapshots, std::size_t most);

/// Squares side by side in a row, one strip each.
struct Strip {
  double from, to, height;  ///< across, along [length]
};
std::vector<Strip> strips(const std::vector<Eigen::Vector2d>& squares, double size);

/// "t = 12.5 τ, δ = −2 σ", as far as they are known.
std::string moment(const Snapshot& snapshot, Units units);

/// Snapshots of a run, side by side on one scale, the line of centres upwards.
struct SnapshotFigure {
  std::string name;   ///< of its files, without suffix
  std::string title;
  std::string of;     ///< "atom", "grain"
  Units units = Units::lj;
  std::vector<Snapshot> snapshots;
};

/// What is drawn, and the frames with their steps, times and delta.
std::string caption(const SnapshotFigure& figure);

std::string snapshot_picture(const SnapshotFigure& figure);  ///< as SVG

/// The figure with squares as large as it takes for a picture of at most `bytes`.
SnapshotFigure within(SnapshotFigure figure, std::size_t bytes);

/// A row an atom or square: snapshot, step, body, x across the line of centres, y along it, and size.
Table snapshot_table(const SnapshotFigure& figure);

/// Writes NAME.svg, NAME.csv, NAME.gp and, if gnuplot is installed, NAME.pdf into the directory.
void draw(const SnapshotFigure& figure, const std::filesystem::path& directory);

}  // namespace mdana
