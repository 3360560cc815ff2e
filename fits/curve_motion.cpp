// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/motion_recorder.hpp"
#include "fits/resistance.hpp"

namespace mdana {
namespace {

/// u = sqrt(d) without adhesion, from touch to touch: F = 4/3 u^3.
struct HertzCurve {
  static constexpr double first = 0, last = 0, last_energy = 0, least_energy = 0;
  template <class T>
  static T d(const T& u) {
    return u * u;
  }
  template <class T>
  static T slope(const T& u) {
    return 2 * u;
  }  // dd/du
  template <class T>
  static T force(const T& u) {
    return 4.0 / 3.0 * u * u * u;
  }
  template <class T>
  static T pressure(const T& u) {
    return u;
  }
  static double energy(double u) { return 8.0 / 15.0 * u * u * u * u * u; }
};

/// d = 3u^2 - 2 sqrt(u) from first contact, u^3 = 4/9, to pull-off, u^3 = 1/36; there the slope is
/// zero, but as a function of u everything is smooth.
struct JkrCurve {
  static const double first, last, last_energy;
  static constexpr double least_energy = -1.2;
  template <class T>
  static T d(const T& u) {
    using std::sqrt;
    return 3 * u * u - 2 * sqrt(u);
  }
  template <class T>
  static T slope(const T& u) {
    using std::sqrt;
    return 6 * u - 1 / sqrt(u);
  }
  template <class T>
  static T force(const T& u) {
    using std::sqrt;
    return 4 * u * (u * u - sqrt(u));
  }
  template <class T>
  static T pressure(const T& u) {
    using std::sqrt;
    return u - 1 / (3 * sqrt(u));
  }
  static double energy(double u) {
    return u * u * (u * std::sqrt(u) * (4.8 * u * std::sqrt(u) - 8) + 2);
  }
};
const double JkrCurve::first = std::cbrt(4.0 / 9.0);
const double JkrCurve::last = std::cbrt(1.0 / 36.0);
const double JkrCurve::last_energy = JkrCurve::energy(JkrCurve::last);

/// State w, u; quadratures tau and the energy dissipated; u' = w, that is dtau/ds = dd/du.
template <class Curve, class Resistance>
struct CurveSystem {
  static constexpr int states = 2, quadratures = 2, parameters = 4, events = 2;
  std::array<double, parameters> p{};  ///< w0 (in the start only), those of the resistance
  Resistance resistance;
  bool after_turn = false;  ///< an event is w rising through zero, else falling

  template <class T, class P>
  void rates(const T* y, const P* p_, T* dy) const {
    const T &w = y[0], &u = y[1];
    const T slope = Curve::slope(u);
    const T loss = resistance.force(u, w, Curve::pressure(u), p_ + 1);
    dy[0] = -(Curve::force(u) + loss) * slope;
    dy[1] = w;
    dy[2] = slope;
    dy[3] = loss * w * slope;
  }

  /// 0: w through zero. 1: the end of the curve.
  template <class T, class P>
  T event(int k, const T* y, const P*) const {
    if (k == 0) return after_turn ? T(-y[0]) : y[0];
    return y[1] - Curve::last;
  }

  double force(const double* y) const {
    return Curve::force(y[1]) + resistance.force(y[1], y[0], Curve::pressure(y[1]), p.data() + 1);
  }
  static double energy(const double* y) { return 0.5 * y[0] * y[0] + Curve::energy(y[1]); }
};

template <class Curve, class Resistance>
class CurveCollision {
  using System = CurveSystem<Curve, Resistance>;
  using Stepper = Radau<System>;
  using Full = typename Stepper::Full;
  using Gradient = ContactMotion::Gradient;

 public:
  CurveCollision(const CurveContact& contact, Resistance resistance, const MotionSettings& settings)
      : w0_(contact.w0),
        settings_(settings),
        integration_(start(w0_), scale(w0_), settings.tolerance,
                     1e-2 * scale(w0_)[1] / scale(w0_)[0], settings.limits) {
    system_.p = {w0_, contact.p[0], contact.p[1], contact.p[2]};
    system_.resistance = resistance;
    energy_ = first_energy_ = System::energy(integration_.stepper.y().data());
    if (!settings.sensitivities) return;
    typename Stepper::Derivatives by = Stepper::Derivatives::Zero();
    by(0, 0) = 1;
    integration_.stepper.keep_derivatives(by);
  }

