// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/figure_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/format.h>

namespace mdana {
namespace {

using enum FigureScope;
constexpr auto line = Series::Style::line, dashed = Series::Style::dashed, points = Series::Style::points;

constexpr std::string_view no_spheres = "no run of two spheres was measured";
constexpr std::string_view no_aggregates = "no run of two aggregates was measured";
constexpr std::string_view no_constants = "gamma (scene) or E* (a Hertz run of the same radius) is not known";
constexpr std::string_view no_velocities = "no collision ended within its dump, in a bounce or sticking";
constexpr std::string_view no_runs = "no run was measured";

const FigureKind all_kinds[] = {
    {"force", "force against mutual approach", "P1 2, 3", frames, "frames", {"delta", "mutual approach δ", dimension::length},
     "force F (repulsive > 0)",
     {{"F", "F", dimension::force}, {"F_jkr", "JKR", dimension::force, dashed}, {"F_hertz", "Hertz", dimension::force, dashed}},
     no_spheres},
    {"force-scaled", "force over the pull-off force against mutual approach over δ0", "P1 4", frames, "frames",
     {"delta_over_delta0", "δ/δ0"}, "F/F_c", {{"F_over_F_c", "F/F_c"}}, no_constants},
    {"contact-radius", "contact radius against mutual approach", "P1 6", frames, "frames",
     {"delta", "mutual approach δ", dimension::length}, "contact radius a",
     {{"contact_radius", "a", dimension::length}, {"a_jkr", "JKR", dimension::length, dashed},
      {"a_hertz", "Hertz", dimension::length, dashed}},
     "no contact radius was measured"},
    {"phase-plane", "relative velocity against mutual approach", "P1 12", frames, "frames",
     {"delta", "mutual approach δ", dimension::length}, "dδ/dt", {{"v", "v", dimension::velocity}},
     "no run of two spheres has velocities or times"},
    {"energies", "kinetic energy of relative motion, thermal and potential energy against time", "P1 IV C", frames, "frames",
     {"time", "time", dimension::time}, "energy",
     {{"K_p_rel", "K_p", dimension::energy}, {"K_t", "K_t", dimension::energy}, {"W_change", "W - W(0)", dimension::energy}},
     "no run of two spheres has velocities"},
    {"hertz-fit", "force against distance and its Hertz fit", "P1 14", frames, "fit", {"X", "distance of the centres X", dimension::length},
     "force F", {{"F", "F", dimension::force, points}, {"F_fit", "fit", dimension::force}}, "no Hertz scene was measured"},
    {"non-fcc", "share of inner atoms that are not fcc against mutual approach", "P1 5 (c)", frames, "defects",
     {"delta", "mutual approach δ", dimension::length}, "inner atoms that are not fcc", {{"non_fcc", "share"}},
     "no crystal structure was measured"},
    {"restitution", "coefficient of restitution, RMS over orientations, against velocity, with fitted laws", "P1 7, 8, 11, 13", runs,
     "velocities", {"velocity", "impact velocity", dimension::velocity}, "e", {{"e_rms", "e", {}, points}}, no_velocities},
    {"sticking", "sticking probability against velocity", "P1 9", runs, "velocities",
     {"velocity", "impact velocity", dimension::velocity}, "sticking probability", {{"sticking", "share", {}, points}}, no_velocities},
    {"energy-conversion", "change of thermal and of potential energy against velocity", "P1 10", runs, "runs",
     {"velocity", "impact velocity", dimension::velocity}, "change of energy",
     {{"delta_K_t", "ΔK_t", dimension::energy, points}, {"delta_W", "ΔW", dimension::energy, points}},
     "no run has frames before contact and after the turn"},
    {"modulus-size", "E* against R of the Hertz fits", "P1 Table II", study, "sizes", {"R", "radius R", dimension::length}, "E*",
     {{"E_star", "E*", dimension::pressure, points}}, "no Hertz fit is usable"},
    {"grain-force", "force of two grains by JKR", "P2 1", frames, "grain_law", {"delta", "δ", dimension::length}, "force F",
     {{"F", "JKR", dimension::force}}, "no scene of aggregates states radius, gamma, modulus and Poisson's ratio of the grains"},
    {"compression", "mutual approach of aggregates against time", "P2 4 (a)", frames, "approach", {"time", "time", dimension::time},
     "mutual approach δ", {{"delta", "δ", dimension::length}}, no_aggregates},
    {"approach-speed", "relative velocity of aggregates against time", "P2 4 (b), 12", frames, "approach",
     {"time", "time", dimension::time}, "relative velocity", {{"v_rel", "v_rel", dimension::velocity}}, no_aggregates},
    {"delta-max-size", "greatest compression of aggregates against radius", "P2 5, 6", runs, "aggregates",
     {"R_agg", "R_agg", dimension::length}, "δ_max", {{"delta_max", "δ_max", dimension::length, points}}, no_aggregates},
    {"t-max-size", "time of greatest compression against radius", "P2 7", runs, "aggregates", {"R_agg", "R_agg", dimension::length},
     "t_max", {{"t_max", "t_max", dimension::time, points}}, no_aggregates},
    {"delta-max-velocity", "greatest compression over radius against velocity", "P2 8 (a), 9 (a)", runs, "aggregates",
     {"speed_before", "impact velocity", dimension::velocity}, "δ_max/R_eff", {{"delta_max_over_R_eff", "δ_max/R", {}, points}},
     no_aggregates},
    {"t-max-velocity", "time of greatest compression against velocity", "P2 8 (b), 9 (b)", runs, "aggregates",
     {"speed_before", "impact velocity", dimension::velocity}, "t_max", {{"t_max", "t_max", dimension::time, points}}, no_aggregates},
    {"modulus-yield", "pairs E*, Y of Andrews' law that one δ_max allows", "P2 10", frames, "pairs", {"Y", "Y", dimension::pressure}, "E*",
     {{"E_star", "E*", dimension::pressure}}, "no aggregate's δ_max and velocity are known", true, true},
    {"yield-filling", "yield strength of aggregates against filling factor", "P2 11 (a)", study, "fillings",
     {"phi", "filling factor φ"}, "Y", {{"Y", "Y", dimension::pressure, points}},
     "E* and Y are not determined at any filling factor: runs at several velocities are needed"},
    {"coordination", "coordination number of aggregates against filling factor", "P2 11 (b)", runs, "aggregates",
     {"phi", "filling factor φ"}, "coordination number", {{"coordination", "n_c", {}, points}}, no_aggregates},
    {"work-precision", "error against run time, a curve for each knob and number", "mdana accuracy", file, "accuracy", {"seconds", "run time [s]"},
     "error", {{"error", "error", {}, points}}, "each run has a figure of its own; mdana accuracy writes the table", true, true,
     "curve"},
    {"snapshots", "a slice of the particles at start, maximum compression and end, of each run", "P1 1, 5 (a, b); P2 3, 13", frames, "", {}, "",
     {}, no_runs},
};

/// Values of a column that is there; its errors under NAME_error.
std::vector<double> values_of(const Table& table, const std::string& column) {
  if (!table.has(column)) return {};
  const auto values = table.column(column);
  return {values.begin(), values.end()};
}

/// Least delta that is drawn: that of the contact, and 15 % of its range more. -inf without phases.
double least_drawn(const Table& table, const std::vector<double>& x) {
  if (!table.has("phase")) return -std::numeric_limits<double>::infinity();
  const auto at = std::ranges::find(table.columns(), "phase", &ColumnSpec::name);
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::string& phase = at->labels.at(static_cast<std::size_t>(table.column("phase")[i]));
    if (phase == "loading" || phase == "unloading") least = std::min(least, x[i]), most = std::max(most, x[i]);
  }
  return least <= most ? least - 0.15 * (most - least) : -std::numeric_limits<double>::infinity();
}

/// A law is drawn once, not to and fro with the motion.
void sort_by_x(Series& series) {
  std::vector<std::pair<double, double>> drawn;
  for (std::size_t i = 0; i < series.x.size(); ++i) drawn.emplace_back(series.x[i], series.y[i]);
  std::ranges::sort(drawn);
  for (std::size_t i = 0; i < drawn.size(); ++i) std::tie(series.x[i], series.y[i]) = drawn[i];
}

/// Labels of the points, if the table has a column of that name.
std::vector<std::string> names_of(const Table& table, const char* column) {
  std::vector<std::string> names;
  const auto at = std::ranges::find(table.columns(), column, &ColumnSpec::name);
  if (at == table.columns().end() || at->labels.empty()) return names;
  for (const double index : table.column(column)) names.push_back(at->labels.at(static_cast<std::size_t>(index)));
  return names;
}

/// Several curves of a run have its colour.
Series::Style own_style(std::size_t curve) {
  constexpr std::array styles{line, Series::Style::dotted, Series::Style::dash_dotted};
  return styles[curve % styles.size()];
}

bool has_numbers(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double v) { return std::isfinite(v); });
}

