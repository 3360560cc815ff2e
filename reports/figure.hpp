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
  enum class Style { line, dashed, points } style = Style::line;
  std::vector<double> y_error = {};  ///< of points; empty: none are drawn
  std::string run = {};              ///< that it is of; empty: of no single one
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

/// Columns series, x and y by their names, and y_error if there are any: a row a point.
Table figure_table(const Figure& figure);

/// Writes NAME.gp and NAME.csv into the directory, runs gnuplot for NAME.svg and NAME.pdf and returns the
/// SVG; empty if gnuplot is not installed. The same bytes for the same figure. Throws
/// std::runtime_error if it fails.
std::string draw(const Figure& figure, const std::filesystem::path& directory);

}  // namespace mdana
