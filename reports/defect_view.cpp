// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/defect_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

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
  Json json{{"label", shown_label(frame)}, {"atoms", Json::array()}, {"lines", Json::array()}, {"planes", Json::array()}};
  for (const ViewedAtoms& a : frame.atoms)
    json["atoms"].push_back({{"name", a.name}, {"colour", a.colour}, {"diameter", rounded(a.diameter)},
                             {"at", packed(a.at)}});
  for (const ViewedLine& l : frame.lines)
    json["lines"].push_back({{"name", l.name}, {"colour", l.colour}, {"burgers", l.burgers},
                             {"length", rounded(l.length)}, {"at", packed(l.at)}, {"guide", l.guide}});
  for (const ViewedPlane& p : frame.planes)
    json["planes"].push_back({{"name", p.name}, {"colour", p.colour}, {"area", rounded(p.area)},
                              {"at", packed(p.corners)}});
  return json;
}

void thin_atoms(ViewedFrame& frame, std::size_t most) {
  std::size_t count = 0;
  for (const ViewedAtoms& a : frame.atoms) count += a.at.size();
  const std::size_t stride = (count + most - 1) / most;
  if (stride <= 1) return;
  frame.one_of *= stride;
  for (ViewedAtoms& a : frame.atoms) {
    std::vector<Vector3d> kept;
    for (std::size_t i = 0; i < a.at.size(); i += stride) kept.push_back(a.at[i]);
    a.at = std::move(kept);
  }
}

}  // namespace

ViewedLine viewed_line(std::string_view family, std::vector<Vector3d> at) {
  const Family* found = &families.back();
  for (const Family& f : families)
    if (f.name == family) found = &f;
  return {std::string(found->shown), std::string(found->colour), {}, 0, std::move(at)};
}

std::vector<ViewedLine> viewed_sphere(const std::string& name, const Vector3d& centre, double radius, const Vector3d& pole) {
  constexpr int points = 48;
  const Vector3d up = pole.normalized();
  std::vector<ViewedLine> circles;
  for (const Vector3d& side : {up.unitOrthogonal(), up.cross(up.unitOrthogonal())}) {
    ViewedLine line{name, "#8c97a1", {}, 0, {}, true};
    for (int k = 0; k <= points; ++k) {
      const double angle = 2 * std::numbers::pi * k / points;
      line.at.push_back(centre + radius * (std::cos(angle) * up + std::sin(angle) * side));
    }
    circles.push_back(std::move(line));
  }
  return circles;
}

std::string shown_label(const ViewedFrame& frame) {
  std::string text = frame.label;
  if (frame.one_of > 1) text += fmt::format(", one atom of {}", frame.one_of);
  if (frame.dropped > 0) text += fmt::format(", without the {} smallest lines and faults", frame.dropped);
  return text;
}

void limit(ViewedFrame& frame, const ViewLimits& most) {
  thin_atoms(frame, most.atoms);
  const auto guides = std::ranges::stable_partition(frame.lines, [](const ViewedLine& l) { return !l.guide; });
  const auto lines = static_cast<std::size_t>(guides.begin() - frame.lines.begin());
  if (lines > most.lines) {
    frame.dropped += lines - most.lines;
    frame.lines.erase(frame.lines.begin() + static_cast<std::ptrdiff_t>(most.lines), guides.begin());
  }
  if (frame.planes.size() > most.planes) {
    frame.dropped += frame.planes.size() - most.planes;
    frame.planes.resize(most.planes);
  }
}

Json view_json(const DefectView& view) {
  Json json{{"title", view.title}, {"alt", view.alt}, {"unit", view.unit}, {"shown", view.shown}, {"frames", Json::array()}};
  for (const ViewedFrame& frame : view.frames) json["frames"].push_back(frame_json(frame));
  return json;
}

std::string live_view(const DefectView& view) {
  const std::string svg = view.shown < view.frames.size() ? still_picture(view.frames[view.shown]) : "";
  const std::string content = html::picture(svg, view.alt) +
                              html::element("figcaption", html::escape(view.alt));
  if (page_script.text.empty()) return html::element("figure", content);
  const Json json = view_json(view);
  return html::element("figure", content, fmt::format("data-scene=\"{}\"", html::escape(view.name))) +
         html::data_block("scene-" + view.name, json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace mdana
