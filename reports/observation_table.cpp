// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
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

void check_names(const CsvText& table, const std::set<std::string, std::less<>>& parameters) {
  const std::string& place = table.names_place;
  for (const std::string_view name : table.names)
    if (std::ranges::find(seen_columns, name) == std::end(seen_columns) && !parameters.contains(name))
      throw InputError(fmt::format("{}: unknown column '{}'; columns are {}, and parameters of the laws: {}", place, name,
                                   fmt::join(seen_columns, ", "), fmt::join(parameters, ", ")));
  for (const auto& [error, of] : {std::pair{"sigma", "e"}, {"delta_max_error", "delta_max"}, {"t_max_error", "t_max"}})
    if (table.has(error) && !table.has(of))
      throw InputError(fmt::format("{}: column {} is of {}, which is missing", place, error, of));
  if (!table.has("v")) throw InputError(place + ": column v (relative velocity at delta = 0) is missing");
  if (!table.has("e") && !table.has("outcome") && !table.has("delta_max") && !table.has("t_max"))
    throw InputError(place + ": nothing that was seen: one of the columns e, outcome, delta_max and t_max is needed");
}

/// One line of a table.
class CollisionRow {
 public:
  CollisionRow(const CsvText& table, const CsvText::Row& row) : table_(table), row_(row) {}

  ObservedCollision read(const std::set<std::string, std::less<>>& parameters) const {
    ObservedCollision c;
    c.place = row_.place;
    c.e = measured("e", "sigma");
    c.delta_max = measured("delta_max", "delta_max_error");
    c.t_max = measured("t_max", "t_max_error");
    check(c);
    c.stuck = sticking(table_.cell(row_, "outcome"), c.e);
    if (c.stuck) c.e.value = 0;
    for (std::size_t k = 0; k < table_.names.size(); ++k)
      if (parameters.contains(table_.names[k]) && !row_.cells[k].empty())
        c.given.push_back({std::string(table_.names[k]), number(table_.names[k], row_.cells[k])});
    if (!c.find("v")) refuse("v is missing");
    if (!c.stuck && !c.e.known() && !c.delta_max.known() && !c.t_max.known())
      refuse("nothing was seen: e, delta_max and t_max are empty");
    return c;
  }

 private:
  template <class... Args>
  [[noreturn]] void refuse(fmt::format_string<Args...> text, Args&&... args) const {
    throw InputError(row_.place + ": " + fmt::format(text, std::forward<Args>(args)...));
  }

  double number(std::string_view name, std::string_view text) const {
    const double value = csv_number(text, name, row_.place);
    const bool wall = (name == "R2" || name == "m2") && value > 0;
    if (std::isnan(value) || (std::isinf(value) && !wall)) refuse("{} is {}: a finite number is expected", name, text);
    return value;
  }

  /// A number > 0 with its error > 0, either may be missing.
  Measured measured(std::string_view name, std::string_view error) const {
    Measured m;
    if (const auto text = table_.cell(row_, name); !text.empty()) m.value = number(name, text);
    if (const auto text = table_.cell(row_, error); !text.empty()) m.error = number(error, text);
    if (m.value < 0) refuse("{} is {:g}: it cannot be negative", name, m.value);
    if (m.error <= 0) refuse("{} is {:g}: a standard error is greater than 0", error, m.error);
    return m;
  }

  void check(const ObservedCollision& c) const {
    if (c.e.value > 1 + certain * (c.e.error > 0 ? c.e.error : 0))
      refuse("e is {:g}: more speed after the collision than before", c.e.value);
    for (const auto& [name, m] : {std::pair{"delta_max", &c.delta_max}, {"t_max", &c.t_max}})
      if (m->value == 0) refuse("{} is 0: it is greater than 0, or unknown (empty)", name);
  }

  /// Whether the spheres stuck, from the outcome and e.
  bool sticking(std::string_view outcome, const Measured& e) const {
    if (outcome == "unresolved") refuse("the outcome is unresolved: such a collision tells nothing; leave it out");
    if (!outcome.empty() && outcome != "stick" && outcome != "bounce")
      refuse("outcome is '{}': stick or bounce is expected", outcome);
    if (outcome == "stick" && e.value > 0) refuse("outcome is stick, but e is {:g}", e.value);
    if (outcome == "bounce" && e.value == 0) refuse("outcome is bounce, but e is 0");
    if (!outcome.empty()) return outcome == "stick";
    return table_.has("e") && !(e.value > 0);
  }

  const CsvText& table_;
  const CsvText::Row& row_;
};

}  // namespace

std::vector<ObservedCollision> observed_collisions(const CsvText& table) {
  const auto parameters = parameter_names();
  check_names(table, parameters);
  std::vector<ObservedCollision> seen;
  for (const CsvText::Row& row : table.rows) seen.push_back(CollisionRow(table, row).read(parameters));
  return seen;
}

}  // namespace mdana
