// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fits/contact_motion.hpp"

namespace mdana {

/// Collects a trajectory from the steps of an integration: their stages, or the times wanted.
class MotionRecorder {
 public:
  explicit MotionRecorder(const MotionSettings& settings) : settings_(settings) {}

  /// Of the start, before the first step.
  template <class ToPoint, class State>
  void start(const State& y, ToPoint&& to_point) {
    if (settings_.trajectory && settings_.times.empty()) points_.push_back(to_point(y));
  }

  /// Of a step that is about to be accepted.
  template <class Stepper, class ToPoint>
  void add(const Stepper& stepper, ToPoint&& to_point) {
    if (!settings_.trajectory) return;
    if (settings_.times.empty()) {
      for (int i = 0; i < Stepper::stages; ++i) points_.push_back(to_point(stepper.stage(i)));
      return;
    }
    last_ = to_point(stepper.end());
    for (; next_ < settings_.times.size() && settings_.times[next_] <= last_.t; ++next_)
      points_.push_back(at(stepper, settings_.times[next_], to_point));
  }

  /// All of it, in order.
  std::vector<ContactMotion::Point> finish() {
    if (!settings_.times.empty()) points_.push_back(last_);
    return std::move(points_);
  }

 private:
  /// Time rises within a step, but for what rounding does to the smallest ones.
  template <class Stepper, class ToPoint>
  static ContactMotion::Point at(const Stepper& stepper, double time, ToPoint&& to_point) {
    double low = 0, high = 1;
    for (int i = 0; i < 60 && high - low > 1e-15; ++i) {
      const double middle = (low + high) / 2;
      (to_point(stepper.between(middle)).t < time ? low : high) = middle;
    }
    return to_point(stepper.between(high));
  }

  const MotionSettings& settings_;
  std::vector<ContactMotion::Point> points_;
  ContactMotion::Point last_{};
  std::size_t next_ = 0;
};

}  // namespace mdana
