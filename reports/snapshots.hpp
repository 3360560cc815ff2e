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

/// A piece of a row where atoms are.
struct Strip {
  double from, to, height;  ///< across, along [length]
  bool operator==(const Strip&) const = default;
};

/// A frame as a picture: a slice of it, atom by atom, or as rows of strips.
struct Snapshot {
  std::string label;       ///< "maximum compression"
  std::int64_t step = 0;
  double time = std::numeric_limits<double>::quiet_NaN();   ///< [time]; NaN if it is not known
  double delta = std::numeric_limits<double>::quiet_NaN();  ///< mutual approach [length]
  double diameter = 0;     ///< of an atom, and thickness of the slice [length]
  std::size_t atoms = 0;   ///< in the slice
  std::array<std::vector<Eigen::Vector3d>, 2> at;  ///< of body 1, 2, as in Slice; empty with rows
  double row = 0;          ///< height of a row [length]; 0: atom by atom
  std::array<std::vector<Strip>, 2> strips;        ///< of body 1, 2; by rows
};

Snapshot snapshot_of(const Slice& slice);

/// Rows of that height; a strip ends where two atoms have room between them.
Snapshot with_rows(const Snapshot& snapshot, double row);

/// Atom by atom if there are at most `most` atoms in each, else all as rows of one height, with at most as many strips.
void limit(std::vector<Snapshot>& snapshots, std::size_t most);

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

/// The figure with rows as high as it takes for a picture of at most `bytes`.
SnapshotFigure within(SnapshotFigure figure, std::size_t bytes);

/// A row an atom: snapshot, step, body, x across the line of centres, y along it, z above the plane, and its diameter. Or
/// a row a strip: x_from, x_to, y and its height.
Table snapshot_table(const SnapshotFigure& figure);

/// Writes NAME.svg, NAME.csv, NAME.gp and, if gnuplot is installed, NAME.pdf into the directory.
void draw(const SnapshotFigure& figure, const std::filesystem::path& directory);

}  // namespace mdana
