// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "readers/columns.hpp"
#include "readers/frame.hpp"

namespace mdana::h5md {

/// Columns of a frame that are written as one element.
struct ColumnGroup {
  std::string element;
  std::vector<std::string> columns;
  ColumnKind kind;
};

/// The elements that the columns make, `position` first. Throws InputError if there are no unscaled
/// positions or a column's name cannot be an element's.
std::vector<ColumnGroup> column_groups(const FrameHeader& frame);

}  // namespace mdana::h5md
