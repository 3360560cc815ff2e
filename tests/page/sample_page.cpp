// SPDX-License-Identifier: GPL-3.0-or-later
// sample_page RUNS OUT.html: a page of made-up runs with all that the page's script can show: a figure that
// compares the runs, error bars, log axes, named points, several curves a run, snapshots, and 3-D views with every family
// of dislocations.
#include <charconv>
#include <cmath>
#include <cstring>
#include <numbers>

#include <fmt/format.h>

#include "page_style.hpp"
#include "reports/atomic_file.hpp"
#include "reports/defect_view.hpp"
#include "reports/live_figure.hpp"
#include "reports/page_script.hpp"
#include "reports/study/run_pictures.hpp"

namespace mdana {
namespace {

std::string run_name(int run) { return fmt::format("run-{:03}", run); }

/// F = (1 + run/10) delta^1.5 loading, three quarters of it unloading.
std::vector<Series> loop(int run, int points) {
  Series loading{"loading", {}, {}}, unloading{"unloading", {}, {}};
  loading.run = unloading.run = run_name(run);
  for (int i = 0; i <= points; ++i) {
    const double delta = 1.0 * i / points, force = (1 + 0.1 * run) * std::pow(delta, 1.5);
    loading.x.push_back(delta);
    loading.y.push_back(force);
    unloading.x.push_back(1 - delta);
    unloading.y.push_back(0.75 * (1 + 0.1 * run) * std::pow(1 - delta, 1.5));
  }
  return {loading, unloading};
}

Figure figure(std::string name, std::string title, std::vector<Series> series) {
  Figure made;
  made.name = std::move(name);
  made.title = std::move(title);
  made.x_label = "mutual approach δ [σ]";
  made.y_label = "force F [ε/σ]";
  made.alt = made.title + ", made up.";
  made.series = std::move(series);
  return made;
}

Figure loops(int runs) {
  std::vector<Series> all;
  for (int run = 0; run < runs; ++run)
    for (Series& s : loop(run, 100)) all.push_back(std::move(s));
  return figure("loops", "Loops of all runs", std::move(all));
}

Figure restitution(int runs) {
  Figure made = figure("restitution", "Restitution over speed", {});
  made.x_label = "speed v [σ/τ]";
  made.y_label = "coefficient of restitution e";
  made.log_x = true;
  for (int run = 0; run < runs; ++run) {
    Series point{"e", {0.01 * std::pow(1.5, run % 20)}, {1 / (1.5 + 0.1 * (run % 20))}, Series::Style::points};
    point.y_error = {0.03};
    point.run = run_name(run);
    point.label = point.run + " (made up)";
    made.series.push_back(std::move(point));
  }
  made.series.push_back({"law", {0.01, 10}, {0.7, 0.3}, Series::Style::dashed});
  return made;
}

std::vector<Eigen::Vector3d> helix(double radius, double height) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 60; ++i)
    points.emplace_back(radius * std::cos(0.1 * i), radius * std::sin(0.1 * i), height + 0.05 * i);
  return points;
}

ViewedFrame viewed(double radius) {
  ViewedFrame frame{fmt::format("radius {}", radius), {{"hcp atoms", "#e0574f", 0.8, {}}}, {}, {}};
  for (int i = 0; i < 2000; ++i) {
    const double z = 1 - 2 * (i + 0.5) / 2000, angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    frame.atoms[0].at.push_back(radius * Eigen::Vector3d(std::sqrt(1 - z * z) * std::cos(angle),
                                                         std::sqrt(1 - z * z) * std::sin(angle), z));
  }
  double height = -radius;
  for (const char* family : {"perfect", "shockley", "stair_rod", "hirth", "frank", "unheard"}) {
    ViewedLine line = viewed_line(family, helix(1.1 * radius, height += radius / 4));
    line.burgers = "1/6[1 1 2]";
    line.length = 6.6 * radius;
    frame.lines.push_back(std::move(line));
  }
  frame.planes.push_back({"intrinsic faults", "#e8862e", 4 * radius * radius,
                          {{-radius, -radius, 0}, {radius, -radius, 0}, {radius, radius, 0}, {-radius, radius, 0}}});
  return frame;
}

