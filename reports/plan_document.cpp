// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/plan_document.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

const PartCost* cost_of(const PlanCost& cost, std::string_view what) {
  const auto at = std::ranges::find(cost.parts, what, &PartCost::what);
  return at == cost.parts.end() ? nullptr : &*at;
}

Json scene_json(const Run& run) {
  return {{"interaction", name(run.scene.interaction)},
          {"bodies", run.bodies.count()},
          {"atoms", run.first.atoms},
          {"columns", run.first.columns}};
}

/// Columns of any part, in the order of the dump.
std::vector<std::string> columns_read(const Run& run, const Plan& plan) {
  std::vector<std::string> columns;
  for (const std::string& column : run.first.columns)
    if (std::ranges::any_of(plan.computed, [&](const PlannedPart& p) {
          return std::ranges::find(p.columns, column) != p.columns.end();
        }))
      columns.push_back(column);
  return columns;
}

Json computed_json(const CostedPlan& planned) {
  Json all = Json::array();
  for (const PlannedPart& part : planned.plan.computed) {
    Json json{{"what", name(part.part)}, {"columns", part.columns}, {"reason", part.reason}};
    const PartCost* cost = cost_of(planned.cost, name(part.part));
    json["seconds"] = cost ? Json(cost->seconds) : Json(nullptr);
    json["bytes"] = cost ? Json(cost->bytes) : Json(nullptr);
    json["passes"] = cost ? cost->passes : 0;
    all.push_back(std::move(json));
  }
  return all;
}

Json estimate_json(const PlanCost& cost) {
  Json parts = Json::array();
  for (const PartCost& part : cost.parts)
    parts.push_back({{"what", part.what}, {"passes", part.passes}, {"seconds", part.seconds}, {"bytes", part.bytes}});
  return {{"seconds", cost.seconds}, {"processor_seconds", cost.processor_seconds}, {"bytes", cost.bytes},
          {"factor", cost.factor},   {"source", cost.source},                       {"numbers", cost.tokens},
          {"input_bytes", cost.input_bytes}, {"parts", parts}};
}

std::string cost_text(const PartCost* cost) {
  if (!cost) return std::string(16, ' ');
  return fmt::format("{:>8} {:>7}", time_text(cost->seconds), cost->bytes > 5e5 ? bytes_text(cost->bytes) : "");
}

/// A block of the terminal: a head, and lines below it.
void add_computed_lines(Document& document, const CostedPlan& planned) {
  document.line("computed", fmt::format("{:>8} {:>7}  because (from columns)", "time", "memory"));
  for (const PartCost& part : planned.cost.parts)
    if (!part.shared.empty()) document.line("  " + part.what, fmt::format("{}  {}", cost_text(&part), part.shared));
  for (const PlannedPart& part : planned.plan.computed)
    document.line(fmt::format("  {}", name(part.part)),
                  fmt::format("{}  {} ({})", cost_text(cost_of(planned.cost, name(part.part))), part.reason,
                              fmt::join(part.columns, " ")));
  document.line("left out", planned.plan.left_out.empty() ? "nothing" : "because");
  for (const LeftOut& l : planned.plan.left_out) document.line("  " + l.what, l.reason);
}

std::string estimate_text(double processor_seconds, double seconds, double bytes) {
  return fmt::format("about {} of processors, {} by the clock, {}", time_text(processor_seconds), time_text(seconds),
                     bytes_text(bytes));
}

}  // namespace

std::string time_text(double seconds) {
  if (seconds < 0.0995) return fmt::format("{:.0f} ms", 1000 * seconds);
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  if (seconds < 600) return fmt::format("{:.0f} s", seconds);
  return fmt::format("{:.0f} min", seconds / 60);
}

std::string bytes_text(double bytes) {
  return bytes < 10e9 ? fmt::format("{:.0f} MB", bytes / 1e6) : fmt::format("{:.0f} GB", bytes / 1e9);
}

