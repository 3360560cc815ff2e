// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/inline_lines.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/inline_log.hpp"
#include "readers/trajectory.hpp"
#include "reports/version.hpp"

namespace mdana {
namespace {

constexpr std::size_t most_ranges = 10000;
constexpr std::size_t in_a_line = 10;

struct Range {
  std::int64_t first, last;
};

/// What LAMMPS calls the columns that bodies are told apart by.
std::string style_of(const std::string& column) {
  return column == "mol" ? "molecule" : column;
}

/// Values of the column that tells bodies apart, of each of the two in the first frame.
std::array<std::vector<std::int64_t>, 2> values_of(const Run& run, const std::string& column) {
  std::array<std::vector<std::int64_t>, 2> values;
  std::vector<BodyIndex> body;
  for_first_frame(run.dump, run.bodies.columns(), [&](const AtomBlock& block) {
    run.bodies.label(block, body);
    const auto value = block.integer(column);
    for (std::size_t i = 0; i < body.size(); ++i)
      if (body[i] == 1 || body[i] == 2)
        if (auto& of = values[body[i] - 1]; of.empty() || of.back() != value[i]) of.push_back(value[i]);
  }, run.selection);
  return values;
}

std::vector<Range> ranges_of(std::vector<std::int64_t> values, const Run& run) {
  std::ranges::sort(values);
  std::vector<Range> ranges;
  for (const std::int64_t v : values)
    if (!ranges.empty() && v <= ranges.back().last + 1)
      ranges.back().last = v;
    else
      ranges.push_back({v, v});
  if (ranges.empty()) throw InputError(fmt::format("{}: a body has no atoms in the first frame", run.dump.string()));
  if (ranges.size() > most_ranges)
    throw InputError(fmt::format("{}: the bodies ({}) are more than {} ranges of numbers; give them types or molecule numbers in the "
                                 "simulation", run.dump.string(), run.bodies.rule(), most_ranges));
  return ranges;
}

/// A group command adds to the group that is there.
std::string group_lines(int body, const std::string& style, const std::vector<Range>& ranges) {
  std::string text;
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    if (k % in_a_line == 0) text += fmt::format("{}group           mdana{} {}", k ? "\n" : "", body, style);
    text += ranges[k].first == ranges[k].last ? fmt::format(" {}", ranges[k].first) : fmt::format(" {}:{}", ranges[k].first, ranges[k].last);
  }
  return text + "\n";
}

/// The variable of a column of the file, and what it is.
std::string formula_of(const std::string& column, int body) {
  const std::string group = fmt::format("mdana{}", body);
  const std::string last = column.substr(column.size() - 1);
  if (column == "n") return fmt::format("count({})", group);
  if (column == "m") return fmt::format("mass({})", group);
  if (column == "Kt") return fmt::format("0.5*(c_mdana_t{0}[1]+c_mdana_t{0}[2]+c_mdana_t{0}[3])", body);
  if (column == "W") return fmt::format("c_mdana_w{}", body);
  if (column.starts_with('I')) return fmt::format("inertia({},{})", group, column.substr(1));
  const char* function = column.starts_with('v') ? "vcm" : column.starts_with('f') ? "fcm" : column.starts_with('L') ? "angmom" : "xcm";
  return fmt::format("{}({},{})", function, group, last);
}

std::string variable_line(const std::string& column) {
  const int body = column.back() - '0';
  const bool shared = body != 1 && body != 2;
  return fmt::format("variable        mdana_{} equal {}\n", column, shared ? column : formula_of(column.substr(0, column.size() - 1), body));
}

std::string potential_lines() {
  std::string text = "compute         mdana_pe all pe/atom\n";
  for (const int body : {1, 2}) text += fmt::format("compute         mdana_w{0} mdana{0} reduce sum c_mdana_pe\n", body);
  return text;
}

std::string title_of(const Run& run) {
  std::string title = fmt::format("{}units={} interaction={}", inline_title, name(run.units), name(run.scene.interaction));
  if (run.scene.radii.size() == 2) title += fmt::format(" radii={:.17g},{:.17g}", run.scene.radii[0], run.scene.radii[1]);
  if (run.scene.radii.size() == 2 && !run.scene.radius_definition.empty()) {
    std::string definition = run.scene.radius_definition;
    std::ranges::replace_if(definition, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '-');
    title += " radius_definition=" + definition;
  }
  return title + " bodies=" + run.bodies.rule();
}

std::string fix_lines(const Run& run, const InlineWishes& wishes, const std::vector<std::string>& columns) {
  std::string text = "fix             mdana all ave/time ${mdana_every} 1 ${mdana_every}";
  for (std::size_t k = 0; k < columns.size(); ++k) text += fmt::format("{}v_mdana_{}", k % in_a_line == 0 ? " &\n                " : " ", columns[k]);
  return text + fmt::format(" &\n                file {} format \" %.17g\" &\n                title1 \"{}\" &\n                title2 \"{}{}\"\n",
                            wishes.file, title_of(run), inline_columns_title, fmt::join(columns, " "));
}

}  // namespace

std::string inline_lines(const Run& run, const InlineWishes& wishes) {
  const std::string column = run.bodies.columns().names().front();
  const auto values = values_of(run, column);
  const std::vector<std::string> columns = inline_columns(wishes.potential);
  std::string text = fmt::format(
      "# Lines for LAMMPS by mdana {} (emit --for lammps-inline): what mdana force, fit-hertz, fit-force and energy need of\n"
      "# two bodies ({}), every so many steps of the run, into {}.\n"
      "# include this behind the pair style and before the run of the collision.\n"
      "variable        mdana_every index {}\n", version, run.bodies.rule(), wishes.file, wishes.every);
  for (const int body : {1, 2}) text += group_lines(body, style_of(column), ranges_of(values[static_cast<std::size_t>(body - 1)], run));
  for (const int body : {1, 2}) text += fmt::format("compute         mdana_t{0} mdana{0} temp/com\n", body);
  if (wishes.potential) text += potential_lines();
  for (const std::string& c : columns) text += variable_line(c);
  return text + fix_lines(run, wishes, columns);
}

}  // namespace mdana