std::string axis(std::string_view label, Dimension dimension, std::optional<Units> units) {
  if (!units || dimension == dimension::none) return std::string(label);
  return fmt::format("{} [{}]", label, symbol(*units, dimension));
}

/// The points of each name, in the order of the table; on logarithmic axes only what is greater than zero.
std::vector<Series> series_by_name(const FigureKind& kind, const Table& table) {
  const auto& names = std::ranges::find(table.columns(), kind.by, &ColumnSpec::name)->labels;
  const auto name = table.column(kind.by), x = table.column(kind.x.column), y = table.column(kind.y.front().column);
  std::vector<Series> all;
  for (const std::string& n : names) all.push_back({n, {}, {}, kind.y.front().style, {}});
  for (std::size_t i = 0; i < y.size(); ++i) {
    const bool drawn = std::isfinite(x[i]) && std::isfinite(y[i]) && (!kind.log_x || x[i] > 0) && (!kind.log_y || y[i] > 0);
    if (!drawn || names.empty()) continue;
    Series& series = all.at(static_cast<std::size_t>(name[i]));
    series.x.push_back(x[i]);
    series.y.push_back(y[i]);
  }
  std::erase_if(all, [](const Series& s) { return s.x.empty(); });
  return all;
}

}  // namespace

std::span<const FigureKind> figure_kinds() { return all_kinds; }

