// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/line_history.hpp"

#include <array>
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
  for (const char* column : {"bx", "by", "bz", "bx_here", "by_here", "bz_here", "in_twin", "character_degrees",
                             "character_spread_degrees", "plane_h", "plane_k", "plane_l"})
    all.push_back({column, dimension::none});
  for (const char* column : {"length", "length_error", "x", "y", "z"}) all.push_back({column, dimension::length});
  for (const char* column : {"from", "to"}) all.push_back({column, dimension::none, names<LineEnd>(6)});
  for (const char* column : {"from_node", "to_node"}) all.push_back({column, dimension::none});
  return all;
}

/// In the order of the columns; the place is that of the middle.
std::vector<double> segment_row(std::int64_t step, std::uint32_t track, const DislocationSegment& s) {
  std::vector<double> row;
  const auto put = [&row](auto... values) { (row.push_back(static_cast<double>(values)), ...); };
  const auto put_vector = [&put](const auto& v) { put(v.x(), v.y(), v.z()); };
  constexpr double degree = std::numbers::pi / 180;
  put(step, track, s.body, s.family);
  put_vector(s.burgers);
  put_vector(s.burgers_here);
  put(s.in_twin, s.character / degree, s.character_spread / degree);
  put_vector(s.slip_plane.value_or(Eigen::Vector3i::Zero()));
  put(s.length.value, *s.length.error);
  put_vector(s.points[s.points.size() / 2]);
  put(s.ends[0], s.ends[1], s.nodes[0], s.nodes[1]);
  return row;
}

}  // namespace

LineHistory::LineHistory()
    : segments_(segment_columns()),
      points_({{"segment", dimension::none}, {"x", dimension::length}, {"y", dimension::length}, {"z", dimension::length}}) {}

void LineHistory::add(const FrameDefects& found) {
  const std::vector<std::uint32_t> tracks =
      tracks_.add({found.lines, found.lattice, found.centre, found.volume, found.spacing});
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    if (keeps_points_) add_points(found.lines.segments[k]);
    segments_.add_row(segment_row(found.step, tracks[k], found.lines.segments[k]));
  }
  frames_.push_back(lines_json(found.lines, tracks, found.spacing));
}

/// Of the segment that comes next.
void LineHistory::add_points(const DislocationSegment& segment) {
  const auto row = static_cast<double>(segments_.rows());
  for (const Eigen::Vector3d& p : segment.points) points_.add_row(std::array{row, p.x(), p.y(), p.z()});
}

}  // namespace mdana
