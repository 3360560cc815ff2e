// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace mdana {

/// Sum of vectors with the rounding of each addition kept and added at the end, so that the forces
/// within a body, which cancel, leave only their last digits (Knuth's exact two-sum; Ogita, Rump &
/// Oishi 2005).
template <int Dim>
class CompensatedSum {
 public:
  using Vector = Eigen::Matrix<double, Dim, 1>;

  void add(const Vector& v) {
    const Vector total = sum_ + v;
    const Vector added = total - sum_;
    rest_ += (sum_ - (total - added)) + (v - added);
    sum_ = total;
  }
  void merge(const CompensatedSum& other) {
    add(other.sum_);
    rest_ += other.rest_;
  }
  Vector value() const { return sum_ + rest_; }

  template <class P>
  void pass(P& parcel) {
    parcel(sum_, rest_);
  }

 private:
  Vector sum_ = Vector::Zero();
  Vector rest_ = Vector::Zero();
};

}  // namespace mdana
