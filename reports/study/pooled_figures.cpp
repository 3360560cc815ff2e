// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/pooled_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "reports/study/plan.hpp"

namespace mdana {
namespace {

using Runs = std::span<const ReportedRun* const>;

std::string label_of(const ReportedRun& run) {
  return std::isfinite(run.velocity()) ? fmt::format("{} (v = {:.3g})", run.name, run.velocity()) : run.name;
}

/// What a reader who does not see it is told.
std::string told(const FigureKind& kind, const std::string& of, const std::vector<Series>& series) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Series& s : series)
    for (const double y : s.y) low = std::min(low, y), high = std::max(high, y);
  return fmt::format("{}{}: {} curve{} or sets of points, from {:.4g} to {:.4g}.", kind.summary, of, series.size(),
                     series.size() == 1 ? "" : "s", low, high);
}

/// Names of groups can be the same as names of files.
Figure with_own_name(Figure figure, const std::vector<Figure>& others) {
  const std::string name = figure.name;
  for (int k = 2; std::ranges::find(others, figure.name, &Figure::name) != others.end(); ++k)
    figure.name = fmt::format("{}-{}", name, k);
  return figure;
}

/// Of the runs that a table of fits over runs is made of: Hertz scenes, or aggregates.
std::optional<Units> units_of_fits(std::string_view table, Runs runs) {
  const Interaction interaction = table == "sizes" ? Interaction::hertz : Interaction::aggregate;
  for (const ReportedRun* run : runs)
    if (run->measured() && run->scene.interaction == interaction) return run->units();
  return std::nullopt;
}

std::vector<const ReportedRun*> of_units(Runs runs, Units units) {
  std::vector<const ReportedRun*> all;
  for (const ReportedRun* run : runs)
    if (run->measured() && run->units() == units) all.push_back(run);
  return all;
}

/// What fitted laws say, if the figure has something measured beside it.
void add_curves(std::string_view kind, const std::string& group, const StudyFits& fits, Figure& figure) {
  if (figure.series.empty()) return;
  for (const LawCurve& curve : fits.curves)
    if (curve.kind == kind && curve.group == group) figure.series.push_back(curve.series);
}

/// The table of all runs that a kind draws.
Table table_of(const FigureKind& kind, Runs runs) {
  if (kind.table == "velocities") return velocities_table(runs);
  std::vector<const ReportedRun*> some;
  for (const ReportedRun* run : runs)
    if (run->aggregate() == (kind.table == "aggregates")) some.push_back(run);
  return runs_table(some);
}

}  // namespace

bool PooledFigures::wants(const FigureKind& kind) const {
  return wanted_.empty() || std::ranges::find(wanted_, kind.name) != wanted_.end();
}

void PooledFigures::add(const ReportedRun& run, const RunRecord& record) {
  snapshots_ = snapshots_ || !record.snapshots.empty();
  for (const FigureKind& kind : figure_kinds()) {
    if (kind.scope != FigureScope::frames || !wants(kind)) continue;
    const Table* table = record.table(kind.table);
    if (!table || !can_draw(kind, *table)) continue;
    const auto [at, fresh] = curves_[std::string(kind.name)].try_emplace({run.group, run.units()});
    Curves& curves = at->second;
    if (fresh) {
      curves.figure = empty_figure(kind, run.units());
      curves.figure.name = fmt::format("{}-{}", kind.name, file_name(run.group));
      curves.figure.title = run.group;
    }
    for (Series& series : series_of(kind, *table, label_of(run))) {
      const bool law = series.style == Series::Style::dashed;
      if (law && std::ranges::find(curves.laws, series.label, &Series::label) != curves.laws.end()) continue;
      if (!law) series.run = run.name;
      (law ? curves.laws : curves.figure.series).push_back(std::move(series));
    }
  }
}

void PooledFigures::finish_points(const FigureKind& kind, Runs runs, const StudyFits& fits) {
  std::set<Units> systems;
  for (const ReportedRun* run : runs)
    if (run->measured()) systems.insert(run->units());
  for (const Units units : systems) {
    const Table table = table_of(kind, of_units(runs, units));
    if (!can_draw(kind, table)) continue;
    Figure figure = empty_figure(kind, units);
    if (systems.size() > 1) figure.name += fmt::format("-{}", name(units));
    const auto groups = std::ranges::find(table.columns(), "group", &ColumnSpec::name);
    for (const std::string& group : groups->labels)
      for (Series& series : series_of(kind, rows_with(table, "group", group), group))
        figure.series.push_back(std::move(series));
    add_curves(kind.name, "", fits, figure);
    figure.alt = told(kind, "", figure.series);
    finished_[std::string(kind.name)].push_back(std::move(figure));
  }
}

std::vector<Figure> PooledFigures::finish(Runs runs, const StudyFits& fits) {
  for (auto& [kind, groups] : curves_)
    for (auto& [group, curves] : groups) {
      for (Series& law : curves.laws) curves.figure.series.push_back(std::move(law));
      add_curves(kind, group.first, fits, curves.figure);
      curves.figure.alt = told(*find_figure_kind(kind), " of " + group.first, curves.figure.series);
      finished_[kind].push_back(std::move(curves.figure));
    }
  std::vector<Figure> all;
  for (const FigureKind& kind : figure_kinds()) {
    if (!wants(kind)) continue;
    const auto table = std::ranges::find(fits.tables, kind.table, &NamedTable::name);
    if (kind.scope == FigureScope::runs) finish_points(kind, runs, fits);
    if (kind.scope == FigureScope::study && table != fits.tables.end() && can_draw(kind, table->table)) {
      Figure figure = empty_figure(kind, units_of_fits(kind.table, runs));
      figure.series = series_of(kind, table->table, std::string(kind.y.front().label));
      figure.alt = told(kind, "", figure.series);
      finished_[std::string(kind.name)].push_back(std::move(figure));
    }
    std::vector<Figure>& figures = finished_[std::string(kind.name)];
    for (Figure& figure : figures) all.push_back(with_own_name(std::move(figure), all));
    if (figures.empty() && !(snapshots_ && kind.name == "snapshots"))
      left_out_.push_back({fmt::format("figure {} ({})", kind.name, kind.papers), std::string(kind.without)});
  }
  return all;
}

}  // namespace mdana
