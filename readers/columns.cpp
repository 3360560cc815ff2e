// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/columns.hpp"

#include <algorithm>
#include <array>

#include "readers/selection.hpp"

namespace mdana {

void ColumnSet::add(std::string_view name) {
  const auto place = std::lower_bound(names_.begin(), names_.end(), name);
  if (place == names_.end() || *place != name) names_.emplace(place, name);
}

void ColumnSet::select(const Selection& atoms) {
  selection_ = std::make_shared<const Selection>(atoms);
}

bool ColumnSet::has(std::string_view name) const {
  return std::binary_search(names_.begin(), names_.end(), name, std::less<>{});
}

ColumnKind kind_of_column(std::string_view name) {
  constexpr std::array<std::string_view, 8> integers{"id",     "type", "mol", "proc",
                                                     "procp1", "ix",   "iy",  "iz"};
  constexpr std::array<std::string_view, 2> texts{"element", "typelabel"};
  if (std::ranges::find(integers, name) != integers.end()) return ColumnKind::integer;
  if (std::ranges::find(texts, name) != texts.end()) return ColumnKind::text;
  return ColumnKind::real;
}

}  // namespace mdana
