// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "analyses/analysis.hpp"
#include "analyses/dislocation_lines.hpp"

namespace mdana::defects {

/// line_segments, line_length with line_length_error [length], then of both bodies, of 1 and of 2 the length in each
/// family and its error (perfect_length, perfect_length_error, ..., perfect_length1, perfect_length_error1, ...),
/// line_density1, 2 [1/length^2], short_line_length of pieces below two spacings, unresolved_length beside surfaces and
/// other lattices with unresolved_length_error, not in the others [length], and burgers_residual [lattice constants].
void add_line_columns(std::vector<ColumnSpec>& columns);

/// In the order of these columns; `volume` of bodies 1 and 2 [length^3]. What is left of the row.
std::span<double> fill_lines(const DislocationLines& lines, const std::array<double, 2>& volume, double spacing,
                             std::span<double> row);

}  // namespace mdana::defects
