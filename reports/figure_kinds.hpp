// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "readers/units.hpp"
#include "reports/figure.hpp"

namespace mdana {

/// A column of a table that a figure draws.
struct DrawnColumn {
  std::string_view column, label;
  Dimension dimension = {};
  Series::Style style = Series::Style::line;  ///< dashed: a law, drawn once
};

/// What of a study a figure is of.
enum class FigureScope {
  frames,  ///< a curve for each run of a group; one figure a group
  runs,    ///< a point for each run or velocity; one series a group
  study,   ///< one table of all runs
  file     ///< a table of a command, which no report has
};

/// A figure that shows several runs together: some column of a table against another one.
struct FigureKind {
  std::string_view name;     ///< "force"
  std::string_view summary;  ///< "force against mutual approach, loading and unloading"
  std::string_view papers;   ///< figures of the papers that show the same; P1, P2 as below
  FigureScope scope;
  std::string_view table;    ///< of a run or of the study that has the columns; empty: no table has
  DrawnColumn x;
  std::string_view y_label;
  std::vector<DrawnColumn> y;  ///< NAME_error, if there is one, are its errors
  std::string_view without;    ///< what a study without the figure lacks
  bool log_x = false, log_y = false;
  std::string_view by = {};    ///< column of names: a series for each of them
};

/// All kinds: the figures of Yoshida, Kokubo & Tanaka 2024 (P1) and Arakawa et al. 2024 (P2).
std::span<const FigureKind> figure_kinds();

/// Null if there is none of that name.
const FigureKind* find_figure_kind(std::string_view name);

/// Whether a table has the x and at least one y of a kind, with numbers.
bool can_draw(const FigureKind& kind, const Table& table);

/// A series for each y that the table has, and for each name in the column `by` of the kind. A label for several is followed by the column's. Of motions the
/// frames far from contact are left out.
std::vector<Series> series_of(const FigureKind& kind, const Table& table, const std::string& label);

/// Title and axes; units if they are known.
Figure empty_figure(const FigureKind& kind, std::optional<Units> units);

}  // namespace mdana
