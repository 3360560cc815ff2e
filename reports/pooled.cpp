// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/pooled.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mdana {
namespace {

struct WeightedMean {
  double mean = 0, weight = 0;
};

WeightedMean weighted_mean(std::span<const Value> runs, double between) {
  WeightedMean m;
  double sum = 0;
  for (const Value& run : runs) {
    const double weight = 1 / (*run.error * *run.error + between * between);
    m.weight += weight;
    sum += weight * run.value;
  }
  m.mean = sum / m.weight;
  return m;
}

/// Variance beyond the errors: (Q - (n - 1))/(W - sum w^2/W), Q = sum w (x - mean)^2.
double variance_between(std::span<const Value> runs) {
  const WeightedMean fixed = weighted_mean(runs, 0);
  double q = 0, squares = 0;
  for (const Value& run : runs) {
    const double weight = 1 / (*run.error * *run.error);
    q += weight * (run.value - fixed.mean) * (run.value - fixed.mean);
    squares += weight * weight;
  }
  const double freedom = static_cast<double>(runs.size()) - 1;
  return std::max(0.0, (q - freedom) / (fixed.weight - squares / fixed.weight));
}

double sample_deviation(std::span<const Value> runs) {
  double mean = 0, sum = 0;
  for (const Value& run : runs) mean += run.value / static_cast<double>(runs.size());
  for (const Value& run : runs) sum += (run.value - mean) * (run.value - mean);
  return std::sqrt(sum / (static_cast<double>(runs.size()) - 1));
}

}  // namespace

Pooled pool(std::span<const Value> runs) {
  Pooled pooled;
  for (const Value& run : runs) pooled.within += *run.error * *run.error / static_cast<double>(runs.size());
  pooled.within = std::sqrt(pooled.within);
  const bool several = runs.size() > 1;
  const double variance = several ? variance_between(runs) : 0;
  const WeightedMean mean = weighted_mean(runs, std::sqrt(variance));
  pooled.value = {mean.mean, 1 / std::sqrt(mean.weight), runs.front().dimension};
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  pooled.between = several ? std::sqrt(variance) : unknown;
  pooled.spread = several ? sample_deviation(runs) : unknown;
  return pooled;
}

}  // namespace mdana
