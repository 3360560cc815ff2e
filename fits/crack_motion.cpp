// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/crack_system.hpp"
#include "fits/motion_recorder.hpp"

namespace mdana {
namespace {

using Stepper = Radau<CrackSystem>;
using Full = Stepper::Full;

constexpr double least_energy = -1.2;  // U at equilibrium, u = d = 1

/// How far a contact at rest at d is from bouncing: its energy on the JKR curve, less that of
/// pull-off; zero beyond pull-off, where only time is missing. And the derivative by d, which is
/// the force.
struct Missing {
  double energy = 0, by_d = 0;

  explicit Missing(double d) {
    const double last = std::cbrt(1.0 / 6.0);  // s = sqrt(u) at pull-off
    if (d <= 3 * last * last * last * last - 2 * last) return;
    double s = 1 + std::pow(std::max(d, 0.0) / 3, 0.25);
    for (int i = 0; i < 60; ++i) s -= (3 * s * s * s * s - 2 * s - d) / (12 * s * s * s - 2);
    const auto on_curve = [](double x) {
      return x * x * x * x * (x * x * x * (4.8 * x * x * x - 8) + 2);
    };
    energy = on_curve(s) - on_curve(last);
    by_d = 4 * s * s * s * (s * s * s - 1);
  }
};

/// One collision: the branches of the crack law one after the other.
class CrackCollision {
 public:
  CrackCollision(const CrackContact& contact, const MotionSettings& settings)
      : contact_(contact),
        settings_(settings),
        system_(system_of(contact)),
        integration_(start(contact), scale_of(contact.w0), settings.tolerance, 1e-3 / system_.c,
                     settings.limits) {
    energy_ = first_energy_ = system_.energy(integration_.stepper.y().data());
    if (!settings.sensitivities) return;
    Stepper::Derivatives by = Stepper::Derivatives::Zero();
    by(0, 0) = 1;
    integration_.stepper.keep_derivatives(by);
  }

  ContactMotion run();

 private:
  static CrackSystem system_of(const CrackContact& contact);
  static Full start(const CrackContact& contact);
  static Stepper::States scale_of(double w0);

  bool go_on();
  void observe(const Stepper& stepper);
  ContactMotion::Point point(const Full& y) const;
  bool settled(const Full& y);
  void turn(Full& y);
  bool reach_end_of_branch(Full& y);
  bool cross(Full& y, CrackBranch to, double z);
  void detach(const Full& y);
  void rest(const Full& y);
  void stick();
  void give_up(SegmentEnd end);

  double w() const { return integration_.stepper.y()[0]; }
  /// Derivatives by the parameters of a function of y that has that gradient.
  ContactMotion::Gradient derivative(const Full& by_y) const;
  Full by_d(const Full& y) const;

