// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/defect_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "reports/line_numbers.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_planes = 50;      ///< told of a frame, the greatest
constexpr double least_crystal = 0.1;        ///< share of inner atoms below which a warning says so
constexpr std::array<const char*, 6> counted{"fcc", "hcp", "other", "surface", "contact",
                                             "bulk_defect"};

double at(const DefectHistory& h, std::string_view column, std::size_t frame) {
  return h.table.column(column)[frame];
}

Json whole(double count) { return static_cast<std::int64_t>(count); }

Json vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json counts(const DefectHistory& h, std::size_t frame) {
  Json json;
  for (const char* name : counted) json[name] = whole(at(h, name, frame));
  return json;
}

/// Area of the planes of a kind with its error.
Value area(const std::vector<FaultPlane>& planes, bool twin) {
  double sum = 0, square = 0;
  for (const FaultPlane& plane : planes) {
    if ((plane.kind == PlanarFault::twin) != twin) continue;
    sum += plane.area;
    square += plane.error * plane.error;
  }
  return {sum, std::sqrt(square), dimension::area};
}

Json planes_json(const std::vector<FaultPlane>& planes) {
  Json list = Json::array();
  for (std::size_t k = 0; k < std::min(planes.size(), most_planes); ++k) {
    const FaultPlane& p = planes[k];
    list.push_back({{"kind", name(p.kind)},
                    {"body", p.body},
                    {"area", to_json(Value{p.area, p.error, dimension::area})},
                    {"normal", vector(p.normal)},
                    {"centre", vector(p.centre)},
                    {"hcp_atoms", p.atoms}});
  }
  return list;
}

/// The lattice of each body: quaternion w x y z, and its turn since the first frame.
Json lattices(const DefectHistory& h, std::size_t frame) {
  Json list = Json::array();
  for (const int body : {1, 2}) {
    const auto turn = lattice_turn(h.table, frame, body), first = lattice_turn(h.table, 0, body);
    if (!turn) {
      list.push_back(nullptr);
      continue;
    }
    list.push_back({{"quaternion", {turn->w(), turn->x(), turn->y(), turn->z()}},
                    {"share", at(h, fmt::format("lattice_share{}", body), frame)},
                    {"turned", first ? Json(misorientation(*turn, *first)) : Json(nullptr)}});
  }
  return list;
}

/// A column of a body, with that of its error.
Value of_body(const DefectHistory& h, std::size_t frame, std::string_view name, std::string_view body, Dimension d) {
  return {at(h, fmt::format("{}{}", name, body), frame), at(h, fmt::format("{}_error{}", name, body), frame), d};
}

/// Of one body; null if it has none.
Json body_surface(const DefectHistory& h, std::size_t frame, const std::string& body) {
  if (at(h, "surface_radius" + body, frame) == 0) return nullptr;
  return {{"area", to_json(of_body(h, frame, "surface_area", body, dimension::area))},
          {"volume", to_json(of_body(h, frame, "surface_volume", body, dimension::volume))},
          {"radius", to_json(of_body(h, frame, "surface_radius", body, dimension::length))},
          {"radius_atoms", at(h, "radius_atoms" + body, frame)},
          {"radius_gyration", at(h, "radius_gyration" + body, frame)},
          {"voids", whole(at(h, "voids" + body, frame))},
          {"void_volume", to_json(Value{at(h, "void_volume" + body, frame), {}, dimension::volume})}};
}

/// Of both bodies together, or the mean of those that have it. The rule of the error is the same for both, so
/// that errors add up.
Value of_bodies(const DefectHistory& h, std::size_t frame, std::string_view name, Dimension d, bool mean) {
  double value = 0, error = 0, bodies = 0;
  for (const char* body : {"1", "2"}) {
    const Value one = of_body(h, frame, name, body, d);
    value += one.value;
    error += one.error.value_or(0);
    bodies += at(h, fmt::format("surface_radius{}", body), frame) > 0;
  }
  const double share = mean ? bodies : 1;
  return {value / share, error / share, d};
}

bool has_surface(const DefectHistory& h, std::size_t frame) {
  return h.table.has("surface_area1") && at(h, "surface_radius1", frame) + at(h, "surface_radius2", frame) > 0;
}

