// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/cached_pictures.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) { return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr); }

/// Null is NaN.
Json known(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
double known_double(const Json& json) { return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>(); }

template <class Vector>
Json places(const std::vector<Vector>& points) {
  Json list = Json::array();
  for (const Vector& p : points)
    for (const double x : p) list.push_back(rounded(x));
  return list;
}

template <class Vector>
std::vector<Vector> points(const Json& list) {
  constexpr std::size_t n = Vector::SizeAtCompileTime;
  std::vector<Vector> all(list.size() / n);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < n; ++k) all[i][static_cast<Eigen::Index>(k)] = list[n * i + k];
  return all;
}

Json of_atoms(const ViewedAtoms& a) {
  return {{"name", a.name}, {"colour", a.colour}, {"diameter", a.diameter}, {"at", places(a.at)}};
}

Json of_line(const ViewedLine& l) {
  return {{"name", l.name}, {"colour", l.colour}, {"burgers", l.burgers}, {"length", l.length}, {"at", places(l.at)}, {"guide", l.guide}};
}

Json of_plane(const ViewedPlane& p) {
  return {{"name", p.name}, {"colour", p.colour}, {"area", p.area}, {"at", places(p.corners)}};
}

}  // namespace

Json cached(const Snapshot& s) {
  return {{"label", s.label}, {"step", s.step}, {"time", known(s.time)}, {"delta", known(s.delta)}, {"squares", s.squares},
          {"thickness", s.thickness}, {"size", s.size}, {"atoms", s.atoms}, {"body1", places(s.at[0])}, {"body2", places(s.at[1])}};
}

Snapshot cached_snapshot(const Json& json) {
  return {json.at("label"), json.at("step"), known_double(json.at("time")), known_double(json.at("delta")), json.at("squares"),
          json.at("thickness"), json.at("size"), json.at("atoms"),
          {points<Eigen::Vector2d>(json.at("body1")), points<Eigen::Vector2d>(json.at("body2"))}};
}

Json cached(const ViewedFrame& frame) {
  Json json{{"label", frame.label}, {"one_of", frame.one_of}, {"atoms", Json::array()}, {"lines", Json::array()}, {"planes", Json::array()}};
  for (const ViewedAtoms& a : frame.atoms) json["atoms"].push_back(of_atoms(a));
  for (const ViewedLine& l : frame.lines) json["lines"].push_back(of_line(l));
  for (const ViewedPlane& p : frame.planes) json["planes"].push_back(of_plane(p));
  return json;
}

ViewedFrame cached_view(const Json& json) {
  ViewedFrame frame{json.at("label"), {}, {}, {}, json.at("one_of")};
  for (const Json& a : json.at("atoms"))
    frame.atoms.push_back({a.at("name"), a.at("colour"), a.at("diameter"), points<Eigen::Vector3d>(a.at("at"))});
  for (const Json& l : json.at("lines"))
    frame.lines.push_back({l.at("name"), l.at("colour"), l.at("burgers"), l.at("length"), points<Eigen::Vector3d>(l.at("at")), l.at("guide")});
  for (const Json& p : json.at("planes"))
    frame.planes.push_back({p.at("name"), p.at("colour"), p.at("area"), points<Eigen::Vector3d>(p.at("at"))});
  return frame;
}

}  // namespace mdana
