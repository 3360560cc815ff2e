// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_hysteresis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "analyses/force_curve.hpp"
#include "analyses/turning_points.hpp"

namespace mdana {
namespace {

/// Frames of the first loading and the unloading after it.
std::optional<Cycle> first_cycle(const std::vector<double>& delta,
                                 const std::vector<double>& radius) {
  const auto touch = static_cast<std::size_t>(
      std::find_if(radius.begin(), radius.end(), [](double a) { return a > 0; }) - radius.begin());
  if (touch == radius.size()) return std::nullopt;
  const double rise = *std::max_element(delta.begin(), delta.end()) - delta[touch];
  std::optional<Cycle> cycle;
  std::size_t start = 0;
  for (const Turn& turn : turning_points(delta, turning_point_fraction * rise)) {
    if (!turn.maximum && !cycle) start = turn.index;
    if (!turn.maximum && cycle) return Cycle{cycle->start, cycle->turn, turn.index};
    if (turn.maximum && turn.index >= touch) cycle = Cycle{start, turn.index, delta.size() - 1};
  }
  return cycle;
}

struct Point {
  double radius, error;
};

/// Loading at a delta, in the last step of the branch that covers it.
std::optional<Point> loading_at(double d, const Cycle& cycle, const std::vector<double>& delta,
                                const std::vector<double>& radius,
                                const std::vector<double>& error) {
  for (std::size_t i = cycle.turn; i > cycle.start; --i) {
    if (!(delta[i - 1] <= d && d <= delta[i])) continue;
    const double width = delta[i] - delta[i - 1];
    const double t = width > 0 ? (d - delta[i - 1]) / width : 0.5;
    return Point{radius[i - 1] + t * (radius[i] - radius[i - 1]),
                 error[i - 1] + t * (error[i] - error[i - 1])};
  }
  return std::nullopt;
}

}  // namespace

ContactHysteresis contact_hysteresis(const std::vector<double>& delta,
                                     const std::vector<double>& radius,
                                     const std::vector<double>& error) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  ContactHysteresis found{{none, {}, dimension::length}, {none, {}, dimension::length}};
  const auto cycle = first_cycle(delta, radius);
  if (!cycle) return found;
  for (std::size_t i = cycle->turn + 1; i <= cycle->end; ++i) {
    const auto loading = loading_at(delta[i], *cycle, delta, radius, error);
    if (!loading) continue;
    const double difference = radius[i] - loading->radius;
    if (std::abs(difference) <= std::abs(found.difference.value)) continue;
    found.difference.value = difference;
    found.difference.error = std::hypot(error[i], loading->error);
    found.delta.value = delta[i];
  }
  return found;
}

}  // namespace mdana
