// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reports/figure.hpp"

namespace mdana {

/// The figure as a small SVG for a page: a study of hundreds of runs has a thousand of them. Curves are kept
/// to 0.15 pixels. Empty if no point has a place on the axes.
std::string page_picture(const Figure& figure);

}  // namespace mdana