void add_costed_plan(Document& document, const Run& run, const CostedPlan& planned) {
  const auto& [plan, cost] = planned;
  const std::vector<std::string> read = columns_read(run, plan);
  document.json("dump", run.dump.string());
  document.json("plan.scene", scene_json(run));
  document.json("frames", cost.frames);
  document.json("frames_source", cost.frames_source);
  document.json("columns_read", read);
  document.json("computed", computed_json(planned));
  document.json("left_out", Json::array());
  for (const LeftOut& l : plan.left_out) document.left_out(l.what, l.reason);
  document.json("estimate", estimate_json(cost));
  document.line("scene", fmt::format("{}, {} bod{}, {} atoms", name(run.scene.interaction), run.bodies.count(),
                                     run.bodies.count() == 1 ? "y" : "ies", run.first.atoms));
  document.line("frames", fmt::format("{} ({})", cost.frames, cost.frames_source));
  document.line("columns", fmt::format("{} of {} read: {}", read.size(), run.first.columns.size(), fmt::join(read, " ")));
  add_computed_lines(document, planned);
  if (!plan.computed.empty())
    document.line("estimate", fmt::format("{}; the time within a factor of {:.2g}: {}", estimate_text(cost.processor_seconds, cost.seconds, cost.bytes),
                                          cost.factor, cost.source));
}

Table cost_table(const PlanCost& cost) {
  std::vector<std::string> names;
  std::vector<double> index, passes, seconds, bytes;
  for (const PartCost& part : cost.parts) {
    index.push_back(static_cast<double>(names.size()));
    names.push_back(part.what);
    passes.push_back(part.passes);
    seconds.push_back(part.seconds);
    bytes.push_back(part.bytes);
  }
  Table table;
  table.add_column({"what", {}, std::move(names)}, std::move(index));
  table.add_column({"passes", {}}, std::move(passes));
  table.add_column({"seconds", {}}, std::move(seconds));
  table.add_column({"bytes", {}}, std::move(bytes));
  return table;
}

void add_study_plan(Document& document, const std::vector<PlannedOfStudy>& runs) {
  Json list = Json::array();
  double processors = 0, seconds = 0, bytes = 0;
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> left_out;
  for (const PlannedOfStudy& run : runs) {
    Json json{{"name", run.name}, {"state", run.state}, {"cached", run.cached}};
    std::string text = run.failure.empty() ? run.state : "fails: " + run.failure;
    if (!run.failure.empty()) {
      json["failure"] = run.failure;
    } else {
      json.update(run.document);
      for (const LeftOut& l : run.planned.plan.left_out) left_out[{l.what, l.reason}].push_back(run.name);
      if (!run.cached) {
        const PlanCost& cost = run.planned.cost;
        processors += cost.processor_seconds;
        seconds += cost.seconds;
        bytes = std::max(bytes, cost.bytes);
        text += ", " + estimate_text(cost.processor_seconds, cost.seconds, cost.bytes);
      }
    }
    document.line(run.name, text);
    list.push_back(std::move(json));
  }
  document.json("runs", std::move(list));
  document.json("estimate", {{"seconds", seconds}, {"processor_seconds", processors}, {"bytes", bytes}});
  document.line("left out", "because (in which runs)");
  for (const auto& [what, names] : left_out)
    document.line("  " + what.first, fmt::format("{} ({})", what.second, fmt::join(names, ", ")));
  document.line("all", fmt::format("{}, run by run; figures and the page, some seconds, come besides", estimate_text(processors, seconds, bytes)));
}

Table study_cost_table(const std::vector<PlannedOfStudy>& runs) {
  std::vector<std::string> names;
  Table numbers({{"cached", {}}, {"frames", {}}, {"seconds", {}}, {"bytes", {}}});
  std::vector<double> index;
  for (const PlannedOfStudy& run : runs) {
    index.push_back(static_cast<double>(names.size()));
    names.push_back(run.name);
    const PlanCost& cost = run.planned.cost;
    numbers.add_row(std::array{run.cached ? 1.0 : 0.0, static_cast<double>(cost.frames), run.cached ? 0 : cost.seconds,
                               run.cached ? 0 : cost.bytes});
  }
  Table table;
  table.add_column({"run", {}, std::move(names)}, std::move(index));
  for (std::size_t k = 0; k < numbers.columns().size(); ++k)
    table.add_column(numbers.columns()[k], {numbers.column(k).begin(), numbers.column(k).end()});
  return table;
}

}  // namespace mdana
