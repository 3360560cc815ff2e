// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/loop_loss.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mdana {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

std::vector<double> slopes(const std::vector<double>& times, const std::vector<double>& values) {
  const Eigen::MatrixXd row =
      Eigen::Map<const Eigen::RowVectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  const Eigen::MatrixXd result = derivative(times, row, first_derivative);
  return {result.data(), result.data() + result.size()};
}

}  // namespace

double PathEnergies::Smooth::at(std::size_t i, double p, double step) const {
  const double q = 1 - p;
  return q * q * (1 + 2 * p) * value[i] + p * p * (1 + 2 * q) * value[i + 1] +
         p * q * step * (q * slope[i] - p * slope[i + 1]);
}

PathEnergies::PathEnergies(const RelativeMotion& motion, Units units, const ForceCurve& curve)
    : curve_(curve),
      times_(motion.times),
      smooth_(!curve.speed.empty() && !motion.times.empty() &&
              motion.frames() > first_derivative.degree) {
  if (!smooth_) return;
  delta_ = {curve.delta, curve.speed};
  find_work();
  find_kinetic(motion, motion.reduced_mass * force_per_mass_acceleration(units));
}

void PathEnergies::find_work() {
  const std::size_t n = curve_.force.size();
  for (std::size_t i = 0; i < n; ++i) work_.slope.push_back(curve_.force[i] * curve_.speed[i]);
  const std::vector<double> bend = slopes(times_, work_.slope);
  work_.value.assign(1, 0.0);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double h = times_[i + 1] - times_[i];
    work_.value.push_back(work_.value[i] + 0.5 * h * (work_.slope[i] + work_.slope[i + 1]) +
                          h * (h / 12) * (bend[i] - bend[i + 1]));
  }
}

void PathEnergies::find_kinetic(const RelativeMotion& motion, double mass) {
  const std::vector<double> squares = squared_speed(motion);
  double outward = 0;  // integral of u^2/X dX
  double before = 0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const double along = curve_.speed[i] * curve_.speed[i];
    const double pull = std::max(squares[i] - along, 0.0) / curve_.distance[i];
    if (i > 0) outward += 0.5 * (pull + before) * (curve_.distance[i] - curve_.distance[i - 1]);
    before = pull;
    along_.value.push_back(0.5 * mass * (along - 2 * outward));
    total_.value.push_back(0.5 * mass * squares[i]);
  }
  along_.slope = slopes(times_, along_.value);
  total_.slope = slopes(times_, total_.value);
}

double PathEnergies::sampling(std::size_t first, std::size_t last) const {
  const std::vector<double>& g = work_.slope;
  double squares = 0;
  for (std::size_t i = std::max<std::size_t>(first, 2); i <= last && i + 2 < g.size(); ++i) {
    const double fourth = g[i - 2] - 4 * g[i - 1] + 6 * g[i] - 4 * g[i + 1] + g[i + 2];
    const double error = 0.5 * (times_[i + 1] - times_[i - 1]) * fourth;
    squares += error * error;
  }
  return std::sqrt(squares / 70);
}

/// Where delta passes `low` between two frames that lie on different sides of it.
PathEnergies::Passage PathEnergies::passage(std::size_t before, double low) const {
  const double step = times_[before + 1] - times_[before];
  const bool rising = curve_.delta[before + 1] > curve_.delta[before];
  double first = 0, last = 1;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (first + last);
    ((delta_.at(before, middle, step) < low) == rising ? first : last) = middle;
  }
  return {before, 0.5 * (first + last)};
}

double PathEnergies::at(const Smooth& series, const Passage& place) const {
  if (place.part == 0) return series.value[place.frame];
  return series.at(place.frame, place.part, times_[place.frame + 1] - times_[place.frame]);
}

/// Frames with delta < low left out, the steps across low shared in proportion.
double PathEnergies::area(std::size_t first, std::size_t last, double low) const {
  double work = 0;
  for (std::size_t i = first; i < last; ++i) {
    double d0 = curve_.delta[i], d1 = curve_.delta[i + 1];
    double f0 = curve_.force[i], f1 = curve_.force[i + 1];
    if (d0 < low && d1 < low) continue;
    if (d0 < low) f0 += (f1 - f0) * ((low - d0) / (d1 - d0)), d0 = low;
    if (d1 < low) f1 += (f0 - f1) * ((low - d1) / (d0 - d1)), d1 = low;
    work += 0.5 * (f0 + f1) * (d1 - d0);
  }
  return work;
}

LoopLoss PathEnergies::of(const Cycle& cycle, double low) const {
  std::size_t up = cycle.turn, down = cycle.turn;
  while (up > cycle.start && curve_.delta[up] > low) --up;
  while (down < cycle.end && curve_.delta[down] > low) ++down;
  LoopLoss loss{area(up, down, low), not_known, 0, not_known, not_known};
  if (!smooth_ || up == cycle.turn || down == cycle.turn) return loss;
  const Passage in = passage(up, low), out = passage(down - 1, low);
  loss.area_by_time = at(work_, out) - at(work_, in);
  loss.area_error = std::max(sampling(up, down), std::abs(loss.area - loss.area_by_time));
  loss.kinetic = at(along_, in) - at(along_, out);
  loss.kinetic_total = at(total_, in) - at(total_, out);
  return loss;
}

LoopLoss PathEnergies::between(std::size_t first, std::size_t last) const {
  const double lowest = *std::min_element(curve_.delta.begin(), curve_.delta.end());
  LoopLoss loss{area(first, last, lowest), not_known, 0, not_known, not_known};
  if (!smooth_) return loss;
  loss.area_by_time = work_.value[last] - work_.value[first];
  loss.area_error = std::max(sampling(first, last), std::abs(loss.area - loss.area_by_time));
  loss.kinetic = along_.value[first] - along_.value[last];
  loss.kinetic_total = total_.value[first] - total_.value[last];
  return loss;
}

}  // namespace mdana
