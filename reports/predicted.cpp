// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/predicted.hpp"

#include <cmath>

#include <fmt/format.h>

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

struct Number {
  std::string_view name;
  Dimension dimension;
  double (*of)(const Collision& c);
};

const Number numbers[] = {
    {"e", dimension::none, [](const Collision& c) { return c.e; }},
    {"e_error", dimension::none, [](const Collision& c) { return c.e_error; }},
    {"delta_max", dimension::length, [](const Collision& c) { return c.delta_max; }},
    {"t_max", dimension::time, [](const Collision& c) { return c.t_max; }},
    {"contact_time", dimension::time, [](const Collision& c) { return c.contact_time; }},
    {"a_max", dimension::length, [](const Collision& c) { return c.a_max; }},
    {"p_c_max", dimension::pressure, [](const Collision& c) { return c.p_c_max; }},
    {"energy_residual", dimension::none, [](const Collision& c) { return c.energy_residual; }},
    {"evaluations", dimension::none,
     [](const Collision& c) { return static_cast<double>(c.evaluations); }},
    {"seconds", dimension::time, [](const Collision& c) { return c.seconds; }},
};

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace

nlohmann::ordered_json to_json(const Collision& c) {
  Json json{{"outcome", name(c.outcome)}};
  json["reason"] = c.reason.empty() ? Json(nullptr) : Json(c.reason);
  for (const Number& n : numbers)
    json[n.name] = n.name == "evaluations" ? Json(c.evaluations) : number(n.of(c));
  json["e_squared"] = number(c.e_squared);
  json["e_squared_error"] = number(c.e_squared_error);
  return json;
}

void add_lines(Document& document, const Collision& c) {
  document.line("outcome", std::string(name(c.outcome)));
  if (!c.reason.empty()) document.line("reason", c.reason);
  for (const Number& n : numbers) {
    const double value = n.of(c);
    if (n.name == "e_error" || n.name == "seconds" || !std::isfinite(value)) continue;
    document.line(std::string(n.name),
                  n.name == "e"                 ? fmt::format("{:.10g} ± {:.1g}", value, c.e_error)
                  : n.name == "energy_residual" ? fmt::format("{:.1g}", value)
                                                : fmt::format("{:.8g}", value));
  }
  document.line("computed", fmt::format("in {:.5f} s", c.seconds));
}

Table collision_table(std::span<const double> velocities, std::span<const Collision> collisions) {
  std::vector<ColumnSpec> columns{{"v", dimension::velocity},
                                  {"outcome", dimension::none, {"bounce", "stick", "unresolved"}}};
  for (const Number& n : numbers) columns.push_back({std::string(n.name), n.dimension});
  Table table(std::move(columns));
  for (std::size_t k = 0; k < collisions.size(); ++k) {
    std::vector<double> row{velocities[k], static_cast<double>(collisions[k].outcome)};
    for (const Number& n : numbers) row.push_back(n.of(collisions[k]));
    table.add_row(row);
  }
  return table;
}

Table trajectory_table(const Collision& collision) {
  Table table(std::vector<ColumnSpec>{{"t", dimension::time},
                                      {"delta", dimension::length},
                                      {"v", dimension::velocity},
                                      {"a", dimension::length},
                                      {"F", dimension::force}});
  for (const CollisionPoint& p : collision.trajectory)
    table.add_row(std::vector{p.time, p.delta, p.velocity, p.contact_radius, p.force});
  return table;
}

void add_velocity(Document& document, const std::string& name, const VelocityFound& found) {
  Json json;
  json["value"] = number(found.velocity);
  json["error"] = number(found.error);
  if (found.e > 0) json["e"] = found.e, json["e_error"] = number(found.e_error);
  json["collisions"] = found.collisions;
  document.json(name, std::move(json));
  if (!found.found()) {
    document.left_out(name, found.reason);
    document.line(name, "not found: " + found.reason);
    return;
  }
  std::string text = fmt::format("{:.12g} ± {:.1g}", found.velocity, found.error);
  if (found.e > 0) text += fmt::format(", e {:.10g} ± {:.1g}", found.e, found.e_error);
  document.line(name, text);
}

}  // namespace mdana
