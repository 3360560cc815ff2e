// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

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
};

/// The gnuplot script of a figure, data included, that writes NAME.svg.
std::string gnuplot_script(const Figure& figure);

/// Writes NAME.gp into the directory, runs gnuplot on it and returns the SVG it makes; empty if
/// gnuplot is not installed. Throws std::runtime_error if it fails.
std::string draw(const Figure& figure, const std::filesystem::path& directory);

}  // namespace mdana
