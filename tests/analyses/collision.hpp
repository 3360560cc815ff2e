// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "analyses/force_curve.hpp"

namespace mdana::test {

/// delta, d delta/dt and d2 delta/dt2 at one time.
struct Approach {
  double delta, speed, acceleration;
};

using Path = std::function<Approach(double time)>;

inline std::vector<double> even_times(double first, double last, double step) {
  std::vector<double> times;
  for (std::size_t i = 0; first + step * static_cast<double>(i) <= last; ++i)
    times.push_back(first + step * static_cast<double>(i));
  return times;
}

/// Head-on motion along an oblique line: X = radius_sum - delta, forces, velocities and positions.
inline RelativeMotion head_on(const std::vector<double>& times, const Path& path, double radius_sum,
                              double reduced_mass) {
  const Eigen::Vector3d n = Eigen::Vector3d(1, -2, 2) / 3;
  const auto frames = static_cast<Eigen::Index>(times.size());
  RelativeMotion motion;
  motion.times = times;
  motion.reduced_mass = reduced_mass;
  motion.position.resize(3, frames);
  motion.velocity.resize(3, frames);
  motion.acceleration.resize(3, frames);
  for (Eigen::Index i = 0; i < frames; ++i) {
    const Approach at = path(times[static_cast<std::size_t>(i)]);
    motion.steps.push_back(10 * i);
    motion.position.col(i) = (radius_sum - at.delta) * n;
    motion.velocity.col(i) = -at.speed * n;
    motion.acceleration.col(i) = -at.acceleration * n;
  }
  return motion;
}

/// Free flight with speed v before touch at t = 0, then `inside`, then free flight again.
inline Path with_flight(double v, double contact_time, double v_after, Path inside) {
  return [=](double t) -> Approach {
    if (t < 0) return {v * t, v, 0};
    if (t > contact_time)
      return {inside(contact_time).delta - v_after * (t - contact_time), -v_after, 0};
    return inside(t);
  };
}

/// Linear spring of frequency omega: delta = v/omega sin(omega t) for half a period.
inline Path elastic_bounce(double v, double omega) {
  return with_flight(v, std::numbers::pi / omega, v, [=](double t) -> Approach {
    const double s = std::sin(omega * t);
    return {v / omega * s, v * std::cos(omega * t), -v * omega * s};
  });
}

/// A spring that unloads stiffer than it loads, omega2 > omega1: F = m* omega1^2 delta up to
/// delta_m = v/omega1, then m* omega2^2 (delta - delta_e), the same at delta_m. The loop area is
/// m* v^2/2 (1 - omega1^2/omega2^2) and the bodies leave with v omega1/omega2.
inline Path plastic_bounce(double v, double omega1, double omega2) {
  const double turn = std::numbers::pi / (2 * omega1), end = turn + std::numbers::pi / (2 * omega2);
  const double most = v / omega1, recovered = most * (omega1 * omega1) / (omega2 * omega2);
  return with_flight(v, end, v * omega1 / omega2, [=](double t) -> Approach {
    if (t <= turn)
      return {most * std::sin(omega1 * t), v * std::cos(omega1 * t),
              -v * omega1 * std::sin(omega1 * t)};
    const double c = std::cos(omega2 * (t - turn)), s = std::sin(omega2 * (t - turn));
    return {most - recovered * (1 - c), -recovered * omega2 * s, -recovered * omega2 * omega2 * c};
  });
}

/// The stated error covers the truth, up to rounding of a number of size `scale`: second
/// differences of X = 20 over steps of 0.1 are rounded to 20 epsilon/0.1^2 = 4e-13, and there are a
/// hundred.
inline bool covers(const Value& value, double truth, double scale) {
  return value.error && std::abs(value.value - truth) <= *value.error + 1e-10 * scale;
}

}  // namespace mdana::test
