// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/document.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/version.hpp"

namespace mdana {
namespace {

/// "contact_radius.gyration.max" as the JSON pointer "/contact_radius/gyration/max".
nlohmann::ordered_json::json_pointer pointer(std::string_view name) {
  std::string path = "/" + std::string(name);
  std::replace(path.begin(), path.end(), '.', '/');
  return nlohmann::ordered_json::json_pointer(path);
}

/// Decimals so that the error shows two digits.
int decimals(double error) {
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 15);
}

}  // namespace

std::string to_text(const Value& v, Units units) {
  const std::string unit = symbol(units, v.dimension);
  if (std::isnan(v.value)) return "not determined";
  const std::string tail = unit.empty() ? "" : " " + unit;
  if (!v.error) return fmt::format("{:.6g}{}", v.value, tail);
  const double size = std::abs(v.value);
  if (*v.error > 0 && size < 1e6 && size >= 1e-4) {
    const int d = decimals(*v.error);
    return fmt::format("{:.{}f} ± {:.{}f}{}", v.value, d, *v.error, d, tail);
  }
  return fmt::format("{:.6g} ± {:.2g}{}", v.value, *v.error, tail);
}

Value in_si(const Value& v, const PhysicalUnits& material) {
  const double unit = material.of(v.dimension);
  Value si{v.value * unit, {}, v.dimension};
  if (v.error) si.error = *v.error * unit;
  return si;
}

nlohmann::ordered_json to_json(const Value& v) {
  nlohmann::ordered_json json;
  json["value"] = v.value;
  json["error"] = v.error ? nlohmann::ordered_json(*v.error) : nlohmann::ordered_json(nullptr);
  return json;
}

std::string to_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Document::Document(std::string_view command) {
  root_["command"] = command;
  root_["mdana_version"] = version;
  root_["units"] = nullptr;
  root_["inputs"] = nlohmann::ordered_json::array();
}

Document::Document(std::string_view command, const Run& run) : Document(command) {
  units_ = run.units;
  root_["units"] = name(run.units);
  root_["units_source"] = run.units_source;
  root_["scene"] = run.scene.file.empty() ? nlohmann::ordered_json(nullptr)
                                          : nlohmann::ordered_json(run.scene.file.string());
  root_["bodies"] = run.bodies.rule();
  root_["masses_source"] = run.masses.source();
  line("dump", run.dump.string());
  line("units", fmt::format("{} (from the {})", name(run.units), run.units_source));
  line("bodies", run.bodies.rule());
  line("masses", run.masses.source());
  warnings_ = run.warnings;
  if (run.physical) physical(*run.physical);
}

void Document::physical(const PhysicalUnits& material) {
  physical_ = material;
  nlohmann::ordered_json json{{"name", material.name}, {"source", material.source}};
  for (const auto& [what, d] : {std::pair{"mass", dimension::mass}, {"length", dimension::length},
                                {"energy", dimension::energy}, {"time", dimension::time},
                                {"velocity", dimension::velocity}, {"force", dimension::force},
                                {"pressure", dimension::pressure},
                                {"surface_energy", dimension::surface_energy}})
    json[what] = {{"value", material.of(d)}, {"unit", symbol(Units::si, d)}};
  root_["physical"] = std::move(json);
  line("physical", fmt::format("{}: m {:.5g} kg, σ {:.5g} m, ε {:.5g} J, τ {:.5g} s", material.name,
                               material.mass, material.length, material.energy, material.time()));
}

void Document::number(std::string_view name, const Value& value,
                      const nlohmann::ordered_json& details) {
  numbers_.push_back({std::string(name), value});
  nlohmann::ordered_json json = mdana::to_json(value);
  std::string text = to_text(value, units_);
  if (physical_ && value.dimension != dimension::none) {
    const Value si = in_si(value, *physical_);
    json["si"] = mdana::to_json(si);
    json["si"]["unit"] = symbol(Units::si, si.dimension);
    if (!std::isnan(value.value)) text += fmt::format(" ({})", to_text(si, Units::si));
  }
  if (details.is_object()) json.update(details);
  root_[pointer(name)] = std::move(json);
  line(std::string(name), std::move(text));
}

void Document::text(std::string_view name, const std::string& value) {
  root_[pointer(name)] = value;
  line(std::string(name), value);
}

void Document::json(std::string_view name, nlohmann::ordered_json value) {
  root_[pointer(name)] = std::move(value);
}

void Document::line(std::string label, std::string text) {
  lines_.emplace_back(std::move(label), std::move(text));
}

void Document::set_units(Units units) {
  if (root_["units"].is_string() && units != units_)
    throw InputError(fmt::format("units {}, but those of the runs before are {}", name(units), name(units_)));
  units_ = units;
  root_["units"] = name(units);
}

void Document::warn(std::string warning) { warnings_.push_back(std::move(warning)); }

void Document::left_out(std::string what, std::string reason) {
  root_["left_out"].push_back({{"what", std::move(what)}, {"reason", std::move(reason)}});
}

void Document::input(const InputRecord& file, std::string_view format) {
  root_["inputs"].push_back(
      {{"path", file.path}, {"size", file.size}, {"hash", file.hash}, {"format", format}});
  if (file.changed) warn(fmt::format("{}: it changed while it was read; run again when it is whole", file.path));
}

void Document::damage(const std::string& what) {
  damaged_ = true;
  warn("damaged input: " + what);
}

void Document::sweep(const SweepResult& swept, std::string_view format) {
  for (const InputRecord& file : swept.inputs) input(file, format);
  if (!swept.columns_read.empty()) {
    root_["columns_read"] = swept.columns_read;
    root_["columns_not_read"] = swept.columns_not_read;
  }
  root_["frames"] = swept.steps.size();
  root_["seconds"] = swept.seconds;
  line("frames", fmt::format("{} in {:.2f} s", swept.steps.size(), swept.seconds));
  if (swept.unwrapped)
    warn("positions are wrapped at periodic faces and there are no image flags: bodies are put "
         "together and followed by continuity, which holds while they are smaller than half the box "
         "and move less than that between frames; dump xu yu zu, or ix iy iz besides, to be sure");
  if (swept.uncertain_images > 0)
    warn(fmt::format("up to {} atoms of a frame are so far from their body (0.4 of the box or more) "
                     "that their periodic image is uncertain",
                     swept.uncertain_images));
  if (!swept.damage.empty())
    damage(fmt::format("{}; the results are from the {} whole frames before it", swept.damage,
                       swept.steps.size()));
}

nlohmann::ordered_json Document::content() const {
  nlohmann::ordered_json all = root_;
  all["warnings"] = warnings_;
  return all;
}

std::string Document::to_json() const { return to_text(content()); }

std::string Document::to_terminal() const {
  std::size_t width = 0;
  for (const auto& [label, text] : lines_) width = std::max(width, label.size());
  std::string out;
  for (const auto& [label, text] : lines_) out += fmt::format("{:<{}}  {}\n", label, width, text);
  for (const std::string& w : warnings_) out += fmt::format("warning: {}\n", w);
  return out;
}

}  // namespace mdana
