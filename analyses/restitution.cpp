// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/restitution.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace mdana {
namespace {

constexpr double not_determined = std::numeric_limits<double>::quiet_NaN();

/// Mean of the speeds in one phase.
Value mean_speed(const std::vector<double>& speeds, const std::vector<Phase>& phases, Phase phase) {
  std::vector<double> chosen;
  for (std::size_t i = 0; i < phases.size(); ++i)
    if (phases[i] == phase) chosen.push_back(speeds[i]);
  Value mean{not_determined, {}, dimension::velocity};
  if (chosen.empty()) return mean;
  const auto n = static_cast<double>(chosen.size());
  double sum = 0, squares = 0;
  for (const double v : chosen) sum += v;
  mean.value = sum / n;
  for (const double v : chosen) squares += (v - mean.value) * (v - mean.value);
  if (chosen.size() < 2) return mean;
  const std::size_t third = (chosen.size() + 2) / 3;
  double first = 0, last = 0;
  for (std::size_t i = 0; i < third; ++i) {
    first += chosen[i];
    last += chosen[chosen.size() - 1 - i];
  }
  const double drift = 0.5 * std::abs(last - first) / static_cast<double>(third);
  mean.error = std::hypot(std::sqrt(squares / (n - 1) / n), drift);
  return mean;
}

/// a/b with the errors of both.
Value ratio(const Value& a, const Value& b) {
  Value result{a.value / b.value, {}, dimension::none};
  if (a.error && b.error)
    result.error = std::hypot(*a.error, result.value * *b.error) / std::abs(b.value);
  return result;
}

std::vector<double> whole_speed(const RelativeMotion& motion) {
  std::vector<double> speeds = squared_speed(motion);
  for (double& v : speeds) v = std::sqrt(v);
  return speeds;
}

std::string obstacle(const ForceCurve& curve, const Value& before, const Value& after) {
  if (curve.speed.empty()) return "no velocities, and the time between frames is unknown";
  if (curve.outcome == Outcome::unresolved)
    return "the dump ends before the bodies separate or turn back";
  if (std::isnan(before.value)) return "the dump begins in contact: no speed before it";
  if (curve.outcome == Outcome::bounce && std::isnan(after.value))
    return "the dump ends in contact: no speed after it";
  if (!(before.value > 0)) return "the bodies do not approach before the contact";
  return {};
}

}  // namespace

Restitution restitution(const RelativeMotion& motion, const ForceCurve& curve) {
  Restitution result;
  const Value none{not_determined, {}, dimension::none};
  result.e = result.e_total = none;
  result.speed_before = result.speed_after = {not_determined, {}, dimension::velocity};
  if (!curve.speed.empty()) {
    result.speed_before = mean_speed(curve.speed, curve.phase, Phase::approach);
    result.speed_after = mean_speed(curve.speed, curve.phase, Phase::separated);
    result.speed_after.value = -result.speed_after.value;  // receding
  }
  result.reason = obstacle(curve, result.speed_before, result.speed_after);
  if (!result.reason.empty()) return result;
  if (curve.outcome == Outcome::stick) {
    result.e.value = result.e_total.value = 0;
    return result;
  }
  const std::vector<double> whole = whole_speed(motion);
  result.e = ratio(result.speed_after, result.speed_before);
  result.e_total = ratio(mean_speed(whole, curve.phase, Phase::separated),
                         mean_speed(whole, curve.phase, Phase::approach));
  return result;
}

}  // namespace mdana
