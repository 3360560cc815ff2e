// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "fits/radau.hpp"

namespace mdana {

/// What bounds the work of an integration.
struct IntegrationLimits {
  std::chrono::steady_clock::time_point deadline;
  long steps = 5000;
};

enum class SegmentEnd { event, out_of_time, out_of_steps, step_too_small, done };

/// Why a motion could not be followed to its end.
inline const char* reason_of(SegmentEnd end) {
  switch (end) {
    case SegmentEnd::out_of_time: return "the time limit is reached";
    case SegmentEnd::out_of_steps: return "too many steps";
    default: return "no step is small enough for the tolerance";
  }
}

/// Integrates a system until the first of its events,
///
///     static constexpr int events;
///     template <class T, class P> T event(int k, const T* y, const P* p) const;   // falls through
///     zero
///
/// with steps whose embedded error keeps below a tolerance.
template <class System, int S = 5>
class Integration {
 public:
  using Stepper = Radau<System, S>;
  using States = typename Stepper::States;

  Integration(const typename Stepper::Full& y, const States& scale, double tolerance, double h,
              IntegrationLimits limits)
      // The embedded formula is of order S, the step of order 2S - 1: the stages must be solved to
      // what the step can do.
      : stepper(y, scale, std::max(1e-14, 1e-2 * std::pow(tolerance, (2.0 * S - 1) / (S + 1)))),
        tolerance_(tolerance),
        h_(h),
        limits_(limits) {}

  Stepper stepper;
  int event = -1;  ///< that ended the last segment

  /// `observe(stepper)` sees every step before it is accepted; `stop(y)` after it.
  template <class Observe, class Stop>
  SegmentEnd run(const System& system, Observe&& observe, Stop&& stop);

 private:
  double value(const System& system, int k, const States& y) const {
    return system.event(k, y.data(), system.p.data());
  }
  bool good_step(const System& system);
  double next_length();
  bool first_event(const System& system, double& theta);
  double root(const System& system, int k) const;
  bool shorten_to_event(const System& system, double theta);
  void project_derivatives(const System& system);

  double tolerance_, h_, last_h_ = 0, last_ratio_ = 0;
  bool rejected_ = false;  ///< an attempt at this step
  IntegrationLimits limits_;
};

/// By the error of this step and its growth since the last one (Gustafsson); none right after a
/// rejection.
template <class System, int S>
double Integration<System, S>::next_length() {
  constexpr double power = -1.0 / (S + 1);
  const double ratio = stepper.error() / tolerance_ + 1e-12;
  double factor = 0.9 * std::pow(ratio, power);
  if (last_h_ > 0)
    factor = std::min(factor, factor * h_ / last_h_ * std::pow(ratio / last_ratio_, power));
  last_h_ = h_;
  last_ratio_ = std::max(ratio, 1e-3);
  return h_ * std::clamp(factor, 0.2, rejected_ ? 1.0 : 6.0);
}

/// Attempts steps until one keeps the tolerance; h_ is then its length, and false if there is none.
template <class System, int S>
bool Integration<System, S>::good_step(const System& system) {
  for (int tries = 0; tries < 400; ++tries) {
    rejected_ = tries > 0;
    if (stepper.attempt(system, h_)) {
      const double ratio = stepper.error() / tolerance_;
      if (ratio <= 1) return true;
      h_ *= std::clamp(0.9 * std::pow(ratio, -1.0 / (S + 1)), 0.1, 0.9);
    } else {
      h_ *= 0.3;
    }
    if (!(h_ > 1e-280)) return false;
  }
  return false;
}

/// Where the k-th event is zero within the last attempt, by bisection and the rule of false
/// position.
template <class System, int S>
double Integration<System, S>::root(const System& system, int k) const {
  double low = 0, high = 1;
  double g_low = value(system, k, stepper.at(0)), g_high = value(system, k, stepper.at(1));
  for (int i = 0; i < 60 && high - low > 1e-14; ++i) {
    double middle = low + (high - low) * g_low / (g_low - g_high);
    if (i % 3 == 2 || !(middle > low && middle < high)) middle = (low + high) / 2;
    const double g = value(system, k, stepper.at(middle));
    if (g == 0) return middle;
    (g > 0 ? low : high) = middle;
    (g > 0 ? g_low : g_high) = g;
  }
  return high;
}

template <class System, int S>
bool Integration<System, S>::first_event(const System& system, double& theta) {
  event = -1;
  theta = 2;
  for (int k = 0; k < System::events; ++k) {
    const double before = value(system, k, stepper.at(0));
    const double after = value(system, k, stepper.end().template head<Stepper::n>());
    if (after > 0) continue;
    const double at = before > 0 ? root(system, k) : 0;  // begins where it would end
    if (at < theta) theta = at, event = k;
  }
  return event >= 0;
}

/// Repeats the step with the length at which the event is zero: Newton's method on the step itself.
template <class System, int S>
bool Integration<System, S>::shorten_to_event(const System& system, double theta) {
  double h = theta * h_;
  for (int i = 0; i < 6; ++i) {
    if (!stepper.attempt(system, h)) return false;
    const States y = stepper.end().template head<Stepper::n>();
    const States f = stepper.rates(system, y).template head<Stepper::n>();
    const double g = value(system, event, y);
    using T = Dual<1>;
    std::array<T, Stepper::n> moving;
    for (int k = 0; k < Stepper::n; ++k) moving[k] = T(y[k], typename T::Gradient(f[k]));
    const double slope = system.event(event, moving.data(), system.p.data()).gradient[0];
    const double change = -g / slope;
    if (std::abs(change) <= 4e-16 * h || g == 0 || std::abs(g) < 1e-16) return true;
    if (!std::isfinite(change)) return true;
    h += std::clamp(change, -0.5 * h, 0.5 * h);
  }
  return true;
}

template <class System, int S>
void Integration<System, S>::project_derivatives(const System& system) {
  constexpr int n = Stepper::n, np = Stepper::np;
  using T = Dual<n + np>;
  std::array<T, n> y;
  std::array<T, np> p;
  for (int k = 0; k < n; ++k) y[k] = T::variable(stepper.y()[k], k);
  for (int k = 0; k < np; ++k) p[k] = T::variable(system.p[k], n + k);
  const T g = system.event(event, y.data(), p.data());
  stepper.end_at_event(system, g.gradient.template head<n>(), g.gradient.template tail<np>());
}

template <class System, int S>
template <class Observe, class Stop>
SegmentEnd Integration<System, S>::run(const System& system, Observe&& observe, Stop&& stop) {
  last_h_ = 0;
  for (;;) {
    if (--limits_.steps < 0) return SegmentEnd::out_of_steps;
    if (std::chrono::steady_clock::now() > limits_.deadline) return SegmentEnd::out_of_time;
    if (!good_step(system)) return SegmentEnd::step_too_small;
    const double next = next_length();
    double theta = 2;
    if (first_event(system, theta)) {
      if (theta == 0) return SegmentEnd::event;
      const double whole = h_;
      if (!shorten_to_event(system, theta)) {
        h_ = 0.5 * theta * whole;
        continue;
      }
      observe(stepper);
      stepper.accept(system);
      if (stepper.keeps_derivatives()) project_derivatives(system);
      return SegmentEnd::event;
    }
    observe(stepper);
    stepper.accept(system);
    h_ = next;
    if (stop(stepper.y())) return SegmentEnd::done;
  }
}

}  // namespace mdana
