// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/defect_pictures.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace mdana {
namespace {

constexpr int corners = 32;  ///< of the polygon that stands for a disc

/// Around the centre, of the plane's area.
void add_disc(PolyData& data, const FaultPlane& plane) {
  // Area of a regular polygon: corners/2 r^2 sin(2 pi/corners).
  const double radius = std::sqrt(2 * plane.area / (corners * std::sin(2 * std::numbers::pi / corners)));
  const Eigen::Vector3d first = plane.normal.unitOrthogonal(), second = plane.normal.cross(first);
  std::vector<std::uint32_t> polygon;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    polygon.push_back(static_cast<std::uint32_t>(data.points.size()));
    data.points.push_back(plane.centre + radius * (std::cos(angle) * first + std::sin(angle) * second));
  }
  data.polygons.push_back(std::move(polygon));
}

}  // namespace

PolyData surface_picture(const BodySurfaces& surfaces) {
  PolyData data;
  data.cells = {{"body", {}}, {"void", {}}};
  for (std::size_t body = 0; body < surfaces.body.size(); ++body) {
    const SurfaceMesh& mesh = surfaces.body[body];
    const auto first = static_cast<std::uint32_t>(data.points.size());
    data.points.insert(data.points.end(), mesh.points.begin(), mesh.points.end());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      data.polygons.push_back({first + a, first + b, first + c});
      data.cells[0].values.push_back(static_cast<double>(body + 1));
      data.cells[1].values.push_back(mesh.parts[mesh.part[t]].volume < 0 ? 1 : 0);
    }
  }
  return data;
}

PolyData fault_picture(const std::vector<FaultPlane>& planes) {
  PolyData data;
  data.cells = {{"kind", {}}, {"body", {}}, {"area", {}}, {"atoms", {}}};
  for (const FaultPlane& plane : planes) {
    add_disc(data, plane);
    data.cells[0].values.push_back(static_cast<double>(plane.kind));
    data.cells[1].values.push_back(plane.body);
    data.cells[2].values.push_back(plane.area);
    data.cells[3].values.push_back(static_cast<double>(plane.atoms));
  }
  return data;
}

PolyData line_picture(const DislocationLines& lines) {
  PolyData data;
  data.cells = {{"body", {}}, {"family", {}}, {"length", {}}, {"character", {}},
                {"burgers_x", {}}, {"burgers_y", {}}, {"burgers_z", {}}};
  for (const DislocationSegment& s : lines.segments) {
    std::vector<std::uint32_t> line;
    for (const auto& p : s.points) {
      line.push_back(static_cast<std::uint32_t>(data.points.size()));
      data.points.push_back(p);
    }
    data.lines.push_back(std::move(line));
    const Eigen::Vector3d b = s.crystal * s.burgers_here;
    std::size_t next = 0;
    for (const double value : {static_cast<double>(s.body), static_cast<double>(s.family), s.length.value,
                               s.character * 180 / std::numbers::pi, b.x(), b.y(), b.z()})
      data.cells[next++].values.push_back(value);
  }
  return data;
}

}  // namespace mdana
