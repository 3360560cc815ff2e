// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace mdana {

/// An axis of a picture: values between two round numbers, and ticks at such.
class Axis {
 public:
  /// Over the values that have a place on it: finite, and positive if it is logarithmic. Empty if none has.
  Axis(const std::vector<double>& values, bool log);

  bool empty() const { return ticks_.empty(); }
  bool holds(double value) const;
  double place(double value) const;  ///< 0 at the least value of the axis, 1 at the greatest
  const std::vector<double>& ticks() const { return ticks_; }
  std::string label(double tick) const;

 private:
  void linear_ticks(double least, double greatest);
  void log_ticks(double least, double greatest);
  bool log_;
  std::vector<double> ticks_;  ///< ascending; the first and the last are the ends
};

}  // namespace mdana