/// Area and volume of both bodies together, their mean radius, and each; null if they were not asked for.
Json surface_json(const DefectHistory& h, std::size_t frame) {
  if (!has_surface(h, frame)) return nullptr;
  return {{"area", to_json(of_bodies(h, frame, "surface_area", dimension::area, false))},
          {"volume", to_json(of_bodies(h, frame, "surface_volume", dimension::volume, false))},
          {"radius", to_json(of_bodies(h, frame, "surface_radius", dimension::length, true))},
          {"bodies", {body_surface(h, frame, "1"), body_surface(h, frame, "2")}}};
}

/// Where the bodies cover each other; null if surfaces were not asked for.
Json patch_json(const DefectHistory& h, std::size_t frame) {
  if (!h.table.has("patch_area")) return nullptr;
  return to_json(Value{at(h, "patch_area", frame), at(h, "patch_area_error", frame), dimension::area});
}

/// Step, time and delta of a frame, as far as they are known.
Json moment(const DefectHistory& h, std::size_t frame) {
  Json json{{"step", h.steps[frame]}};
  if (!h.times.empty()) json["time"] = h.times[frame];
  if (!h.delta.empty()) json["delta"] = h.delta[frame];
  return json;
}

Json frame_json(const DefectHistory& h, std::size_t frame) {
  Json json = moment(h, frame);
  json["spacing"] = at(h, "spacing", frame);
  json["counts"] = counts(h, frame);
  json["bcc"] = whole(at(h, "bcc", frame));
  json["ico"] = whole(at(h, "ico", frame));
  json["repaired"] = whole(at(h, "repaired", frame));
  json["fault_area"] = to_json(area(h.planes[frame], false));
  json["twin_area"] = to_json(area(h.planes[frame], true));
  json["planes"] = planes_json(h.planes[frame]);
  json["lattices"] = lattices(h, frame);
  json["surface"] = surface_json(h, frame);
  json["patch_area"] = patch_json(h, frame);
  if (!h.lines.empty()) json.update(h.lines.frame(frame));
  return json;
}

double plastic(const DefectHistory& h, std::size_t frame) {
  return at(h, "hcp", frame) + at(h, "bulk_defect", frame);
}

std::string told(const DefectHistory& h, std::size_t frame) {
  std::string text = fmt::format("step {}", h.steps[frame]);
  if (!h.times.empty()) text += fmt::format(", time {:.6g}", h.times[frame]);
  if (!h.delta.empty()) text += fmt::format(", delta {:.4g}", h.delta[frame]);
  return text;
}

std::string told_counts(const DefectHistory& h, std::size_t frame) {
  return fmt::format("{} fcc, {} hcp, {} surface, {} contact, {} bulk defects",
                     at(h, "fcc", frame), at(h, "hcp", frame), at(h, "surface", frame),
                     at(h, "contact", frame), at(h, "bulk_defect", frame));
}

void add_first_defect(Document& document, const DefectHistory& h) {
  const auto frame = first_defect(h);
  document.json("first_defect", nullptr);
  if (!frame) return document.line("first defect", "none: no more than in the first frame");
  const Eigen::Vector3d place(at(h, "defect_x", *frame), at(h, "defect_y", *frame),
                              at(h, "defect_z", *frame));
  Json json = moment(h, *frame);
  json["atoms"] = whole(plastic(h, *frame));
  json["place"] = vector(place);
  document.json("first_defect", json);
  document.line("first defect", fmt::format("{}: {} atoms about ({:.4g}, {:.4g}, {:.4g})",
                                            told(h, *frame), plastic(h, *frame), place.x(),
                                            place.y(), place.z()));
}

void add_separation(Document& document, const DefectHistory& h) {
  const auto frame = separation(h);
  document.json("at_separation", nullptr);
  if (!frame && at(h, "contact", h.steps.size() - 1) > 0)
    document.line("at separation", "none: still in contact in the last frame");
  if (!frame) return;
  Json json = moment(h, *frame);
  json["counts"] = counts(h, *frame);
  document.json("at_separation", json);
  document.line("at separation", fmt::format("{}: {}", told(h, *frame), told_counts(h, *frame)));
}

