// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/residual_memory.hpp"

#include <cmath>
#include <map>
#include <vector>

namespace mdana {
namespace {

using Series = std::vector<double>;

double product(const Series& a, const Series& b, std::size_t lag) {
  double sum = 0;
  for (std::size_t i = 0; i + lag < std::min(a.size(), b.size()); ++i) sum += a[i] * b[i + lag];
  return sum;
}

double noise(const Series& s) { return 2 / std::sqrt(static_cast<double>(s.size())); }

double memory_of(const Series& s) {
  const double square = product(s, s, 0);
  double memory = 1;
  for (std::size_t lag = 1; lag < s.size(); ++lag) {
    const double correlation = product(s, s, lag) / square;
    if (!(correlation > noise(s))) break;
    memory += 2 * correlation;
  }
  return memory;
}

/// How many of the series of one motion say the same: 1 to their number.
double likeness(const std::vector<Series>& all) {
  double sum = 0;
  for (const Series& a : all)
    for (const Series& b : all) {
      const double correlation = std::abs(product(a, b, 0)) / std::sqrt(product(a, a, 0) * product(b, b, 0));
      if (correlation > noise(a)) sum += correlation;
    }
  return sum / static_cast<double>(all.size());
}

}  // namespace

double residual_memory(std::span<const FittedPoint> points) {
  std::map<std::size_t, std::map<SeenQuantity, Series>> motions;
  double all = 0, sum = 0;
  for (const FittedPoint& p : points) {
    const double square = p.residual * p.residual;
    all += square;
    if (p.quantity >= SeenQuantity::delta)
      motions[p.seen][p.quantity].push_back(p.residual);
    else
      sum += square;
  }
  for (const auto& [seen, by_quantity] : motions) {
    std::vector<Series> series;
    for (const auto& [quantity, s] : by_quantity)
      if (product(s, s, 0) > 0) series.push_back(s);
    for (const Series& s : series) sum += likeness(series) * memory_of(s) * product(s, s, 0);
  }
  return all > 0 ? std::max(1.0, sum / all) : 1;
}

}  // namespace mdana
