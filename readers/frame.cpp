// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/frame.hpp"

#include <algorithm>

namespace mdana {

bool FrameHeader::has_column(std::string_view name) const {
  return std::find(columns.begin(), columns.end(), name) != columns.end();
}

}  // namespace mdana
