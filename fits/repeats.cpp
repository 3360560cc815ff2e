// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/repeats.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mdana {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t own_scatter = 5;  ///< repeats whose standard deviation is right to 35 %

using Groups = std::vector<std::vector<std::size_t>>;

bool same(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance * std::max(a, b); }

std::vector<double> known_values(std::span<const ObservedCollision> seen, const std::vector<std::size_t>& group,
                                 Measured ObservedCollision::* quantity) {
  std::vector<double> values;
  for (const std::size_t i : group)
    if ((seen[i].*quantity).known()) values.push_back((seen[i].*quantity).value);
  return values;
}

/// Standard deviation relative to the means of all groups together; NaN without repeats.
double pooled_scatter(std::span<const ObservedCollision> seen, const Groups& groups,
                      Measured ObservedCollision::* quantity) {
  double squares = 0;
  std::size_t freedom = 0;
  for (const auto& group : groups) {
    const Scatter s = scatter_of(known_values(seen, group, quantity));
    if (s.count < 2) continue;
    const double relative = s.deviation / s.mean;
    squares += relative * relative * static_cast<double>(s.count - 1);
    freedom += s.count - 1;
  }
  return freedom > 0 ? std::sqrt(squares / static_cast<double>(freedom)) : unknown;
}

void set_errors(std::span<ObservedCollision> seen, const Groups& groups,
                Measured ObservedCollision::* quantity) {
  const double pooled = pooled_scatter(seen, groups, quantity);
  for (const auto& group : groups) {
    const Scatter s = scatter_of(known_values(seen, group, quantity));
    const double scatter = s.count >= own_scatter ? s.deviation : pooled * s.mean;
    for (const std::size_t i : group) {
      Measured& m = seen[i].*quantity;
      m.error = std::hypot(scatter, m.error > 0 ? m.error : 0);
    }
  }
}

bool errors_known(const ObservedCollision& seen) {
  return (!seen.delta_max.known() || seen.delta_max.error > 0) && (!seen.t_max.known() || seen.t_max.error > 0);
}

}  // namespace

std::vector<std::vector<std::size_t>> repeats_of(std::span<const ObservedCollision> seen) {
  Groups groups;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto group = std::ranges::find_if(groups, [&](const std::vector<std::size_t>& g) {
      const ObservedCollision& first = seen[g.front()];
      return same(*first.find("R"), *seen[i].find("R"), same_radius_of_runs) &&
             same(*first.find("v"), *seen[i].find("v"), same_velocity_of_runs);
    });
    if (group == groups.end())
      groups.push_back({i});
    else
      group->push_back(i);
  }
  return groups;
}

Scatter scatter_of(std::span<const double> values) {
  Scatter s{0, unknown, values.size()};
  const auto n = static_cast<double>(values.size());
  for (const double v : values) s.mean += v / n;
  if (values.empty()) s.mean = unknown;
  if (values.size() < 2) return s;
  double squares = 0;
  for (const double v : values) squares += (v - s.mean) * (v - s.mean);
  s.deviation = std::sqrt(squares / (n - 1));
  return s;
}

bool set_errors_by_repeats(std::span<ObservedCollision> seen) {
  const Groups groups = repeats_of(seen);
  for (const auto quantity : {&ObservedCollision::delta_max, &ObservedCollision::t_max})
    set_errors(seen, groups, quantity);
  if (std::ranges::all_of(seen, errors_known)) return true;
  for (ObservedCollision& s : seen) s.delta_max.error = s.t_max.error = unknown;
  return false;
}

}  // namespace mdana