  ContactMotion run() {
    recorder_.start(integration_.stepper.y(), [this](const Full& y) { return point(y); });
    while (go_on()) {
    }
    motion_.trajectory = recorder_.finish();
    motion_.evaluations = integration_.stepper.evaluations();
    motion_.adhesive = Curve::least_energy < 0;
    return std::move(motion_);
  }

 private:
  static Full start(double w0) { return {w0, Curve::first, 0, 0}; }
  static typename Stepper::States scale(double w0) {
    return {std::max(1.0, w0), std::max(1.0, std::pow(w0 * w0 / 9.6, 0.2))};
  }

  /// One segment; false at the end of the collision.
  bool go_on() {
    const SegmentEnd end = integration_.run(
        system_, [&](const Stepper& s) { observe(s); },
        [&](const Full&) {
          return turned_ && Curve::least_energy < 0 && energy_ - Curve::least_energy < 1e-9;
        });
    const Full y = integration_.stepper.y();
    motion_.u_max = std::max(motion_.u_max, y[1]);
    if (end == SegmentEnd::done) return stick(), false;
    if (end != SegmentEnd::event) return give_up(end), false;
    if (integration_.event == 1) return detach(y), false;
    if (turned_) return stick(), false;
    turn(y);
    return true;
  }

  void observe(const Stepper& stepper) {
    const Full& end = stepper.end();
    energy_ = System::energy(end.data());
    motion_.residual = std::max(motion_.residual, std::abs(energy_ + end[3] - first_energy_) /
                                                      std::max(1.0, 0.5 * w0_ * w0_));
    recorder_.add(stepper, [this](const Full& y) { return point(y); });
  }

  ContactMotion::Point point(const Full& y) const {
    return {y[2], Curve::d(y[1]), y[0], y[1], system_.force(y.data())};
  }

  Gradient derivative(const Full& by_y) const {
    Gradient g = Gradient::Zero();
    g.template head<Stepper::np>() = integration_.stepper.derivatives().transpose() * by_y;
    return g;
  }

  void turn(Full y) {
    y[0] = 0;
    turned_ = system_.after_turn = true;
    motion_.d_max = Curve::d(y[1]);
    motion_.t_max = y[2];
    if (settings_.sensitivities) {
      motion_.by_d_max = derivative(Full(0, Curve::slope(y[1]), 0, 0));
      motion_.by_t_max = derivative(Full(0, 0, 1, 0));
    }
    integration_.stepper.restart(y);
  }

  void detach(const Full& y) {
    motion_.outcome = CollisionOutcome::bounce;
    motion_.e_squared = y[0] * (y[0] / w0_) / w0_;
    motion_.t_end = y[2];
    if (!settings_.sensitivities) return;
    motion_.by_e_squared = derivative(Full(2 * y[0] / (w0_ * w0_), 0, 0, 0));
    motion_.by_e_squared[0] -= 2 * motion_.e_squared / w0_;
  }

  /// Back at rest before pull-off: the barrier is higher than what energy is left.
  void stick() {
    const Full& y = integration_.stepper.y();
    motion_.outcome = CollisionOutcome::stick;
    motion_.reason = "bound: the energy left does not reach pull-off";
    motion_.e_squared = std::min(0.0, 2 * (energy_ - Curve::last_energy) / (w0_ * w0_));
    if (!settings_.sensitivities) return;
    const double by_u = Curve::force(y[1]) * Curve::slope(y[1]);
    motion_.by_e_squared = derivative(Full(2 * y[0], 2 * by_u, 0, 0)) / (w0_ * w0_);
    motion_.by_e_squared[0] -= 2 * motion_.e_squared / w0_;
  }

  void give_up(SegmentEnd end) {
    if (turned_ && energy_ < Curve::last_energy) return stick();
    motion_.reason = reason_of(end);
  }

  double w0_;
  MotionSettings settings_;
  System system_;
  Integration<System> integration_;
  MotionRecorder recorder_{settings_};
  ContactMotion motion_;
  double energy_ = 0, first_energy_ = 0;
  bool turned_ = false;
};

template <class Curve>
ContactMotion move_on(const CurveContact& contact, const MotionSettings& settings) {
  if (contact.power) return CurveCollision<Curve, PowerResistance>(contact, {}, settings).run();
  return CurveCollision<Curve, BulkResistance>(contact, {contact.stress}, settings).run();
}

}  // namespace

ContactMotion move(const CurveContact& contact, const MotionSettings& settings) {
  return contact.adhesive ? move_on<JkrCurve>(contact, settings)
                          : move_on<HertzCurve>(contact, settings);
}

}  // namespace mdana
