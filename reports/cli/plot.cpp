// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/input_error.hpp"
#include "reports/cli/command.hpp"
#include "reports/csv_table.hpp"
#include "reports/figure_kinds.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;
namespace fs = std::filesystem;

void add_options(Options& options) {
  options.add_options()                                                                                     //
      ("list", po::bool_switch(), "list the kinds with their columns and the papers' figures")             //
      ("output,o", po::value<std::string>()->value_name("FILE"), "figure to write (.svg or .pdf); its script and data "
       "are written beside it (.gp, .csv)")                                                                 //
      ("units", po::value<std::string>()->value_name("NAME"), "of the table, for the axes, by LAMMPS' names")  //
      ("title", po::value<std::string>()->value_name("TEXT"), "instead of what the kind shows");
}

/// Where a report has the table that a kind draws.
std::string file_of(const FigureKind& kind) {
  if (kind.scope == FigureScope::file) return fmt::format("FILE.csv of mdana {}", kind.table);
  if (kind.scope == FigureScope::frames) return fmt::format("runs/NAME/{}.csv", kind.table);
  const bool rows = kind.table == "runs" || kind.table == "aggregates";
  return rows ? "results.csv" : fmt::format("tables/{}.csv", kind.table);
}

std::string listed() {
  std::string text;
  for (const FigureKind& kind : figure_kinds()) {
    std::vector<std::string_view> columns;
    for (const DrawnColumn& y : kind.y) columns.push_back(y.column);
    text += fmt::format("{:<20}{} ({})\n", kind.name, kind.summary, kind.papers);
    if (!kind.table.empty())
      text += fmt::format("{:<20}{}: {} against {}\n", "", file_of(kind), fmt::join(columns, ", "), kind.x.column);
  }
  return text + "P1: Yoshida, Kokubo & Tanaka 2024; P2: Arakawa et al. 2024\n";
}

const FigureKind& kind_of(const std::string& name) {
  const FigureKind* kind = find_figure_kind(name);
  if (!kind || kind->table.empty()) throw UsageError(fmt::format("plot {}: no such kind; --list tells all", name));
  return *kind;
}

fs::path output_of(const Values& values) {
  if (!values.count("output")) throw UsageError("-o FILE.svg or FILE.pdf is missing");
  const fs::path output = values["output"].as<std::string>();
  if (output.extension() != ".svg" && output.extension() != ".pdf")
    throw UsageError(fmt::format("-o {}: the name must end in .svg or .pdf", output.string()));
  check_directory(output);
  return output;
}

Figure figure_of(const FigureKind& kind, const std::vector<std::string>& tables, const Values& values) {
  std::optional<Units> units;
  if (values.count("units")) {
    units = parse_units(values["units"].as<std::string>());
    if (!units) throw UsageError(fmt::format("--units: one of {} expected", units_names()));
  }
  Figure figure = empty_figure(kind, units);
  if (values.count("title")) figure.title = values["title"].as<std::string>();
  for (const std::string& file : tables) {
    const Table table = read_csv_table(file);
    if (!can_draw(kind, table)) {
      std::vector<std::string_view> columns;
      for (const DrawnColumn& y : kind.y) columns.push_back(y.column);
      throw InputError(fmt::format("{}: figure {} needs the columns {} and {}, with numbers", file, kind.name, kind.x.column,
                                   fmt::join(columns, " or ")));
    }
    for (Series& series : series_of(kind, table, fs::path(file).stem().string())) figure.series.push_back(std::move(series));
  }
  return figure;
}

int run_command(const Values& values) {
  if (values["list"].as<bool>()) return print(listed()), done;
  if (!values.count("input")) throw UsageError("KIND and TABLE are missing");
  const FigureKind& kind = kind_of(values["input"].as<std::string>());
  if (!values.count("more")) throw UsageError(fmt::format("plot {}: TABLE is missing", kind.name));
  const fs::path output = output_of(values);
  Figure figure = figure_of(kind, values["more"].as<std::vector<std::string>>(), values);
  figure.name = output.stem().string();
  const bool svg = output.extension() == ".svg";
  const fs::path directory = output.parent_path().empty() ? "." : output.parent_path();
  if (draw(figure, directory).empty()) throw std::runtime_error("gnuplot is not installed; script and data are written");
  fs::remove(directory / (figure.name + (svg ? ".pdf" : ".svg")));
  return done;
}

}  // namespace

extern const Command plot_command;
const Command plot_command{
    "plot",
    "[KIND TABLE...]",
    "one figure of tables (CSV), as SVG or PDF",
    "Draws a kind of figure from tables that other commands write (-o FILE.csv), or from those of a report; a table\n"
    "gives a curve or a set of points. --list tells the kinds.",
    "  mdana plot --list\n"
    "  mdana plot force run1/force.csv run2/force.csv -o force.svg --units lj\n"
    "  mdana plot restitution runs-report/tables/velocities.csv -o e.pdf",
    add_options,
    run_command};

}  // namespace mdana::cli
