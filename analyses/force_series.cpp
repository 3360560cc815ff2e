// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/force_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mdana {
namespace {

using Series = std::vector<double>;

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t least_for_noise = 32;  ///< samples
constexpr double strong = 0.05;  ///< of the largest force: frames that count for what is chosen

double largest_magnitude(const Series& series) {
  double largest = 0;
  for (const double value : series) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Root mean square of the differences where `force` is strong.
double rms_difference(const Series& a, const Series& b, const Series& force) {
  const double limit = strong * largest_magnitude(force);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(force[i]) >= limit) {
      sum += (a[i] - b[i]) * (a[i] - b[i]);
      ++count;
    }
  return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count));
}

/// At every frame the force from every `stride`-th frame before and behind it.
Series sampled_force(const RelativeMotion& motion, ForceSource source, Units units, ForceDerivative by,
                     std::size_t stride) {
  Series force(static_cast<std::size_t>(motion.frames()));
  for (std::size_t first = 0; first < stride; ++first) {
    const Series part = interparticle_force(motion.subset(first, stride), source, units, by);
    for (std::size_t k = 0; k < part.size(); ++k) force[first + k * stride] = part[k];
  }
  return force;
}

/// Factors from the noise of samples to that of the force, by the place in the window (a stretch in the middle
/// of the series, where times are as even as anywhere).
Series noise_gains(const RelativeMotion& motion, ForceSource source, Units units, ForceDerivative by) {
  const std::size_t n = motion.times.size();
  const std::size_t length = std::min<std::size_t>(static_cast<std::size_t>(by.window), n);
  const std::span<const double> times(&motion.times[(n - length) / 2], length);
  DerivativeRule rule = source == ForceSource::velocities ? first_derivative : second_derivative;
  rule.degree = by.degree;
  rule.window = by.window;
  const auto size = static_cast<Eigen::Index>(length);
  const Eigen::MatrixXd weights = derivative(times, Eigen::MatrixXd::Identity(size, size), rule);
  Series gains;
  for (Eigen::Index k = 0; k < size; ++k)
    gains.push_back(motion.reduced_mass * force_per_mass_acceleration(units) * weights.col(k).norm());
  return gains;
}

/// A window and what it gives.
struct Candidate {
  ForceDerivative by;
  Series force, gains;
  double noise;  ///< in the middle
};

bool is_explained(const Candidate& longer, const std::vector<Candidate>& shorter) {
  return std::ranges::all_of(shorter, [&](const Candidate& c) {
    return rms_difference(longer.force, c.force, shorter.front().force) <=
           2 * (longer.noise + c.noise);
  });
}

Candidate best_window(const RelativeMotion& motion, ForceSource source, Units units, ForceDerivative given) {
  const double noise =
      source == ForceSource::velocities ? motion.velocity_noise : motion.position_noise;
  const auto candidate = [&](int window) {
    const ForceDerivative by{window, given.degree};
    Series gains = noise_gains(motion, source, units, by);
    const double middle = noise * gains[gains.size() / 2];
    return Candidate{by, interparticle_force(motion, source, units, by), std::move(gains), middle};
  };
  if (given.window > 0) return candidate(given.window);
  std::vector<Candidate> candidates{candidate(given.degree + 1)};
  for (const int window : derivative_windows) {
    if (window <= given.degree + 1) continue;
    if (window > motion.frames() / 2) break;
    Candidate next = candidate(window);
    if (!is_explained(next, candidates)) break;
    candidates.push_back(std::move(next));
  }
  return candidates.back();
}

/// Root mean square over a frame and the two on each side of it.
double local_rms(const Series& a, const Series& b, std::size_t i) {
  const std::size_t first = i - std::min<std::size_t>(i, 2), last = std::min(i + 3, a.size());
  double sum = 0;
  for (std::size_t k = first; k < last; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum / static_cast<double>(last - first));
}

void find_truncation(const RelativeMotion& motion, ForceSource source, Units units, ForceDerivative by,
                     ForceSeries& series) {
  if (motion.frames() / 4 <= by.degree) return;
  const Series half = sampled_force(motion, source, units, by, 2);
  const Series quarter = sampled_force(motion, source, units, by, 4);
  const double fine = rms_difference(series.value, half, series.value);
  const double coarse = rms_difference(half, quarter, series.value);
  const double greatest = by.degree;
  series.order = fine > 0 && coarse > 0 ? std::clamp(std::log2(coarse / fine), 0.0, greatest) : greatest;
  const double divisor = std::exp2(std::max(series.order, 1.0)) - 1;
  for (std::size_t i = 0; i < series.value.size(); ++i)
    series.truncation.push_back(local_rms(series.value, half, i) / divisor);
}

/// Robust standard deviation from the differences of one order.
double noise_by_differences(Series series, int order) {
  double variance = 1;  // of a difference, for unit noise: binomial(2 order, order)
  for (int k = 1; k <= order; ++k) variance *= static_cast<double>(order + k) / k;
  for (int k = 0; k < order; ++k) {
    for (std::size_t i = 0; i + 1 < series.size(); ++i) series[i] = series[i + 1] - series[i];
    series.pop_back();
  }
  for (double& value : series) value = std::abs(value);
  const auto middle = series.begin() + static_cast<std::ptrdiff_t>(series.size() / 2);
  std::nth_element(series.begin(), middle, series.end());
  return 1.4826 * *middle / std::sqrt(variance);  // the median of a normal distribution
}

}  // namespace

double ForceSeries::error(std::size_t i) const {
  if (window == 0) return value.size() < least_for_noise ? not_known : noise;
  return truncation.empty() ? not_known : std::hypot(truncation[i], noise_at(i));
}

double ForceSeries::noise_at(std::size_t i) const {
  const double middle = std::max(noise, scatter);
  if (edges.empty()) return middle;
  const std::size_t length = edges.size(), before = length / 2, first = std::min(i - std::min(i, before), value.size() - length);
  return middle * edges[i - first];
}

ForceSeries force_series(const RelativeMotion& motion, ForceSource source, Units units, ForceDerivative by) {
  ForceSeries series;
  if (source == ForceSource::forces) {
    series.value = interparticle_force(motion, source, units);
    series.noise = noise_of(series.value);
    return series;
  }
  interparticle_force(motion, source, units, by);  // throws if the source is not there
  Candidate best = best_window(motion, source, units, by);
  series.value = std::move(best.force);
  series.noise = best.noise;
  series.scatter = noise_of(series.value);
  series.window = best.by.window;
  for (const double gain : best.gains) series.edges.push_back(gain / best.gains[best.gains.size() / 2]);
  find_truncation(motion, source, units, best.by, series);
  return series;
}

double noise_of(const std::vector<double>& series) {
  if (series.size() < least_for_noise) return 0;
  const double noise = std::min({noise_by_differences(series, 4), noise_by_differences(series, 8), noise_by_differences(series, 12)});
  return noise * (1 + 1.5 / std::sqrt(static_cast<double>(series.size())));
}

}  // namespace mdana