/// Two square lattices of atoms within a circle each, `distance` apart.
Snapshot snapshot(const char* label, double distance) {
  Slice slice{1.1, {}};
  for (int i = -10; i <= 10; ++i)
    for (int k = -10; k <= 10; ++k)
      for (const std::size_t body : {0, 1})
        if (std::hypot(i, k) < 10.5) slice.at[body].emplace_back(1.1 * i, 1.1 * k + (body ? 0.5 : -0.5) * distance, 0);
  Snapshot made = snapshot_of(slice);
  made.label = label;
  made.delta = 23 - distance;
  return made;
}

/// A run of a report, with pictures as a report of so many makes them.
std::string pictures(int run, RunPictures& of_all) {
  ReportedRun made;
  made.name = made.file = run_name(run);
  RunRecord record;
  record.document = made.document = {{"units", "lj"}};
  record.snapshots = {snapshot("start", 25), snapshot("maximum compression", 22), snapshot("end", 26)};
  record.views = {viewed(5), viewed(8), viewed(9)};
  record.views[1].label = "maximum compression";
  std::string figures;
  for (const PageFigure& figure : of_all.of(made, record)) figures += figure.html;
  return figures;
}

std::string section(int run, RunPictures& of_all) {
  const std::string run_is = run_name(run);
  std::string figures = pictures(run, of_all);
  for (const char* what : {"force", "contact-radius", "fit", "residuals", "accuracy"})
    figures += live_figure(figure(run_is + "-" + what, run_is + ": " + what, loop(run, 100)));
  return html::section_of(run_is, html::heading(2, run_is) + html::element("div", figures, "class=\"figures\""));
}

/// Points of two groups that know their runs.
Figure sizes(int runs) {
  Figure made = figure("sizes", "Numbers of runs", {});
  for (int group = 0; group < 2; ++group) {
    Series points{fmt::format("group {}", group), {}, {}, Series::Style::points};
    for (int run = group; run < runs; run += 2) {
      points.x.push_back(run);
      points.y.push_back(2.0 * run);
      points.names.push_back(run_name(run));
    }
    made.series.push_back(std::move(points));
  }
  return made;
}

/// Three curves a run.
Figure energies(int runs) {
  Figure made = figure("energies", "Energies of all runs", {});
  const std::pair<const char*, Series::Style> parts[] = {
      {"K_p", Series::Style::line}, {"K_t", Series::Style::dotted}, {"W", Series::Style::dash_dotted}};
  for (int run = 0; run < std::min(runs, 20); ++run)
    for (const auto& [part, style] : parts) {
      const double level = static_cast<double>(style);
      Series curve{run_name(run) + ", " + part, {0, 1, 2}, {level, level + 0.1 * run, level}, style};
      curve.run = run_name(run);
      curve.part = part;
      made.series.push_back(std::move(curve));
    }
  return made;
}

std::string page_of(int runs) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> names;
  for (int run = 0; run < runs; ++run) {
    names.push_back(run_name(run));
    rows.push_back({names.back(), fmt::format("{} ± 0.1 ε/σ", 1 + 0.1 * ((run * 7) % runs))});
  }
  std::string body = html::heading(1, fmt::format("Made-up page of {} runs", runs)) +
                     html::table({"run", "F_max"}, rows) + html::heading(2, "Runs together");
  body += html::element("div",
                        live_figure(loops(runs)) + live_figure(restitution(runs)) + live_figure(sizes(runs)) +
                            live_figure(energies(runs)) +
                            live_view({"defects", "Defects", "Made-up atoms, lines and a plane.", "σ",
                                       {viewed(5), viewed(8)}}),
                        "class=\"figures\"");
  RunPictures of_all(static_cast<std::size_t>(runs));
  for (int run = 0; run < runs; ++run) body += section(run, of_all);
  return html::page("Made-up runs", page_style, body + page_data(names), page_script);
}

}  // namespace
}  // namespace mdana

int main(int count, char** arguments) {
  int runs = 0;
  if (count == 3) std::from_chars(arguments[1], arguments[1] + std::strlen(arguments[1]), runs);
  if (runs < 1) return fmt::print(stderr, "usage: sample_page RUNS OUT.html\n"), 2;
  mdana::write_file(arguments[2], mdana::page_of(runs));
}
