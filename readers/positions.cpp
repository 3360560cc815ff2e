// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/positions.hpp"

#include <algorithm>

namespace mdana {
namespace {

bool has(const std::vector<std::string>& columns, std::string_view name) {
  return std::find(columns.begin(), columns.end(), name) != columns.end();
}

bool has_all(const std::vector<std::string>& columns, const std::array<std::string, 3>& names) {
  return std::all_of(names.begin(), names.end(), [&](const auto& n) { return has(columns, n); });
}

/// position = matrix * raw + origin, atom by atom.
void transform(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& origin,
               const std::array<std::span<const double>, 3>& raw,
               const std::array<std::span<double>, 3>& position) {
  for (std::size_t i = 0; i < raw[0].size(); ++i) {
    const Eigen::Vector3d p = matrix * Eigen::Vector3d(raw[0][i], raw[1][i], raw[2][i]) + origin;
    for (int k = 0; k < 3; ++k) position[k][i] = p[k];
  }
}

void add_images(const Eigen::Matrix3d& edges, const AtomBlock& block,
                const std::array<std::span<double>, 3>& position) {
  const auto ix = block.integer("ix"), iy = block.integer("iy"), iz = block.integer("iz");
  for (std::size_t i = 0; i < ix.size(); ++i) {
    const Eigen::Vector3d shift =
        edges * Eigen::Vector3d(static_cast<double>(ix[i]), static_cast<double>(iy[i]),
                                static_cast<double>(iz[i]));
    for (int k = 0; k < 3; ++k) position[k][i] += shift[k];
  }
}

}  // namespace

std::optional<PositionSource> position_source(const std::vector<std::string>& columns) {
  const bool images = has_all(columns, {"ix", "iy", "iz"});
  const PositionSource candidates[] = {
      {{"xu", "yu", "zu"}, false, true, false},
      {{"xsu", "ysu", "zsu"}, true, true, false},
      {{"x", "y", "z"}, false, false, images},
      {{"xs", "ys", "zs"}, true, false, images},
  };
  for (const PositionSource& candidate : candidates)
    if (has_all(columns, candidate.columns)) return candidate;
  return std::nullopt;
}

void make_positions(const PositionSource& source, const Box& box, AtomBlock& block) {
  const std::array<std::span<double>, 3> position{block.make_real("x"), block.make_real("y"),
                                                  block.make_real("z")};
  if (source.columns[0] != "x") {
    const std::array<std::span<const double>, 3> raw{block.real(source.columns[0]),
                                                     block.real(source.columns[1]),
                                                     block.real(source.columns[2])};
    if (source.scaled)
      transform(box.edges, box.origin, raw, position);
    else
      for (int k = 0; k < 3; ++k) std::copy(raw[k].begin(), raw[k].end(), position[k].begin());
  }
  if (source.image_flags) add_images(box.edges, block, position);
}

}  // namespace mdana