void add_greatest(Document& document, const DefectHistory& h, const char* what, bool twin) {
  std::size_t most = 0;
  for (std::size_t frame = 0; frame < h.planes.size(); ++frame)
    if (area(h.planes[frame], twin).value > area(h.planes[most], twin).value) most = frame;
  const Value greatest = area(h.planes[most], twin);
  document.line(fmt::format("most {}", what),
                greatest.value > 0
                    ? fmt::format("{} at {}", to_text(greatest, document.units()), told(h, most))
                    : "none");
}

/// The lines where they are longest, and what became of them; a warning where something was missed.
void add_lines(Document& document, const DefectHistory& h) {
  if (h.lines.empty()) return document.left_out("lines", "--no-lines");
  const auto length = h.table.column("line_length"), residual = h.table.column("burgers_residual");
  const auto most = static_cast<std::size_t>(std::ranges::max_element(length) - length.begin());
  const auto families = [&](std::size_t frame) {
    std::string text;
    for (std::size_t f = 0; f < line_families; ++f) {
      const std::string family(name(static_cast<LineFamily>(f)));
      const double l = at(h, family + "_length", frame);
      if (l > 0) text += fmt::format("{}{} {:.4g}", text.empty() ? ": " : ", ", family, l);
    }
    return text;
  };
  const auto whole_length = [&](std::size_t frame) {
    return to_text(Value{length[frame], at(h, "line_length_error", frame), dimension::length}, document.units());
  };
  document.line("most lines", length[most] > 0 ? fmt::format("{} at {}{}", whole_length(most), told(h, most), families(most))
                                               : "none");
  const std::size_t last = h.steps.size() - 1;
  if (last > 0 && length[most] > 0)
    document.line("lines at the end", length[last] > 0 ? whole_length(last) + families(last) : "none");
  const Json history = line_history_json(h.lines.tracks(), h.steps.size());
  document.json("line_history", history);
  if (last > 0 && length[most] > 0)
    document.line("segments", fmt::format("{} followed: {} nucleated, {} absorbed, {} stored at the end",
                                          history["tracks_seen"].get<std::size_t>(), history["nucleated"].get<std::size_t>(),
                                          history["absorbed"].get<std::size_t>(), history["stored"].get<std::size_t>()));
  const auto worst = static_cast<std::size_t>(std::ranges::max_element(residual) - residual.begin());
  if (residual[worst] > 0)
    document.warn(fmt::format("lines end inside a crystal in {} of {} frames, most at {}: Burgers vectors that add up to {:.3g} "
                              "lattice constants lead nowhere (burgers_residual); those lines were missed in part",
                              std::ranges::count_if(residual, [](double r) { return r > 0; }), residual.size(),
                              told(h, worst), residual[worst]));
}

/// Area, volume and radius of the surfaces in a frame.
void add_surface(Document& document, const DefectHistory& h, const char* label, std::size_t frame) {
  if (!has_surface(h, frame)) return;
  const auto text = [&](const char* name, Dimension d, bool mean) {
    return to_text(of_bodies(h, frame, name, d, mean), document.units());
  };
  document.line(label, fmt::format("area {}, volume {}, radius {}", text("surface_area", dimension::area, false),
                                   text("surface_volume", dimension::volume, false),
                                   text("surface_radius", dimension::length, true)));
}

/// What evenly chosen frames show, a line each.
void add_course(Document& document, const DefectHistory& h) {
  constexpr std::size_t most = 12;
  const std::size_t count = std::min(most, h.steps.size());
  if (count < 2) return;
  const bool surfaces = h.table.has("patch_area");
  std::string head = fmt::format("{:>10}{:>9}{:>8}{:>8}{:>10}{:>10}", "step", "delta", "hcp", "bulk", "faults", "twins");
  if (surfaces) head += fmt::format("{:>11}{:>10}", "surface", "patch");
  document.line("in time", fmt::format("{}   areas in {}", head, symbol(document.units(), dimension::area)));
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t frame = k * (h.steps.size() - 1) / (count - 1);
    const auto delta = h.delta.empty() ? "-" : fmt::format("{:.3f}", h.delta[frame]);
    std::string row = fmt::format("{:>10}{:>9}{:>8}{:>8}{:>10.4g}{:>10.4g}", h.steps[frame], delta, at(h, "hcp", frame),
                                  at(h, "bulk_defect", frame), at(h, "fault_area", frame), at(h, "twin_area", frame));
    if (surfaces)
      row += fmt::format("{:>11.5g}{:>10.4g}", at(h, "surface_area1", frame) + at(h, "surface_area2", frame),
                         at(h, "patch_area", frame));
    document.line("", row);
  }
}

