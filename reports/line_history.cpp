// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/line_history.hpp"

#include <numbers>

#include "reports/line_numbers.hpp"

namespace mdana {
namespace {

template <class Name>
std::vector<std::string> names(std::size_t count) {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < count; ++k) all.emplace_back(name(static_cast<Name>(k)));
  return all;
}

std::vector<ColumnSpec> segment_columns() {
  std::vector<ColumnSpec> all{{"step", dimension::none}, {"track", dimension::none}, {"body", dimension::none}};
  all.push_back({"family", dimension::none, names<LineFamily>(line_families)});
  for (const char* column : {"bx", "by", "bz", "in_twin", "character_degrees", "plane_h", "plane_k", "plane_l"})
    all.push_back({column, dimension::none});
  for (const char* column : {"length", "length_error", "x", "y", "z"}) all.push_back({column, dimension::length});
  for (const char* column : {"from", "to"}) all.push_back({column, dimension::none, names<LineEnd>(6)});
  return all;
}

/// In the order of the columns; the place is that of the middle.
std::vector<double> segment_row(std::int64_t step, std::uint32_t track, const DislocationSegment& s) {
  const Eigen::Vector3i plane = s.slip_plane.value_or(Eigen::Vector3i::Zero());
  const Eigen::Vector3d& middle = s.points[s.points.size() / 2];
  return {static_cast<double>(step), static_cast<double>(track), static_cast<double>(s.body),
          static_cast<double>(s.family), s.burgers.x(), s.burgers.y(), s.burgers.z(), static_cast<double>(s.in_twin),
          s.character * 180 / std::numbers::pi, static_cast<double>(plane.x()), static_cast<double>(plane.y()),
          static_cast<double>(plane.z()), s.length.value, *s.length.error, middle.x(), middle.y(), middle.z(),
          static_cast<double>(s.ends[0]), static_cast<double>(s.ends[1])};
}

}  // namespace

LineHistory::LineHistory() : segments_(segment_columns()) {}

void LineHistory::add(const FrameDefects& found) {
  const std::vector<std::uint32_t> tracks =
      tracks_.add({found.lines, found.lattice, found.centre, found.volume, found.spacing});
  for (std::size_t k = 0; k < tracks.size(); ++k)
    segments_.add_row(segment_row(found.step, tracks[k], found.lines.segments[k]));
  frames_.push_back(lines_json(found.lines, tracks, found.spacing));
}

}  // namespace mdana
