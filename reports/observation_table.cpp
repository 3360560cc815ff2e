// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/input_error.hpp"
#include "reports/observations.hpp"

namespace mdana {
namespace {

constexpr double certain = 5;  ///< standard errors by which e may exceed 1

constexpr std::string_view seen_columns[] = {"e", "sigma", "outcome", "delta_max", "delta_max_error",
                                             "t_max", "t_max_error"};

/// Names of all numbers that some law is computed from.
std::set<std::string, std::less<>> parameter_names() {
  std::set<std::string, std::less<>> names;
  for (const CollisionParameter& p : impact_parameters()) names.emplace(p.name);
  for (const CollisionLaw* law : collision_laws())
    for (const CollisionParameter& p : law->parameters)
      if (p.words.empty()) names.emplace(p.name);
  return names;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t comma = std::min(line.find(',', from), line.size());
    cells.push_back(trimmed(line.substr(from, comma - from)));
    from = comma + 1;
  }
  return cells;
}

/// A table that is being read: where, and under which names.
class CollisionTable {
 public:
  explicit CollisionTable(std::string file) : file_(std::move(file)) {}

  void take(std::string_view line) {
    ++line_;
    if (line_ == 1 && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) return;
    if (names_.empty())
      take_names(line);
    else
      take_row(cells_of(line));
  }

  std::vector<ObservedCollision> finish() {
    if (names_.empty()) throw InputError(file_ + ": empty: a line with the names of the columns is expected");
    if (seen_.empty()) throw InputError(file_ + ": no collisions below the line with the names of the columns");
    return std::move(seen_);
  }

 private:
  std::string place() const { return fmt::format("{}:{}", file_, line_); }

  template <class... Args>
  [[noreturn]] void refuse(fmt::format_string<Args...> text, Args&&... args) const {
    throw InputError(place() + ": " + fmt::format(text, std::forward<Args>(args)...));
  }

  void take_names(std::string_view line) {
    for (const std::string_view name : cells_of(line)) {
      const bool seen = std::ranges::find(seen_columns, name) != std::end(seen_columns);
      if (!seen && !parameters_.contains(name))
        refuse("unknown column '{}'; columns are {}, and parameters of the laws: {}", name,
               fmt::join(seen_columns, ", "), fmt::join(parameters_, ", "));
      if (std::ranges::find(names_, name) != names_.end()) refuse("column {} stands twice", name);
      names_.emplace_back(name);
    }
    for (const auto& [error, of] : {std::pair{"sigma", "e"}, {"delta_max_error", "delta_max"}, {"t_max_error", "t_max"}})
      if (has(error) && !has(of)) refuse("column {} is of {}, which is missing", error, of);
    if (!has("v")) refuse("column v (relative velocity at delta = 0) is missing");
    if (!has("e") && !has("outcome") && !has("delta_max") && !has("t_max"))
      refuse("nothing that was seen: one of the columns e, outcome, delta_max and t_max is needed");
  }

  bool has(std::string_view name) const { return std::ranges::find(names_, name) != names_.end(); }

  /// A cell's text; empty if there is no such column.
  std::string_view cell(std::span<const std::string_view> cells, std::string_view name) const {
    const auto at = std::ranges::find(names_, name);
    return at == names_.end() ? std::string_view() : cells[static_cast<std::size_t>(at - names_.begin())];
  }

  double number(std::string_view name, std::string_view text) const {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
      refuse("{} is '{}': a number is expected", name, text);
    const bool wall = (name == "R2" || name == "m2") && value > 0;
    if (std::isnan(value) || (std::isinf(value) && !wall)) refuse("{} is {}: a finite number is expected", name, text);
    return value;
  }

  /// A number > 0 with its error > 0, either may be missing.
  Measured measured(std::span<const std::string_view> cells, std::string_view name, std::string_view error) const {
    Measured m;
    if (const auto text = cell(cells, name); !text.empty()) m.value = number(name, text);
    if (const auto text = cell(cells, error); !text.empty()) m.error = number(error, text);
    if (m.value < 0) refuse("{} is {:g}: it cannot be negative", name, m.value);
    if (m.error <= 0) refuse("{} is {:g}: a standard error is greater than 0", error, m.error);
    return m;
  }

  /// Whether the spheres stuck, from the outcome and e.
  bool sticking(std::string_view outcome, const Measured& e) const {
    if (outcome == "unresolved") refuse("the outcome is unresolved: such a collision tells nothing; leave it out");
    if (!outcome.empty() && outcome != "stick" && outcome != "bounce")
      refuse("outcome is '{}': stick or bounce is expected", outcome);
    if (outcome == "stick" && e.value > 0) refuse("outcome is stick, but e is {:g}", e.value);
    if (outcome == "bounce" && e.value == 0) refuse("outcome is bounce, but e is 0");
    if (!outcome.empty()) return outcome == "stick";
    return has("e") && !(e.value > 0);
  }

  void take_row(const std::vector<std::string_view>& cells) {
    if (cells.size() != names_.size())
      refuse("{} cells (the line of names has {})", cells.size(), names_.size());
    ObservedCollision c;
    c.place = place();
    c.e = measured(cells, "e", "sigma");
    c.delta_max = measured(cells, "delta_max", "delta_max_error");
    c.t_max = measured(cells, "t_max", "t_max_error");
    if (c.e.value > 1 + certain * (c.e.error > 0 ? c.e.error : 0))
      refuse("e is {:g}: more speed after the collision than before", c.e.value);
    for (const auto& [name, m] : {std::pair{"delta_max", &c.delta_max}, {"t_max", &c.t_max}})
      if (m->value == 0) refuse("{} is 0: it is greater than 0, or unknown (empty)", name);
    c.stuck = sticking(cell(cells, "outcome"), c.e);
    if (c.stuck) c.e.value = 0;
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (parameters_.contains(names_[k]) && !cells[k].empty()) c.given.push_back({names_[k], number(names_[k], cells[k])});
    if (!c.find("v")) refuse("v is missing");
    if (!c.stuck && !c.e.known() && !c.delta_max.known() && !c.t_max.known())
      refuse("nothing was seen: e, delta_max and t_max are empty");
    seen_.push_back(std::move(c));
  }

  std::string file_;
  std::set<std::string, std::less<>> parameters_ = parameter_names();
  std::size_t line_ = 0;
  std::vector<std::string> names_;
  std::vector<ObservedCollision> seen_;
};

}  // namespace

std::vector<ObservedCollision> parse_collision_table(std::string_view text, const std::string& place) {
  CollisionTable table(place);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    table.take(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return table.finish();
}

}  // namespace mdana
