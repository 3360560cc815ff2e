// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace mdana {
namespace {

/// 1, 2 or 5 times a power of ten, so that the length has four to ten steps.
double round_step(double length) {
  const double ten = std::pow(10, std::floor(std::log10(length / 4)));
  for (const double times : {5.0, 2.0})
    if (length / (times * ten) >= 4) return times * ten;
  return ten;
}

}  // namespace

Axis::Axis(const std::vector<double>& values, bool log) : log_(log) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (const double v : values)
    if (holds(v)) {
      least = std::min(least, v);
      greatest = std::max(greatest, v);
    }
  if (!(least <= greatest)) return;
  log ? log_ticks(least, greatest) : linear_ticks(least, greatest);
}

bool Axis::holds(double value) const { return std::isfinite(value) && (!log_ || value > 0); }

void Axis::linear_ticks(double least, double greatest) {
  const double size = std::max(std::abs(least), std::abs(greatest));
  // All the same to rounding: a tenth of it about it.
  if (greatest / 2 - least / 2 <= 1e-12 * size || size == 0) {
    const double about = size > 0 ? 0.1 * size : 1;
    least -= about;
    greatest += about;
  }
  const double step = round_step(greatest - least);
  if (!(step > 0) || !std::isfinite(step)) return;  // beyond the range of a double
  const double first = std::floor(least / step), last = std::ceil(greatest / step);
  for (double k = first; k <= last; ++k) ticks_.push_back(k * step);
}

void Axis::log_ticks(double least, double greatest) {
  const double first = std::floor(std::log10(least));
  const double last = std::max(std::ceil(std::log10(greatest)), first + 1);
  const double step = std::ceil((last - first) / 8);
  for (double k = first; k < last + step; k += step) ticks_.push_back(std::pow(10, k));
}

double Axis::place(double value) const {
  const auto measure = [this](double v) { return log_ ? std::log10(v) : v; };
  const double from = measure(ticks_.front());
  return (measure(value) - from) / (measure(ticks_.back()) - from);
}

std::string Axis::label(double tick) const {
  if (!log_) return fmt::format("{:.6g}", std::abs(tick) < 1e-9 * (ticks_.back() - ticks_.front()) ? 0.0 : tick);
  return fmt::format("1e{:.0f}", std::log10(tick));
}

}  // namespace mdana
