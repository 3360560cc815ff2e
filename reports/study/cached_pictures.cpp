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

Json places(const std::vector<Eigen::Vector3d>& points) {
  Json list = Json::array();
  for (const Eigen::Vector3d& p : points)
    for (const double x : p) list.push_back(rounded(x));
  return list;
}

std::vector<Eigen::Vector3d> points(const Json& list) {
  std::vector<Eigen::Vector3d> all;
  for (std::size_t i = 0; i + 2 < list.size(); i += 3)
    all.emplace_back(list[i].get<double>(), list[i + 1].get<double>(), list[i + 2].get<double>());
  return all;
}

Json places(const std::vector<Strip>& strips) {
  Json list = Json::array();
  for (const Strip& s : strips)
    for (const double x : {s.from, s.to, s.height}) list.push_back(rounded(x));
  return list;
}

std::vector<Strip> strips_of(const Json& list) {
  std::vector<Strip> all;
  for (const Eigen::Vector3d& p : points(list)) all.push_back({p.x(), p.y(), p.z()});
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
  return {{"label", s.label}, {"step", s.step}, {"time", known(s.time)}, {"delta", known(s.delta)}, {"diameter", s.diameter},
          {"atoms", s.atoms}, {"body1", places(s.at[0])}, {"body2", places(s.at[1])}, {"row", s.row},
          {"strips1", places(s.strips[0])}, {"strips2", places(s.strips[1])}};
}

Snapshot cached_snapshot(const Json& json) {
  return {json.at("label"), json.at("step"), known_double(json.at("time")), known_double(json.at("delta")), json.at("diameter"),
          json.at("atoms"), {points(json.at("body1")), points(json.at("body2"))}, json.at("row"),
          {strips_of(json.at("strips1")), strips_of(json.at("strips2"))}};
}

Json cached(const ViewedFrame& frame) {
  Json json{{"label", frame.label}, {"one_of", frame.one_of}, {"dropped", frame.dropped}, {"atoms", Json::array()}, {"lines", Json::array()}, {"planes", Json::array()}};
  for (const ViewedAtoms& a : frame.atoms) json["atoms"].push_back(of_atoms(a));
  for (const ViewedLine& l : frame.lines) json["lines"].push_back(of_line(l));
  for (const ViewedPlane& p : frame.planes) json["planes"].push_back(of_plane(p));
  return json;
}

ViewedFrame cached_view(const Json& json) {
  ViewedFrame frame{json.at("label"), {}, {}, {}, json.at("one_of"), json.at("dropped")};
  for (const Json& a : json.at("atoms"))
    frame.atoms.push_back({a.at("name"), a.at("colour"), a.at("diameter"), points(a.at("at"))});
  for (const Json& l : json.at("lines"))
    frame.lines.push_back({l.at("name"), l.at("colour"), l.at("burgers"), l.at("length"), points(l.at("at")), l.at("guide")});
  for (const Json& p : json.at("planes"))
    frame.planes.push_back({p.at("name"), p.at("colour"), p.at("area"), points(p.at("at"))});
  return frame;
}

}  // namespace mdana