  CrackContact contact_;
  MotionSettings settings_;
  CrackSystem system_;
  Integration<CrackSystem> integration_;
  MotionRecorder recorder_{settings_};
  ContactMotion motion_;
  double energy_ = 0, first_energy_ = 0;
  bool turned_ = false, at_rest_ = false;
};

CrackSystem CrackCollision::system_of(const CrackContact& contact) {
  CrackSystem system;
  system.p = {contact.w0, contact.lam, contact.kap, contact.b, contact.zeta};
  system.stress = contact.stress;
  system.stress_in_crack = contact.stress_in_crack;
  system.c = 1 + contact.w0;
  system.branch = contact.start_on_curve ? CrackBranch::below : CrackBranch::low;
  return system;
}

/// d = 0 at beta = 0.02, u^3 = 0.08/9, or at beta = 1.
Full CrackCollision::start(const CrackContact& contact) {
  Full y = Full::Zero();
  y[0] = contact.w0;
  y[1] = contact.start_on_curve ? std::pow(2.0 / 3.0, 2.0 / 3.0) : std::cbrt(0.08 / 9);
  return y;
}

Stepper::States CrackCollision::scale_of(double w0) {
  return {std::max(1.0, w0), std::max(1.0, std::pow(w0 * w0 / 9.6, 0.2)), 1.0};
}

ContactMotion CrackCollision::run() {
  recorder_.start(integration_.stepper.y(), [this](const Full& y) { return point(y); });
  for (int segments = 0; segments < 10000 && go_on(); ++segments) {
  }
  if (motion_.outcome == CollisionOutcome::unresolved && motion_.reason.empty())
    motion_.reason = "the contact passes between branches of the crack law without end";
  motion_.trajectory = recorder_.finish();
  motion_.evaluations = integration_.stepper.evaluations();
  return std::move(motion_);
}

/// One segment; false at the end of the collision.
bool CrackCollision::go_on() {
  const SegmentEnd end = integration_.run(
      system_, [&](const Stepper& s) { observe(s); }, [&](const Full& y) { return settled(y); });
  Full y = integration_.stepper.y();
  motion_.u_max = std::max(motion_.u_max, y[1]);
  if (end == SegmentEnd::done) return stick(), false;
  if (end != SegmentEnd::event) return give_up(end), false;
  if (integration_.event == 0)
    turn(y);
  else if (!reach_end_of_branch(y))
    return false;
  integration_.stepper.restart(y);
  return motion_.outcome == CollisionOutcome::unresolved;
}

void CrackCollision::observe(const Stepper& stepper) {
  const Full& end = stepper.end();
  energy_ = system_.energy(end.data());
  const double residual =
      std::abs(energy_ + end[4] - first_energy_) / std::max(1.0, 0.5 * contact_.w0 * contact_.w0);
  motion_.residual = std::max(motion_.residual, residual);
  recorder_.add(stepper, [this](const Full& y) { return point(y); });
}

ContactMotion::Point CrackCollision::point(const Full& y) const {
  return {y[3], system_.d(y.data()), y[0], y[1], system_.force(y.data())};
}

/// Near equilibrium with no speed to speak of: a contact that only creeps.
bool CrackCollision::settled(const Full& y) {
  motion_.u_max = std::max(motion_.u_max, y[1]);
  return energy_ - least_energy < 1e-9;
}

ContactMotion::Gradient CrackCollision::derivative(const Full& by_y) const {
  ContactMotion::Gradient g = ContactMotion::Gradient::Zero();
  g.head<Stepper::np>() = integration_.stepper.derivatives().transpose() * by_y;
  return g;
}

/// Gradient of d = 3u^2 - h, h = 2 exp(q/2) sqrt(u).
Full CrackCollision::by_d(const Full& y) const {
  Full by = Full::Zero();
  const double h = system_.excess(y.data());
  by[1] = 6 * y[1] - 0.5 * h / y[1];
  by[2] = -0.5 * h;
  return by;
}

/// w through zero: greatest compression at first, then, if the energy is negative, the spheres
/// stick: with a free contact radius nothing else proves it.
void CrackCollision::turn(Full& y) {
  y[0] = 0;
  if (!turned_) {
    motion_.d_max = system_.d(y.data());
    motion_.t_max = y[3];
    if (settings_.sensitivities) {
      motion_.by_d_max = derivative(by_d(y));
      motion_.by_t_max = derivative(Full::Unit(3));
    }
    turned_ = true;
  } else if (system_.after_turn) {
    if (!at_rest_) rest(y);
    if (energy_ < 0) stick();
  }
  system_.after_turn = !system_.after_turn;
}

/// At an end of a branch: on in the next one, along the join, or detachment at beta = 50.
bool CrackCollision::reach_end_of_branch(Full& y) {
  const bool up = integration_.event == 2;
  const CrackBranch here = system_.branch;
  if (system_.sliding) {
    system_.sliding = false;
    const double z = system_.upper() + crack::reference(here);
    return up ? cross(y, CrackSystem::next(here), z) : cross(y, here, z);
  }
  if (up && here == CrackBranch::high) return detach(y), false;
  if (!up && here == CrackBranch::low) {
    motion_.reason = "the contact leaves the range of the crack law, beta < 0.02";
    return false;
  }
  const CrackBranch lower = up ? here : static_cast<CrackBranch>(static_cast<int>(here) - 1);
  const CrackBranch upper = CrackSystem::next(lower);
  CrackSystem at_join = system_;
  at_join.branch = lower;
  const double z = at_join.upper() + crack::reference(lower);
  if (lower == CrackBranch::below)
    return cross(y, up ? upper : lower, z);  // beta = 1: f = 0 on both
  y[2] = at_join.upper();
  const double onward = at_join.drift(y.data(), system_.p.data(), up ? upper : lower);
  if (up ? onward > 0 : onward < 0) return cross(y, up ? upper : lower, z);
  system_.sliding = true;
  return cross(y, lower, z);
}

bool CrackCollision::cross(Full& y, CrackBranch to, double z) {
  system_.branch = to;
  y[2] = z - crack::reference(to);
  return true;
}

/// Contact ends. If the spheres approach then, they touch again, slower.
void CrackCollision::detach(const Full& y) {
  const double w0 = contact_.w0, e = -y[0] / w0;
  motion_.outcome = e > 0 ? CollisionOutcome::bounce : CollisionOutcome::stick;
  if (e > 0) motion_.t_end = y[3];
  if (e <= 0) motion_.reason = "the contact breaks while the spheres approach";
  const double before = e <= 0 && at_rest_ ? motion_.e_squared : 0;
  motion_.e_squared = before + e * std::abs(e);
  if (!settings_.sensitivities) return;
  Full by = Full::Zero();
  by[0] = -2 * std::abs(e) / w0;
  motion_.by_e_squared =
      derivative(by) + (before < 0 ? motion_.by_e_squared : ContactMotion::Gradient::Zero());
  motion_.by_e_squared[0] -= 2 * e * std::abs(e) / w0;
}

/// The first rest after the greatest compression, or where the motion ends: e^2 there.
void CrackCollision::rest(const Full& y) {
  const double w0 = contact_.w0;
  const Missing missing(system_.d(y.data()));
  at_rest_ = true;
  motion_.e_squared = std::min(0.0, 2 * (missing.energy / w0) / w0);
  if (!settings_.sensitivities) return;
  motion_.by_e_squared = derivative(by_d(y)) * (2 * missing.by_d / (w0 * w0));
  motion_.by_e_squared[0] -= 2 * motion_.e_squared / w0;
}

void CrackCollision::stick() {
  if (!at_rest_) rest(integration_.stepper.y());
  motion_.outcome = CollisionOutcome::stick;
  motion_.reason = "bound: kinetic and potential energy are below zero";
  motion_.bound = energy_ < -1e-8 * std::max(1.0, 0.5 * contact_.w0 * contact_.w0);
}

void CrackCollision::give_up(SegmentEnd end) {
  if (energy_ < 0 && turned_) return stick();
  motion_.reason = reason_of(end);
}

}  // namespace

ContactMotion move(const CrackContact& contact, const MotionSettings& settings) {
  return CrackCollision(contact, settings).run();
}

}  // namespace mdana
