// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/thermo_summary.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

std::vector<std::string> names(const ThermoTable& table) {
  std::vector<std::string> all;
  for (const auto& column : table.columns) all.push_back(column.name);
  return all;
}

/// A whole number as far as doubles hold them.
nlohmann::ordered_json step_json(double step) {
  if (std::abs(step) < 0x1p53 && std::trunc(step) == step) return static_cast<std::int64_t>(step);
  return step;
}

/// "0 to 6144", if there is a column Step.
std::string steps_text(const ThermoTable& table) {
  const auto* steps = table.find("Step");
  if (!steps || steps->values.empty()) return "";
  return fmt::format(", steps {} to {}", steps->values.front(), steps->values.back());
}

nlohmann::ordered_json steps_json(const ThermoTable& table) {
  const auto* steps = table.find("Step");
  if (!steps || steps->values.empty()) return nullptr;
  return {step_json(steps->values.front()), step_json(steps->values.back())};
}

/// Of each column the last value, null if that is no number that JSON knows.
nlohmann::ordered_json last_values(const ThermoTable& table) {
  auto values = nlohmann::ordered_json::array();
  for (const auto& column : table.columns)
    if (!column.values.empty()) values.push_back(column.values.back());
  return values;
}

nlohmann::ordered_json section_json(const ThermoSection& section) {
  return {{"line", section.first_line},
          {"rows", section.table.rows()},
          {"steps", steps_json(section.table)},
          {"columns", names(section.table)},
          {"last", last_values(section.table)},
          {"timestep", section.timestep ? nlohmann::ordered_json(*section.timestep) : nullptr},
          {"other_lines", section.other_lines},
          {"finished", section.finished}};
}

std::string timestep_text(const ThermoSection& section) {
  return section.timestep ? fmt::format(", time step {}", *section.timestep) : "";
}

void add_section(Document& document, std::size_t number, const ThermoSection& section) {
  document.line(fmt::format("run {}", number),
                fmt::format("{} rows{}{}{}", section.table.rows(), steps_text(section.table),
                            timestep_text(section), section.finished ? "" : ", not finished"));
  document.line("columns", fmt::format("{}", fmt::join(names(section.table), " ")));
  if (section.other_lines > 0)
    document.warn(fmt::format("run {}: {} lines between its rows are no rows and were passed over",
                              number, section.other_lines));
}

/// The runs as one table, or why they cannot be that.
void add_joined(Document& document, const ThermoLog& log) {
  try {
    const ThermoTable joined = join_sections(log);
    document.json("joined", {{"rows", joined.rows()}, {"steps", steps_json(joined)}});
    document.line("all runs", fmt::format("{} rows{}", joined.rows(), steps_text(joined)));
  } catch (const InputError& error) {
    document.json("joined", nullptr);
    document.line("left out", fmt::format("one table of all runs: {}", error.what()));
    document.left_out("one table of all runs", error.what());
  }
}

}  // namespace

Document thermo_summary(const ThermoLog& log) {
  Document document("info");
  document.line("log", log.path);
  document.input(log.input, "lammps_log");
  document.text("format", "lammps_log");
  document.text("lammps_version", log.version);
  document.json("units", log.units ? nlohmann::ordered_json(name(*log.units)) : nullptr);
  document.line("units", log.units ? std::string(name(*log.units)) : "not in the log");
  auto sections = nlohmann::ordered_json::array();
  for (const ThermoSection& section : log.sections) {
    sections.push_back(section_json(section));
    add_section(document, sections.size(), section);
  }
  document.json("sections", sections);
  if (log.sections.size() > 1) add_joined(document, log);
  document.json("lammps_warnings", log.warnings);
  if (log.sections.empty()) document.warn("no thermodynamic output in the log");
  if (!log.error.empty()) document.warn("LAMMPS stopped: " + log.error);
  if (!log.cut.empty()) document.damage(log.cut);
  return document;
}

}  // namespace mdana
