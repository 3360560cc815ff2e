// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/plan.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "readers/column_choice.hpp"
#include "reports/plan_rules.hpp"

namespace mdana {
namespace {

const Rule& rule_of(Part part) { return *std::ranges::find(plan_rules(), part, &Rule::part); }

struct CommandParts {
  std::string_view command;
  std::vector<Part> parts;
};

const std::array commands{
    CommandParts{"force", {Part::force, Part::restitution, Part::rotation}},
    CommandParts{"contact-radius", {Part::contact_radius, Part::contact_areas, Part::jkr}},
    CommandParts{"energy", {Part::energies, Part::potential_energy}},
    CommandParts{"fit-hertz", {Part::force, Part::hertz_fit}},
    CommandParts{"collision", {Part::force, Part::restitution, Part::contact_radius, Part::contact_areas, Part::plasticity,
                               Part::rotation, Part::energies, Part::potential_energy, Part::jkr}},
    CommandParts{"surface-energy", {Part::surface_energy}},
    CommandParts{"defects", {Part::structure, Part::dislocations}},
    CommandParts{"compress", {Part::force, Part::restitution, Part::compression, Part::coordination}},
    CommandParts{"network", {Part::network}},
};

/// As the dump names them, those of bodies and masses with them.
std::vector<std::string> names_in(const Run& run, ColumnSet wanted) {
  wanted.add(run.bodies.columns());
  wanted.add(run.masses.columns());
  const ColumnChoice choice(run.first, wanted);
  std::vector<std::string> names;
  for (const auto& column : choice.columns()) names.push_back(column.name);
  return names;
}

/// Those that a better one makes needless, or that the dump does not have.
void leave_out_other_sources(const Asked& asked, Plan& plan) {
  const ForceSource best = asked.source();
  for (const ForceSource other : {ForceSource::forces, ForceSource::velocities, ForceSource::positions})
    if (other != best)
      plan.left_out.push_back({fmt::format("force from {}", name(other)),
                               asked.wishes.source ? fmt::format("--source {}", name(best))
                               : other < best      ? "not in the dump"
                                                   : fmt::format("the dump has {}, which are better", name(best))});
}

void consider(const Rule& rule, const Run& run, const PlanWishes& wishes, Plan& plan) {
  const Asked asked{run, wishes};
  std::string reason = wishes.insist ? std::string() : rule.not_needed(asked);
  if (reason.empty()) reason = rule.obstacle(asked);
  if (reason.empty() && !wishes.insist && !rule.command.empty())
    reason = fmt::format("a report does not tell it of every frame; mdana {} does", rule.command);
  if (!reason.empty()) return plan.left_out.push_back({std::string(rule.name), reason});
  plan.computed.push_back({rule.part, names_in(run, rule.columns(asked)), rule.reason(asked)});
}

}  // namespace

std::string_view name(Part part) { return rule_of(part).name; }

bool Plan::has(Part part) const { return std::ranges::find(computed, part, &PlannedPart::part) != computed.end(); }

void Plan::leave_out(Part part, const std::string& reason) {
  const bool planned = std::erase_if(computed, [&](const PlannedPart& p) { return p.part == part; }) > 0;
  if (planned) left_out.push_back({std::string(name(part)), reason});
}

void Plan::settle(const Restitution& restitution, Outcome outcome) {
  if (!restitution.reason.empty()) return leave_out(Part::restitution, restitution.reason);
  if (outcome == Outcome::stick && has(Part::restitution))
    left_out.push_back({"speed after the collision", "the bodies stick: e = 0 without it"});
}

std::optional<std::vector<Part>> parts_of(std::string_view command) {
  if (command == "report" || command == "all") {
    std::vector<Part> all;
    for (const Rule& rule : plan_rules()) all.push_back(rule.part);
    return all;
  }
  const auto at = std::ranges::find(commands, command, &CommandParts::command);
  if (at == commands.end()) return std::nullopt;
  return at->parts;
}

std::vector<std::string_view> planned_commands() {
  std::vector<std::string_view> names{"report"};
  for (const CommandParts& c : commands) names.push_back(c.command);
  return names;
}

Plan plan_run(const Run& run, const PlanWishes& wishes) {
  Plan plan;
  for (const Rule& rule : plan_rules())
    if (std::ranges::find(wishes.parts, rule.part) != wishes.parts.end()) consider(rule, run, wishes, plan);
  if (plan.has(Part::force)) leave_out_other_sources({run, wishes}, plan);
  return plan;
}

Plan plan_command(const Run& run, std::string_view command, PlanWishes wishes) {
  wishes.parts = parts_of(command).value();
  wishes.insist = true;
  return plan_run(run, wishes);
}

std::string obstacle(Part part, const Run& run, const PlanWishes& wishes) { return rule_of(part).obstacle({run, wishes}); }

std::string not_needed(Part part, const Run& run, const PlanWishes& wishes) {
  return rule_of(part).not_needed({run, wishes});
}

void add_plan(Document& document, const Plan& plan) {
  auto computed = nlohmann::ordered_json::array();
  for (const PlannedPart& p : plan.computed)
    computed.push_back({{"what", name(p.part)}, {"columns", p.columns}, {"reason", p.reason}});
  document.json("computed", std::move(computed));
  for (const LeftOut& l : plan.left_out) document.left_out(l.what, l.reason);
}

}  // namespace mdana
