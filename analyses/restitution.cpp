// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/restitution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>
#include <boost/math/distributions/students_t.hpp>

namespace mdana {
namespace {

constexpr double not_determined = std::numeric_limits<double>::quiet_NaN();

/// Frames [first, last) of straight flight.
struct Flight {
  std::size_t first, last;
  std::size_t frames() const { return last - first; }
};

std::size_t count(const ForceCurve& curve, Phase phase) {
  return static_cast<std::size_t>(std::count(curve.phase.begin(), curve.phase.end(), phase));
}

/// The half of the approach that is farther from the contact.
Flight flight_before(const ForceCurve& curve) { return {0, (count(curve, Phase::approach) + 1) / 2}; }

/// The same of the frames after separation.
Flight flight_after(const ForceCurve& curve) {
  const std::size_t frames = curve.phase.size();
  return {frames - (count(curve, Phase::separated) + 1) / 2, frames};
}

/// Greatest change to a neighbouring frame: all that is known of the error of a single one.
double change_beside(const std::vector<double>& speeds, std::size_t i) {
  double change = 0;
  if (i > 0) change = std::abs(speeds[i] - speeds[i - 1]);
  if (i + 1 < speeds.size()) change = std::max(change, std::abs(speeds[i] - speeds[i + 1]));
  return change;
}

/// Half of what the speed drifts from the first third to the last one.
double drift(const std::vector<double>& speeds) {
  const std::size_t third = (speeds.size() + 2) / 3;
  double first = 0, last = 0;
  for (std::size_t i = 0; i < third; ++i) {
    first += speeds[i];
    last += speeds[speeds.size() - 1 - i];
  }
  return 0.5 * std::abs(last - first) / static_cast<double>(third);
}

/// Twice the error of a mean of n values so widened holds it as often as two standard deviations do: half of
/// Student's t at 97.725 % for n - 1 degrees of freedom.
double widening(double n) {
  return boost::math::quantile(boost::math::students_t(n - 1), 0.97725) / 2;
}

Value mean_speed(const std::vector<double>& speeds, Flight flight) {
  Value mean{not_determined, {}, dimension::velocity};
  if (flight.frames() == 0) return mean;
  const std::vector<double> chosen(speeds.begin() + static_cast<long>(flight.first),
                                   speeds.begin() + static_cast<long>(flight.last));
  const auto n = static_cast<double>(chosen.size());
  mean.value = std::accumulate(chosen.begin(), chosen.end(), 0.0) / n;
  if (chosen.size() == 1) {
    mean.error = change_beside(speeds, flight.first);
    return mean;
  }
  double squares = 0;
  for (const double v : chosen) squares += (v - mean.value) * (v - mean.value);
  mean.error = std::hypot(widening(n) * std::sqrt(squares / (n - 1) / n), drift(chosen));
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

/// Series of the motion, a value a frame.
struct Speeds {
  std::vector<double> normal, tangential, impact_parameter;

  Speeds(const RelativeMotion& motion, const Eigen::Vector3d& line) {
    const Eigen::Matrix3Xd velocity = relative_velocity(motion);
    for (Eigen::Index i = 0; i < velocity.cols(); ++i) {
      const Eigen::Vector3d v = velocity.col(i), x = motion.position.col(i);
      normal.push_back(-line.dot(v));
      tangential.push_back((v - line * line.dot(v)).norm());
      impact_parameter.push_back(x.cross(v.stableNormalized()).norm());
    }
  }
};

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

Eigen::Vector3d impact_normal(const RelativeMotion& motion, const ForceCurve& curve) {
  const std::size_t turn = curve.cycles.empty()
                               ? static_cast<std::size_t>(std::ranges::max_element(curve.delta) -
                                                          curve.delta.begin())
                               : curve.cycles[0].turn;
  return motion.position.col(static_cast<Eigen::Index>(turn)).stableNormalized();
}

Restitution restitution(const RelativeMotion& motion, const ForceCurve& curve) {
  Restitution result;
  const Value none{not_determined, {}, dimension::none};
  result.e = result.e_total = none;
  result.speed_before = result.speed_after = {not_determined, {}, dimension::velocity};
  result.tangential_before = result.tangential_after = result.speed_before;
  result.speed_before_total = result.speed_after_total = result.speed_before;
  result.impact_parameter = {not_determined, {}, dimension::length};
  if (!curve.speed.empty()) {
    const Speeds speeds(motion, impact_normal(motion, curve));
    result.speed_before = mean_speed(speeds.normal, flight_before(curve));
    result.speed_after = mean_speed(speeds.normal, flight_after(curve));
    const std::vector<double> whole = whole_speed(motion);
    result.speed_before_total = mean_speed(whole, flight_before(curve));
    result.speed_after_total = mean_speed(whole, flight_after(curve));
    result.tangential_before = mean_speed(speeds.tangential, flight_before(curve));
    result.tangential_after = mean_speed(speeds.tangential, flight_after(curve));
    result.impact_parameter = mean_speed(speeds.impact_parameter, flight_before(curve));
    result.impact_parameter.dimension = dimension::length;
    result.speed_after.value = -result.speed_after.value;  // receding
  }
  result.reason = obstacle(curve, result.speed_before, result.speed_after);
  if (!result.reason.empty()) return result;
  if (curve.outcome == Outcome::stick) {
    result.e.value = result.e_total.value = 0;
    return result;
  }
  result.e = ratio(result.speed_after, result.speed_before);
  result.e_total = ratio(result.speed_after_total, result.speed_before_total);
  return result;
}

}  // namespace mdana