/// Says what the atoms are if they are no fcc or hcp crystal.
void warn_of_structure(Document& document, const DefectHistory& h) {
  const double crystal = at(h, "fcc", 0) + at(h, "hcp", 0), bulk = at(h, "bulk_defect", 0),
               bcc = at(h, "bcc", 0), ico = at(h, "ico", 0);
  if (crystal + bulk + bcc == 0) {
    document.warn("every atom of the first frame is at the surface: a sheet, a gas, or clusters too small "
                  "for a crystal");
    return;
  }
  if (crystal >= least_crystal * (crystal + bulk)) return;
  const std::string kind = bcc > bulk / 2   ? "bcc"
                           : ico > bulk / 2 ? "icosahedral"
                                            : "amorphous, molten, or crystals of another kind";
  document.warn(fmt::format("the inner atoms of the first frame are not fcc or hcp ({} of {}) but {}: "
                            "stacking faults, twins and bulk defects mean nothing there", crystal,
                            crystal + bulk, kind));
}

}  // namespace

std::optional<std::size_t> first_defect(const DefectHistory& h) {
  for (std::size_t frame = 1; frame < h.steps.size(); ++frame)
    if (plastic(h, frame) >= plastic(h, 0) + least_new_defects) return frame;
  return std::nullopt;
}

std::optional<std::size_t> separation(const DefectHistory& h) {
  const auto contact = h.table.column("contact");
  std::size_t frame = contact.size();
  while (frame > 0 && contact[frame - 1] == 0) --frame;
  if (frame == 0 || frame == contact.size()) return std::nullopt;
  return frame;
}

void add_defects(Document& document, const DefectHistory& h) {
  const std::size_t last = h.steps.size() - 1;
  document.line("spacing", to_text(Value{at(h, "spacing", 0), {}, dimension::length}, document.units()));
  document.line("first frame", told_counts(h, 0));
  if (last > 0) document.line("last frame", told_counts(h, last));
  add_first_defect(document, h);
  add_separation(document, h);
  add_greatest(document, h, "faults", false);
  add_greatest(document, h, "twins", true);
  add_surface(document, h, "surface", 0);
  if (last > 0) add_surface(document, h, "last surface", last);
  add_course(document, h);
  Json frames = Json::array();
  for (std::size_t frame = 0; frame <= last; ++frame) frames.push_back(frame_json(h, frame));
  document.json("frames", std::move(frames));
  if (!h.table.has("surface_area1")) document.left_out("surface", "--no-surface");
  add_lines(document, h);
  warn_of_structure(document, h);
}

Table defect_table(const DefectHistory& h) {
  Table table;
  table.add_column({"step", dimension::none}, {h.steps.begin(), h.steps.end()});
  if (!h.times.empty()) table.add_column({"time", dimension::time}, h.times);
  if (!h.delta.empty()) table.add_column({"delta", dimension::length}, h.delta);
  for (std::size_t k = 0; k < h.table.columns().size(); ++k) {
    const auto values = h.table.column(k);
    table.add_column(h.table.columns()[k], {values.begin(), values.end()});
  }
  for (const int body : {1, 2}) {
    std::vector<double> turned;
    const auto first = lattice_turn(h.table, 0, body);
    for (std::size_t frame = 0; frame < h.steps.size(); ++frame) {
      const auto turn = lattice_turn(h.table, frame, body);
      turned.push_back(turn && first ? misorientation(*turn, *first)
                                     : std::numeric_limits<double>::quiet_NaN());
    }
    table.add_column({fmt::format("lattice_turned{}", body), dimension::none}, std::move(turned));
  }
  return table;
}

}  // namespace mdana
