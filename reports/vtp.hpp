// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mdana {

/// Polygons or polylines with numbers on each, as VTK's XML PolyData (.vtp) for ParaView.
struct PolyData {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::uint32_t>> polygons, lines;  ///< indices of points
  struct CellData {
    std::string name;
    std::vector<double> values;  ///< one a line, then one a polygon, as VTK orders cells
  };
  std::vector<CellData> cells;
  double time = 0;  ///< TimeValue of the data set
};

/// Writes it whole or not at all.
void write_vtp(const std::filesystem::path& path, const PolyData& data);

}  // namespace mdana
