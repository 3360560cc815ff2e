// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "reports/plan_document.hpp"
#include "reports/study.hpp"

namespace mdana {

/// Numbers of tasks that a study of so many runs is tried in: 1, 2, 3, 4, 6, 8, 12 ... up to one a run.
std::vector<std::size_t> tried_divisions(std::size_t runs);

/// What the tasks of one division take by the estimates of their runs, one run after another.
struct TaskCosts {
  struct Cost {
    double seconds = 0, processor_seconds = 0, bytes = 0;
  };
  std::vector<Cost> tasks;

  double longest() const;            ///< [s] by the clock
  double processor_seconds() const;  ///< of all
};
TaskCosts costs_of(std::span<const TaskRuns> tasks, std::span<const PlannedOfStudy> runs);

/// A wait in a queue is worth it for that long [s], and tasks are that evenly long, or fewer are better.
inline constexpr double least_task = 60, least_busy = 0.8;

/// Which of the divisions, given in rising order, is sensible: the finest one with tasks of a minute and more in the mean whose
/// longest task leaves the others at work for 80 % of its time; else the first.
std::size_t sensible(std::span<const TaskCosts> divisions);

/// Divisions, the chosen one's tasks with their runs, time, memory and commands.
void add_task_plan(Document& document, std::span<const PlannedOfStudy> runs, std::span<const std::vector<TaskRuns>> divisions,
                   std::size_t chosen, const ReportOptions& options);

/// A row a task: task, runs, besides, seconds, processor_seconds, bytes.
Table task_table(std::span<const TaskRuns> tasks, const TaskCosts& costs);

}  // namespace mdana
