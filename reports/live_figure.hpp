// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "reports/figure.hpp"

namespace mdana {

/// What the script of the page draws: {title, alt, x: {label, log}, y: {label, log}, series: [{label, run,
/// style: line | dashed | points | dotted | dash-dotted, x, y, y_error, names}]}; six digits, null where there is no number.
nlohmann::ordered_json figure_json(const Figure& figure);

/// The figure for a page: its picture, caption and, where the page has a script, its data as the block
/// figure-NAME. Names of the figures of a page differ.
std::string live_figure(const Figure& figure);

/// The block page-data, {runs: [names]}, by which the script links figures and tables; empty without one.
std::string page_data(const std::vector<std::string>& runs);

}  // namespace mdana
