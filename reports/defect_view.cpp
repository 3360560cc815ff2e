// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/defect_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/defect_pictures.hpp"
#include "reports/page_script.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;
using Eigen::Vector3d;

struct Family {
  std::string_view name, shown, colour;
};
constexpr std::array<Family, 6> families{{{"perfect", "perfect dislocations", "#2f6bff"},
                                          {"shockley", "Shockley partials", "#1fa33a"},
                                          {"stair_rod", "stair-rod dislocations", "#e01fc0"},
                                          {"hirth", "Hirth dislocations", "#d8b800"},
                                          {"frank", "Frank partials", "#00b0c0"},
                                          {"other", "other dislocations", "#e02020"}}};

const char* colour(PlanarFault kind) {
  switch (kind) {
    case PlanarFault::intrinsic: return "#e8862e";
    case PlanarFault::extrinsic: return "#8a63d2";
    case PlanarFault::twin: return "#3c8fd9";
    case PlanarFault::none: break;
  }
  return "#8c97a1";
}

std::string shown_name(PlanarFault kind) {
  return std::string(name(kind)) + (kind == PlanarFault::twin ? " boundaries" : " faults");
}

/// Positions on a grid of 2^16 points along the longest side of their box.
Json packed(const std::vector<Vector3d>& points) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : points) box.extend(p);
  const Vector3d origin = points.empty() ? Vector3d::Zero() : Vector3d(box.center());
  const double extent = points.empty() ? 0 : box.sizes().maxCoeff();
  const double step = extent > 0 ? extent / 65534 : 1;
  std::string bytes;
  for (const Vector3d& p : points)
    for (int k = 0; k < 3; ++k) {
      const auto place = static_cast<std::uint16_t>(std::lround((p[k] - origin[k]) / step));
      bytes += {static_cast<char>(place & 255), static_cast<char>(place >> 8)};
    }
  return {{"origin", {origin.x(), origin.y(), origin.z()}}, {"step", step}, {"int16", html::base64(bytes)}};
}

double rounded(double value) { return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr); }

Json frame_json(const ViewedFrame& frame) {
  Json json{{"label", frame.label}, {"atoms", Json::array()}, {"lines", Json::array()}, {"planes", Json::array()}};
  for (const ViewedAtoms& a : frame.atoms)
    json["atoms"].push_back({{"name", a.name}, {"colour", a.colour}, {"diameter", rounded(a.diameter)},
                             {"at", packed(a.at)}});
  for (const ViewedLine& l : frame.lines)
    json["lines"].push_back({{"name", l.name}, {"colour", l.colour}, {"burgers", l.burgers},
                             {"length", rounded(l.length)}, {"at", packed(l.at)}});
  for (const ViewedPlane& p : frame.planes)
    json["planes"].push_back({{"name", p.name}, {"colour", p.colour}, {"area", rounded(p.area)},
                              {"at", packed(p.corners)}});
  return json;
}

void add_if_any(ViewedFrame& frame, ViewedAtoms atoms) {
  if (!atoms.at.empty()) frame.atoms.push_back(std::move(atoms));
}

}  // namespace

ViewedLine viewed_line(std::string_view family, std::vector<Vector3d> at) {
  const Family* found = &families.back();
  for (const Family& f : families)
    if (f.name == family) found = &f;
  return {std::string(found->shown), std::string(found->colour), {}, 0, std::move(at)};
}

ViewedFrame viewed_frame(const FrameDefects& defects, std::string label) {
  ViewedFrame frame{std::move(label), {}, {}, {}};
  const double diameter = 0.8 * defects.spacing;
  ViewedAtoms hcp{"hcp atoms", "#e0574f", diameter, {}}, bulk{"bulk defects", "#c9a227", diameter, {}};
  if (defects.atoms)
    defects.atoms->for_blocks([&](const FrameAtoms& atoms, const AtomLabels& labels) {
      for (std::size_t i = 0; i < atoms.size(); ++i)
        if (labels.structure[i] == Structure::hcp)
          hcp.at.emplace_back(atoms.x[i], atoms.y[i], atoms.z[i]);
        else if (labels.site[i] == Site::bulk_defect)
          bulk.at.emplace_back(atoms.x[i], atoms.y[i], atoms.z[i]);
    });
  add_if_any(frame, std::move(hcp));
  add_if_any(frame, std::move(bulk));
  const PolyData discs = fault_picture(defects.planes);
  for (std::size_t k = 0; k < defects.planes.size(); ++k) {
    const FaultPlane& plane = defects.planes[k];
    ViewedPlane viewed{shown_name(plane.kind), colour(plane.kind), plane.area, {}};
    for (const std::uint32_t corner : discs.polygons[k]) viewed.corners.push_back(discs.points[corner]);
    frame.planes.push_back(std::move(viewed));
  }
  for (const DislocationSegment& s : defects.lines.segments) {
    ViewedLine line = viewed_line(name(s.family), s.points);
    line.burgers = fmt::format("[{:.3g} {:.3g} {:.3g}]", s.burgers.x(), s.burgers.y(), s.burgers.z());
    line.length = s.length.value;
    frame.lines.push_back(std::move(line));
  }
  return frame;
}

Json view_json(const DefectView& view) {
  Json json{{"title", view.title}, {"alt", view.alt}, {"unit", view.unit}, {"frames", Json::array()}};
  for (const ViewedFrame& frame : view.frames) json["frames"].push_back(frame_json(frame));
  return json;
}

std::string live_view(const DefectView& view) {
  const std::string svg = view.frames.empty() ? "" : still_picture(view.frames.front());
  const std::string content = html::picture(svg, view.alt) +
                              html::element("figcaption", html::escape(view.alt));
  if (page_script.text.empty()) return html::element("figure", content);
  const Json json = view_json(view);
  return html::element("figure", content, fmt::format("data-scene=\"{}\"", html::escape(view.name))) +
         html::data_block("scene-" + view.name, json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace mdana
