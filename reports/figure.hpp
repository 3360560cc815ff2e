// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analyses/table.hpp"

namespace mdana {

/// A curve or a set of points of a figure.
struct Series {
  std::string label;
  std::vector<double> x, y;
  enum class Style { line, dashed, points, dotted, dash_dotted } style = Style::line;
  std::vector<double> y_error = {};  ///< of points; empty: none are drawn
  std::string run = {};              ///< that it is of; empty: of no single one
  std::string part = {};             ///< which of several curves of the run; else empty
  std::vector<std::string> names = {};  ///< of single points; empty: they have none
};

/// A figure for gnuplot.
struct Figure {
  std::string name;  ///< of its files, without suffix: letters, digits, '-' and '_'
  std::string title, x_label, y_label;
  std::string alt;   ///< what it shows, for those who do not see it
  std::vector<Series> series;
  bool log_x = false, log_y = false;
  std::string x_name = "x", y_name = "y";  ///< of its columns as a table
};

/// The gnuplot script of a figure, data included, that writes NAME.svg and NAME.pdf.
std::string gnuplot_script(const Figure& figure);

/// Runs gnuplot on NAME.gp in the directory, without a shell; a NAME.pdf that it writes does not tell when. False if it
/// is not installed; throws std::runtime_error if it fails.
bool run_gnuplot(const std::filesystem::path& directory, const std::string& name);

/// Columns series, x and y by their names, y_error and the names of points (`point`) if there are any: a row a point.
Table figure_table(const Figure& figure);

/// Writes NAME.gp and NAME.csv into the directory, runs gnuplot for NAME.svg and NAME.pdf and returns the
/// SVG; empty if gnuplot is not installed. The same bytes for the same figure. Throws
/// std::runtime_error if it fails.
std::string draw(const Figure& figure, const std::filesystem::path& directory);

}  // namespace mdana
