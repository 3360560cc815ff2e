// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

namespace mdana {

/// Weighted mean and second moment about the mean of points in Dim dimensions. Sums are formed
/// about the mean, never as a difference of large numbers, so that a drift of 1e7 thermal speeds
/// leaves the thermal part exact (Chan, Golub & LeVeque 1983).
template <int Dim>
struct Moments {
  using Vector = Eigen::Matrix<double, Dim, 1>;

  std::uint64_t count = 0;
  double weight = 0;
  Vector mean = Vector::Zero();
  double spread = 0;  ///< sum of weight * |point - mean|^2

  template <class P>
  void pass(P& parcel) {
    parcel(count, weight, mean, spread);
  }

  void merge(const Moments& other) {
    if (other.count == 0) return;
    if (count == 0) {
      *this = other;
      return;
    }
    const double total = weight + other.weight;
    const Vector step = other.mean - mean;
    mean += step * (other.weight / total);
    spread += other.spread + step.squaredNorm() * (weight * (other.weight / total));
    weight = total;
    count += other.count;
  }
};

}  // namespace mdana