const FigureKind* find_figure_kind(std::string_view name) {
  const auto at = std::ranges::find(all_kinds, name, &FigureKind::name);
  return at == std::end(all_kinds) ? nullptr : &*at;
}

bool can_draw(const FigureKind& kind, const Table& table) {
  if (!has_numbers(values_of(table, std::string(kind.x.column)))) return false;
  return std::ranges::any_of(kind.y, [&](const DrawnColumn& y) {
    return y.style != dashed && has_numbers(values_of(table, std::string(y.column)));
  });
}

std::vector<Series> series_of(const FigureKind& kind, const Table& table, const std::string& label) {
  if (!kind.by.empty() && table.has(kind.by)) return series_by_name(kind, table);
  const std::vector<double> x = values_of(table, std::string(kind.x.column));
  const double least = kind.x.column == "time" ? -std::numeric_limits<double>::infinity() : least_drawn(table, x);
  const auto of_runs = std::ranges::count_if(kind.y, [](const DrawnColumn& y) { return y.style != dashed; });
  const std::vector<std::string> names = names_of(table, "run");
  std::vector<Series> all;
  for (const DrawnColumn& y : kind.y) {
    const std::vector<double> values = values_of(table, std::string(y.column));
    const std::vector<double> errors = values_of(table, std::string(y.column) + "_error");
    if (!has_numbers(values)) continue;
    Series series{y.style == dashed ? std::string(y.label) : of_runs > 1 ? fmt::format("{}, {}", label, y.label) : label,
                  {}, {}, y.style, {}};
    if (y.style == line && of_runs > 1) {
      series.part = y.label;
      series.style = own_style(static_cast<std::size_t>(&y - kind.y.data()));
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!std::isfinite(x[i]) || !std::isfinite(values[i]) || x[i] < least) continue;
      series.x.push_back(x[i]);
      series.y.push_back(values[i]);
      if (!errors.empty()) series.y_error.push_back(errors[i]);
      if (y.style == points && !names.empty()) series.names.push_back(names[i]);
    }
    if (y.style != points) series.y_error.clear();
    if (y.style == dashed) sort_by_x(series);
    all.push_back(std::move(series));
  }
  return all;
}

Figure empty_figure(const FigureKind& kind, std::optional<Units> units) {
  Figure figure;
  figure.name = kind.name;
  figure.title = kind.summary;
  figure.x_label = axis(kind.x.label, kind.x.dimension, units);
  figure.y_label = axis(kind.y_label, kind.y.empty() ? Dimension{} : kind.y.front().dimension, units);
  figure.x_name = kind.x.column;
  if (!kind.y.empty()) figure.y_name = kind.y.front().column;
  figure.log_x = kind.log_x;
  figure.log_y = kind.log_y;
  return figure;
}

}  // namespace mdana
