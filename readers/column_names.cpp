// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/column_names.hpp"

#include <set>
#include <string_view>

#include <fmt/format.h>

#include "readers/shown.hpp"

namespace mdana {

std::string wrong_names(std::span<const std::string> columns) {
  if (columns.size() > most_columns)
    return fmt::format("{} columns (at most {} are read)", columns.size(), most_columns);
  std::set<std::string_view> seen;
  for (const std::string& name : columns) {
    if (name.size() > longest_column_name)
      return fmt::format("the name '{}' of a column has {} bytes (at most {} are read)", shown(name),
                         name.size(), longest_column_name);
    if (!seen.insert(name).second) return fmt::format("column '{}' stands twice", shown(name));
  }
  return {};
}

}  // namespace mdana
