// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/vtp.hpp"

#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/atomic_file.hpp"

namespace mdana {
namespace {

using Cells = std::vector<std::vector<std::uint32_t>>;

template <class Values>
std::string array(std::string_view type, std::string_view name, const Values& values, int components = 1) {
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n{}\n</DataArray>\n",
                     type, name, components, fmt::join(values, " "));
}

std::string connectivity(std::string_view tag, const Cells& cells) {
  std::vector<std::uint32_t> corners, ends;
  for (const auto& cell : cells) {
    corners.insert(corners.end(), cell.begin(), cell.end());
    ends.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return fmt::format("<{}>\n{}{}</{}>\n", tag, array("Int64", "connectivity", corners), array("Int64", "offsets", ends), tag);
}

std::string content(const PolyData& data) {
  std::vector<double> coordinates;
  for (const Eigen::Vector3d& p : data.points) coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n";
  text += fmt::format("<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}"
                      "</DataArray>\n</FieldData>\n", data.time);
  text += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
                      "NumberOfPolys=\"{}\">\n<Points>\n{}</Points>\n", data.points.size(), data.lines.size(),
                      data.polygons.size(), array("Float64", "Points", coordinates, 3));
  text += connectivity("Lines", data.lines) + connectivity("Polys", data.polygons) + "<CellData>\n";
  for (const PolyData::CellData& cell : data.cells) text += array("Float64", cell.name, cell.values);
  return text + "</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const PolyData& data) { write_file(path, content(data)); }

}  // namespace mdana
