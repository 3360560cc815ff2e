// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/line_numbers.hpp"

#include <cmath>

#include "reports/document.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_segments = 100, most_tracks = 200, most_systems = 24;
constexpr double shortest = 2;  ///< [spacings]

Json vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Json miller(const Eigen::Vector3i& v) { return {v.x(), v.y(), v.z()}; }

Json families(const DislocationLines& lines) {
  Json json;
  for (std::size_t f = 0; f < line_families; ++f) {
    const auto family = static_cast<LineFamily>(f);
    std::size_t segments = 0;
    for (const DislocationSegment& s : lines.segments) segments += s.family == family;
    json[std::string(name(family))] = {{"segments", segments}, {"length", to_json(lines.length(0, family))}};
  }
  return json;
}

Json segment_json(const DislocationSegment& s, std::uint32_t track) {
  Json json{{"track", track},
            {"body", s.body},
            {"family", name(s.family)},
            {"burgers", vector(s.burgers)},
            {"burgers_here", vector(s.burgers_here)},
            {"in_twin", s.in_twin},
            {"aligned", s.aligned},
            {"length", to_json(s.length)},
            {"character_degrees", s.character * 180 / M_PI},
            {"character_spread_degrees", s.character_spread * 180 / M_PI}};
  json["slip_plane"] = s.slip_plane ? miller(*s.slip_plane) : Json(nullptr);
  json["ends"] = {name(s.ends[0]), name(s.ends[1])};
  json["nodes"] = {s.nodes[0], s.nodes[1]};
  return json;
}

Json unresolved_json(const DislocationLines& lines) {
  Json list = Json::array();
  for (const UnresolvedEnds& u : lines.unresolved)
    list.push_back({{"body", u.body}, {"segments", u.segments}, {"burgers", vector(u.burgers)}, {"centre", vector(u.centre)}});
  return list;
}

Json track_json(const LineTrack& t) {
  return {{"body", t.body},       {"family", name(t.family)}, {"burgers", vector(t.burgers)}, {"first_frame", t.first},
          {"last_frame", t.last}, {"longest", t.longest},     {"place", vector(t.place)}};
}

}  // namespace

Json lines_json(const DislocationLines& lines, const std::vector<std::uint32_t>& tracks, double spacing) {
  Json json{{"lines", families(lines)},
            {"total_length", to_json(lines.length(0))},
            {"burgers_residual", lines.residual},
            {"short_length", lines.length_below(shortest * spacing)},
            {"unresolved_length", to_json(lines.absorbed)}};
  Json segments = Json::array();
  for (std::size_t k = 0; k < std::min(lines.segments.size(), most_segments); ++k)
    segments.push_back(segment_json(lines.segments[k], tracks[k]));
  json["segments"] = std::move(segments);
  json["unresolved"] = unresolved_json(lines);
  return json;
}

Json line_history_json(const LineTracks& tracks, std::size_t frames) {
  std::size_t nucleated = 0, absorbed = 0, stored = 0;
  Json list = Json::array();
  for (const LineTrack& t : tracks.tracks()) {
    nucleated += t.first > 0;
    (t.last + 1 == frames ? stored : absorbed) += 1;
    if (list.size() < most_tracks) list.push_back(track_json(t));
  }
  Json systems = Json::array();
  for (const SlipSystem& s : tracks.slip())
    if (systems.size() < most_systems)
      systems.push_back({{"body", s.body}, {"plane", miller(s.plane)}, {"burgers", vector(s.burgers)},
                         {"shear", s.shear}, {"reversed", s.reversed}});
  Json distortion = Json::array();
  for (const BodyIndex body : {BodyIndex{1}, BodyIndex{2}}) {
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row) rows.push_back(vector(tracks.distortion(body).row(row)));
    distortion.push_back(std::move(rows));
  }
  return {{"tracks_seen", tracks.tracks().size()},
          {"nucleated", nucleated},
          {"absorbed", absorbed},
          {"stored", stored},
          {"tracks", std::move(list)},
          {"slip_systems", std::move(systems)},
          {"distortion", std::move(distortion)}};
}

}  // namespace mdana
