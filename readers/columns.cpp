// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/columns.hpp"

#include <algorithm>
#include <array>

namespace mdana {

void ColumnSet::add(std::string_view name) {
  const auto place = std::lower_bound(names_.begin(), names_.end(), name);
  if (place == names_.end() || *place != name) names_.emplace(place, name);
}

bool ColumnSet::has(std::string_view name) const {
  return std::binary_search(names_.begin(), names_.end(), name, std::less<>{});
}

bool is_integer_column(std::string_view name) {
  constexpr std::array<std::string_view, 8> integers{"id",     "type", "mol", "proc",
                                                     "procp1", "ix",   "iy",  "iz"};
  return std::find(integers.begin(), integers.end(), name) != integers.end();
}

}  // namespace mdana
