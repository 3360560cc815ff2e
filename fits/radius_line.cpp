// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/radius_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mdana {
namespace {

/// Sums about the weighted means.
struct Centred {
  double weight = 0, radius = 0, delta = 0;  ///< sum of weights; means
  double squares = 0, products = 0;          ///< of radius, of radius and delta_max
};

Centred centre(std::span<const double> x, std::span<const double> y, std::span<const double> errors) {
  Centred c;
  const auto weight = [&](std::size_t i) { return errors.empty() ? 1.0 : 1 / (errors[i] * errors[i]); };
  for (std::size_t i = 0; i < x.size(); ++i) c.weight += weight(i);
  for (std::size_t i = 0; i < x.size(); ++i) {
    c.radius += weight(i) / c.weight * x[i];
    c.delta += weight(i) / c.weight * y[i];
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    c.squares += weight(i) * (x[i] - c.radius) * (x[i] - c.radius);
    c.products += weight(i) * (x[i] - c.radius) * (y[i] - c.delta);
  }
  return c;
}

/// Factor of the variances; NaN if nothing tells it.
double scale_of(double chi2, std::size_t points, bool known_errors) {
  if (points <= 2) return known_errors ? 1 : std::numeric_limits<double>::quiet_NaN();
  const double reduced = chi2 / static_cast<double>(points - 2);
  return known_errors ? std::max(1.0, reduced) : reduced;
}

void set_error(Value& value, double variance) {
  if (!std::isnan(variance)) value.error = std::sqrt(variance);
}

}  // namespace

RadiusLine fit_radius_line(std::span<const double> radius, std::span<const double> delta_max,
                           std::span<const double> errors) {
  const Centred c = centre(radius, delta_max, errors);
  const double a = c.products / c.squares, b = c.delta - a * c.radius, rest = 2 - a;
  double chi2 = 0;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double r = delta_max[i] - c.delta - a * (radius[i] - c.radius);
    chi2 += r * r / (errors.empty() ? 1 : errors[i] * errors[i]);
  }
  const double scale = scale_of(chi2, radius.size(), !errors.empty());
  const double var_a = scale / c.squares, cov = -c.radius * var_a;
  const double var_b = scale / c.weight + c.radius * c.radius * var_a;
  const double by_b = 1 / rest, by_a = b / (rest * rest);
  RadiusLine line{{a, {}, dimension::none}, {b, {}, dimension::length}, cov,
                  {b / rest, {}, dimension::length}, chi2};
  set_error(line.slope, var_a);
  set_error(line.intercept, var_b);
  set_error(line.offset, by_b * by_b * var_b + 2 * by_a * by_b * cov + by_a * by_a * var_a);
  return line;
}

}  // namespace mdana
