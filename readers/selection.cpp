// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/selection.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

[[noreturn]] void unclear(const std::string& text) {
  throw InputError(
      fmt::format("selection '{}': COLUMN:RANGES expected, as type:1-2 or id:1-500,900", text));
}

std::int64_t number(std::string_view part, const std::string& text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
  if (error != std::errc{} || end != part.data() + part.size()) unclear(text);
  return value;
}

}  // namespace

Selection::Selection(const std::string& text) : text_(text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) unclear(text);
  column_ = text.substr(0, colon);
  if (kind_of_column(column_) != ColumnKind::integer) unclear(text);
  std::string_view rest = std::string_view(text).substr(colon + 1);
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const std::string_view part = rest.substr(0, comma);
    const std::size_t dash = part.find('-', 1);  // the first character may be a sign
    const std::int64_t first = number(part.substr(0, dash), text);
    const std::int64_t last =
        dash == std::string_view::npos ? first : number(part.substr(dash + 1), text);
    if (last < first) unclear(text);
    ranges_.push_back({first, last});
    more = comma != std::string_view::npos;
    if (more) rest.remove_prefix(comma + 1);
  }
}

bool Selection::holds(std::int64_t value) const {
  return std::ranges::any_of(
      ranges_, [&](const Range& r) { return r.first <= value && value <= r.last; });
}

void Selection::apply(AtomBlock& block) const {
  const auto values = block.integer(column_);
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (holds(values[i])) chosen.push_back(static_cast<std::uint32_t>(i));
  if (chosen.size() < values.size()) block.keep(chosen);
}

}  // namespace mdana
