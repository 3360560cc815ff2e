// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/compression.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "analyses/force_curve.hpp"
#include "analyses/force_series.hpp"
#include "analyses/turning_points.hpp"

namespace mdana {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// delta and d delta/dt between two frames as a cubic in s = 0 to 1.
struct Cubic {
  double start, length;        ///< [time]
  double d0, d1, rate0, rate1;  ///< rates by s

  double rate(double s) const { return (a() * s + b()) * s + rate0; }
  double value(double s) const { return d0 + s * (rate0 + s * (b() / 2 + s * a() / 3)); }
  double time(double s) const { return start + s * length; }
  double a() const { return 6 * (d0 - d1) + 3 * (rate0 + rate1); }
  double b() const { return 6 * (d1 - d0) - 4 * rate0 - 2 * rate1; }
};

/// Where the value, at most 0 at s = 0 and positive at s = 1, is zero: by bisection to rounding.
double zero_of(const Cubic& c) {
  double low = 0, high = 1;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (c.value(middle) <= 0 ? low : high) = middle;
  }
  return low;
}

/// delta and its rate at every k-th frame from `first` on.
struct Samples {
  std::vector<double> times, delta, rate;

  Samples(const ApproachSeries& series, double radius_sum, std::size_t first, std::size_t stride) {
    for (std::size_t i = first; series.known() && i < series.times.size(); i += stride) {
      times.push_back(series.times[i]);
      delta.push_back(radius_sum - series.distance[i]);
      rate.push_back(series.speed[i]);
    }
  }
  Cubic between(std::size_t i) const {
    const double h = times[i + 1] - times[i];
    return {times[i], h, delta[i], delta[i + 1], h * rate[i], h * rate[i + 1]};
  }
  /// Over some frames about those between which the turn lies, so that noise hardly counts.
  double deceleration(std::size_t i) const {
    const std::size_t first = i - std::min<std::size_t>(i, 2), last = std::min(i + 3, times.size() - 1);
    return (rate[first] - rate[last]) / (times[last] - times[first]);
  }
};

/// The frame of the first maximum in contact, if there is one.
std::optional<std::size_t> first_maximum(const std::vector<double>& delta) {
  if (delta.empty()) return std::nullopt;
  const double rise = *std::ranges::max_element(delta) - std::max(delta.front(), 0.0);
  if (!(rise > 0)) return std::nullopt;
  for (const Turn& turn : turning_points(delta, turning_point_fraction * rise))
    if (turn.maximum && delta[turn.index] > 0) return turn.index;
  return std::nullopt;
}

/// The interval nearest to a frame in which the rate falls through zero.
std::optional<std::size_t> falling_through_zero(const std::vector<double>& rate, std::size_t near) {
  const auto falls = [&](std::size_t i) { return i + 1 < rate.size() && rate[i] > 0 && rate[i + 1] <= 0; };
  for (std::size_t off = 0; off < rate.size(); ++off) {
    if (falls(near + off)) return near + off;
    if (off < near && falls(near - off - 1)) return near - off - 1;
  }
  return std::nullopt;
}

/// The maximum of a series without errors; NaN where there is none.
struct Turned {
  double delta = unknown, time = unknown, contact = unknown;
  double deceleration = unknown, speed = unknown;  ///< at the turn, at contact

  explicit Turned(const Samples& samples) {
    const auto frame = first_maximum(samples.delta);
    if (!frame) return;
    delta = samples.delta[*frame];
    time = samples.times[*frame];
    if (const auto i = falling_through_zero(samples.rate, *frame)) {
      const Cubic cubic = samples.between(*i);
      const double s = cubic.rate0 / (cubic.rate0 - cubic.rate1);  // v_rel is nearly straight there
      delta = cubic.value(s);
      time = cubic.time(s);
      deceleration = samples.deceleration(*i);
    }
    std::size_t i = *frame;
    while (i > 0 && samples.delta[i - 1] > 0) --i;
    if (i > 0) touch(samples.between(i - 1));
  }

 private:
  void touch(const Cubic& cubic) {
    const double s = zero_of(cubic);
    contact = cubic.time(s);
    speed = cubic.rate(s) / cubic.length;
  }
};

std::string no_maximum(const ApproachSeries& series, double radius_sum) {
  if (!series.known()) return "the time between frames is not known, or frames are too few for v_rel";
  if (!(*std::ranges::min_element(series.distance) < radius_sum))
    return "the centres never come nearer than the sum of the radii: radius or offset do not fit";
  return "the dump ends before delta has fallen back by 1 % from a maximum in contact";
}

void widen(Value& value, double other) {
  if (!std::isnan(value.value) && !std::isnan(other))
    value.error = std::max(value.error.value_or(0), std::abs(value.value - other));
}

void add(Value& value, double noise) {
  if (value.error && std::isfinite(noise)) value.error = std::hypot(*value.error, noise);
}

}  // namespace

MaximumCompression maximum_compression(const ApproachSeries& series, double radius_sum) {
  const Turned turned(Samples(series, radius_sum, 0, 1));
  MaximumCompression result{{turned.delta, {}, dimension::length},
                            {turned.time - turned.contact, {}, dimension::time},
                            turned.contact, turned.time, {}, {}};
  if (std::isnan(turned.delta)) {
    result.delta_reason = result.time_reason = no_maximum(series, radius_sum);
    return result;
  }
  if (std::isnan(turned.contact))
    result.time_reason = "the dump begins in contact, from where t_max would count; dump from before it";
  for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {
    const Turned coarse(Samples(series, radius_sum, first, 2));
    widen(result.delta, coarse.delta);
    widen(result.time, coarse.time - coarse.contact);
  }
  const double far = std::max(noise_of(series.distance), series.distance_noise);
  const double fast = std::max(noise_of(series.speed), series.speed_noise);
  add(result.delta, far);
  add(result.time, std::hypot(far / turned.speed, fast / turned.deceleration));
  return result;
}

}  // namespace mdana
