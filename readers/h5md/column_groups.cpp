// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/h5md/column_groups.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::h5md {
namespace {

using Names = std::vector<std::string>;

constexpr std::array<std::string_view, 9> reserved{"position", "image", "velocity", "force", "species",
                                                   "charge",   "box",   "step",     "time"};

bool has_all(const FrameHeader& frame, const Names& names) {
  return std::ranges::all_of(names, [&](const auto& name) { return frame.has_column(name); });
}

Names positions(const FrameHeader& frame) {
  for (const Names& names : {Names{"x", "y", "z"}, Names{"xu", "yu", "zu"}})
    if (has_all(frame, names)) return names;
  if (frame.has_column("xs") || frame.has_column("xsu"))
    throw InputError(fmt::format("{}: H5MD has no scaled positions: write x y z (what mdana makes of "
                                 "xs ys zs) or xu yu zu",
                                 frame.place));
  throw InputError(fmt::format("{}: no positions: x y z or xu yu zu must be among the columns",
                               frame.place));
}

std::string element_of(const std::string& column) {
  if (column == "type") return "species";
  if (column == "q") return "charge";
  return column;
}

void check_name(const FrameHeader& frame, const std::string& column) {
  if (column.empty() || column == "." || column.find('/') != column.npos ||
      column.find('\0') != column.npos || std::ranges::find(reserved, column) != reserved.end())
    throw InputError(fmt::format("{}: column '{}' cannot be an element of H5MD; rename it or leave it "
                                 "out",
                                 frame.place, column));
}

}  // namespace

std::vector<ColumnGroup> column_groups(const FrameHeader& frame) {
  const Names position = positions(frame);
  std::vector<ColumnGroup> groups{{"position", position, ColumnKind::real}};
  const auto add_vector = [&](const char* element, const Names& names, ColumnKind kind) {
    if (has_all(frame, names)) groups.push_back({element, names, kind});
  };
  // With unwrapped positions image flags are numbers that must not be added again.
  if (position.front() == "x") add_vector("image", {"ix", "iy", "iz"}, ColumnKind::integer);
  add_vector("velocity", {"vx", "vy", "vz"}, ColumnKind::real);
  add_vector("force", {"fx", "fy", "fz"}, ColumnKind::real);
  const std::size_t vectors = groups.size();
  for (const std::string& column : frame.columns) {
    const bool in_vector = std::any_of(groups.begin(), groups.begin() + static_cast<long>(vectors),
                                       [&](const ColumnGroup& group) {
                                         return std::ranges::find(group.columns, column) !=
                                                group.columns.end();
                                       });
    if (in_vector) continue;
    check_name(frame, column);
    groups.push_back({element_of(column), {column}, kind_of_column(column)});
  }
  return groups;
}

}  // namespace mdana::h5md
