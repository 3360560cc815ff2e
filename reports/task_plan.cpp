// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/task_plan.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> names(std::span<const PlannedOfStudy> runs, const std::vector<std::size_t>& chosen) {
  std::vector<std::string> all;
  for (const std::size_t k : chosen) all.push_back(runs[k].name);
  return all;
}

/// How much of M times the longest task the tasks are at work with what one process would do.
double busy(const TaskCosts& costs, const TaskCosts& one) {
  const double room = static_cast<double>(costs.tasks.size()) * costs.longest();
  return room > 0 ? one.longest() / room : 1;
}

Json run_json(const PlannedOfStudy& run) {
  Json json{{"name", run.name}, {"cached", run.cached}};
  if (!run.failure.empty()) json["failure"] = run.failure;
  const bool known = run.failure.empty() && !run.cached;
  json["seconds"] = known ? run.planned.cost.seconds : 0;
  json["bytes"] = known ? run.planned.cost.bytes : 0;
  return json;
}

Json task_json(const TaskRuns& task, const TaskCosts::Cost& cost, std::span<const PlannedOfStudy> runs, const ReportOptions& options) {
  return {{"task", task.choice.task}, {"of", task.choice.of}, {"runs", names(runs, task.runs)}, {"besides", names(runs, task.besides)},
          {"seconds", cost.seconds}, {"processor_seconds", cost.processor_seconds}, {"bytes", cost.bytes},
          {"command", command_of(options, task.choice)}};
}

std::string task_line(const TaskRuns& task, const TaskCosts::Cost& cost, std::span<const PlannedOfStudy> runs) {
  std::string text = fmt::format("{:>8} {:>7}  {}", time_text(cost.seconds), bytes_text(cost.bytes), fmt::join(names(runs, task.runs), ", "));
  if (task.runs.empty()) text += "nothing";
  if (!task.besides.empty()) text += fmt::format(" (besides, for E* and R: {})", fmt::join(names(runs, task.besides), ", "));
  return text;
}

}  // namespace

std::vector<std::size_t> tried_divisions(std::size_t runs) {
  std::vector<std::size_t> all{1};
  for (std::size_t m = 2; m <= runs; m *= 2) {
    all.push_back(m);
    if (m + m / 2 <= runs) all.push_back(m + m / 2);
  }
  return all;
}

double TaskCosts::longest() const {
  return tasks.empty() ? 0 : std::ranges::max_element(tasks, {}, &Cost::seconds)->seconds;
}

double TaskCosts::processor_seconds() const {
  double sum = 0;
  for (const Cost& cost : tasks) sum += cost.processor_seconds;
  return sum;
}

TaskCosts costs_of(std::span<const TaskRuns> tasks, std::span<const PlannedOfStudy> runs) {
  TaskCosts costs;
  for (const TaskRuns& task : tasks) {
    TaskCosts::Cost& cost = costs.tasks.emplace_back();
    for (const auto* list : {&task.runs, &task.besides})
      for (const std::size_t k : *list) {
        if (runs[k].cached || !runs[k].failure.empty()) continue;
        cost.seconds += runs[k].planned.cost.seconds;
        cost.processor_seconds += runs[k].planned.cost.processor_seconds;
        cost.bytes = std::max(cost.bytes, runs[k].planned.cost.bytes);
      }
  }
  return costs;
}

std::size_t sensible(std::span<const TaskCosts> divisions) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < divisions.size(); ++k) {
    const double mean = divisions[0].longest() / static_cast<double>(divisions[k].tasks.size());
    if (mean >= least_task && busy(divisions[k], divisions[0]) >= least_busy) best = k;
  }
  return best;
}

void add_task_plan(Document& document, std::span<const PlannedOfStudy> runs, std::span<const std::vector<TaskRuns>> divisions,
                   std::size_t chosen, const ReportOptions& options) {
  Json list = Json::array(), all = Json::array(), tasks = Json::array();
  for (const PlannedOfStudy& run : runs) list.push_back(run_json(run));
  document.json("runs", std::move(list));
  std::vector<TaskCosts> costs;
  for (const auto& division : divisions) costs.push_back(costs_of(division, runs));
  document.line("divisions", " longest  at work");
  for (const TaskCosts& c : costs) {
    all.push_back({{"of", c.tasks.size()}, {"seconds", c.longest()}, {"processor_seconds", c.processor_seconds()}, {"busy", busy(c, costs[0])}});
    document.line(fmt::format("  {} task{}", c.tasks.size(), c.tasks.size() == 1 ? "" : "s"),
                  fmt::format("{:>8} {:>7.0f} %", time_text(c.longest()), 100 * busy(c, costs[0])));
  }
  const std::size_t best = costs[sensible(costs)].tasks.size();
  document.json("divisions", std::move(all));
  document.json("sensible", best);
  document.line("sensible", fmt::format("{} task{}: the most of a minute and more in the mean that are at work for {:.0f} % of the longest",
                                        best, best == 1 ? "" : "s", 100 * least_busy));
  const std::vector<TaskRuns>& division = divisions[chosen];
  document.line("tasks", "    time  memory  runs");
  for (std::size_t k = 0; k < division.size(); ++k) {
    tasks.push_back(task_json(division[k], costs[chosen].tasks[k], runs, options));
    document.line(fmt::format("  {} of {}", k + 1, division.size()), task_line(division[k], costs[chosen].tasks[k], runs));
  }
  document.json("of", division.size());
  document.json("tasks", std::move(tasks));
  for (const PlannedOfStudy& run : runs)
    if (!run.failure.empty()) document.line("fails", fmt::format("{}: {}", run.name, run.failure));
}

Table task_table(std::span<const TaskRuns> tasks, const TaskCosts& costs) {
  Table table({{"task", {}}, {"runs", {}}, {"besides", {}}, {"seconds", {}}, {"processor_seconds", {}}, {"bytes", {}}});
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const TaskCosts::Cost& cost = costs.tasks[k];
    table.add_row(std::array{static_cast<double>(k + 1), static_cast<double>(tasks[k].runs.size()),
                             static_cast<double>(tasks[k].besides.size()), cost.seconds, cost.processor_seconds, cost.bytes});
  }
  return table;
}

}  // namespace mdana
