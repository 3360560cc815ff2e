// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/converged.hpp"

#include <cmath>
#include <functional>

namespace mdana {
namespace {

using MoveContact = std::function<ContactMotion(const MotionSettings&)>;

/// Tolerance of a step's embedded error (order S) that keeps e within the wanted error (order 2S -
/// 1): 2e-5 gives 1e-8 at the stiff collisions of P1, with a margin.
constexpr double first_tolerance(double wanted) { return 2e-5 * std::pow(wanted / 1e-8, 0.7); }
constexpr const char* too_close =
    "within the numerical error of the limit between bouncing and sticking";
constexpr double finer = 0.1;
constexpr double finest_tolerance = 1e-13;

/// Bounds of e for e^2 +- error.
double error_of_e(double e_squared, double error) {
  const double e = std::sqrt(std::max(e_squared, 0.0));
  const double up = std::sqrt(std::max(e_squared + error, 0.0)) - e;
  return std::max(up, e - std::sqrt(std::max(e_squared - error, 0.0)));
}

bool resolved(const ContactMotion& motion) {
  return motion.outcome != CollisionOutcome::unresolved;
}

/// Integrations of one collision with falling tolerances.
class Convergence {
 public:
  Convergence(const CollisionSettings& settings, double w0, double time_unit,
              const MoveContact& move_contact)
      : settings_(settings),
        w0_(w0),
        time_unit_(time_unit),
        move_contact_(move_contact),
        deadline_(std::chrono::steady_clock::now() +
                  std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                      std::chrono::duration<double>(settings.time_limit))) {}

  void run();
  ContactMotion last;
  double error = Collision::unknown;  ///< of e^2
  long evaluations = 0;

 private:
  ContactMotion once(double tolerance, bool full);
  double difference(const ContactMotion& before) const;
  bool sign_is_certain() const {
    return !last.adhesive || last.bound || std::abs(last.e_squared) > error;
  }
  bool certain(double wanted) const;

  const CollisionSettings& settings_;
  double w0_, time_unit_;
  const MoveContact& move_contact_;
  std::chrono::steady_clock::time_point deadline_;
};

ContactMotion Convergence::once(double tolerance, bool full) {
  MotionSettings s{tolerance, {deadline_}};
  if (full) {
    s.trajectory = settings_.trajectory;
    s.sensitivities = settings_.sensitivities;
    for (const double t : settings_.times) s.times.push_back(t / time_unit_);
  }
  ContactMotion motion = move_contact_(s);
  evaluations += motion.evaluations;
  return motion;
}

/// The outcome is no matter of numerical errors, and e, or e^2 of a stuck pair, is as wanted.
bool Convergence::certain(double wanted) const {
  const double e2 = last.e_squared;
  if (!sign_is_certain()) return false;
  if (last.outcome == CollisionOutcome::stick) return error <= wanted * std::max(1.0, std::abs(e2));
  return error_of_e(e2, error) <= wanted;
}

/// Error of e^2 by the result of a coarser tolerance, and the energy that is not accounted for.
/// Without adhesion a collision that loses nearly all is damped, and so are its errors: they are as
/// e^2.
double Convergence::difference(const ContactMotion& before) const {
  const double scale = last.adhesive ? std::max(1.0, 2 / (w0_ * w0_)) : last.e_squared;
  return std::abs(last.e_squared - before.e_squared) + (last.residual + 4e-15) * scale;
}

void Convergence::run() {
  double tolerance = std::min(first_tolerance(settings_.tolerance), 1e-3);
  last = once(tolerance, false);
  bool same = false;
  while (tolerance > finest_tolerance) {
    const ContactMotion before = std::move(last);
    tolerance *= finer;
    last = once(tolerance, false);
    if (!resolved(last) && std::chrono::steady_clock::now() > deadline_) break;
    same = resolved(last) && last.outcome == before.outcome;
    error = difference(before);
    if (same && certain(settings_.tolerance)) break;
  }
  if (resolved(last) && !(same && sign_is_certain())) {
    last.outcome = CollisionOutcome::unresolved;
    last.reason = too_close;
  }
  if (!resolved(last) || !(settings_.trajectory || settings_.sensitivities)) return;
  // Between its ends a step is only as good as its embedded error.
  last = once(settings_.times.empty() ? tolerance : std::min(tolerance, settings_.tolerance), true);
}

Eigen::VectorXd by_input(const ContactMotion::Gradient& by_scaled,
                         const std::vector<Parameter>& scaled) {
  Parameter::Gradient sum = Parameter::Gradient::Zero();
  for (std::size_t k = 0; k < scaled.size(); ++k) {
    const double by = by_scaled[static_cast<Eigen::Index>(k)];
    if (by != 0) sum += by * scaled[k].gradient;  // no derivative of what is left out
  }
  return sum;
}

CollisionSensitivities sensitivities(const ContactMotion& motion, const ContactScales& scales,
                                     const std::vector<Parameter>& scaled) {
  CollisionSensitivities s;
  s.e_squared = by_input(motion.by_e_squared, scaled);
  s.delta_max =
      scales.delta.value * by_input(motion.by_d_max, scaled) + motion.d_max * scales.delta.gradient;
  s.t_max =
      scales.time.value * by_input(motion.by_t_max, scaled) + motion.t_max * scales.time.gradient;
  return s;
}

void in_units(Collision& c, const ContactMotion& motion, const ContactScales& scales) {
  c.delta_max = motion.d_max * scales.delta.value;
  c.t_max = motion.t_max * scales.time.value;
  c.contact_time = motion.t_end * scales.time.value;
  c.a_max = motion.u_max * scales.radius.value;
  c.p_c_max = scales.centre_pressure(motion.u_max);
  for (const ContactMotion::Point& p : motion.trajectory)
    c.trajectory.push_back({p.t * scales.time.value, p.d * scales.delta.value,
                            p.w * scales.speed().value, p.u * scales.radius.value,
                            p.f * scales.force.value});
}

void set_e(Collision& c, double e_squared, double error) {
  const bool stick = c.outcome == CollisionOutcome::stick;
  c.e_squared = e_squared;
  c.e_squared_error = error;
  c.e = stick ? 0 : std::sqrt(std::max(e_squared, 0.0));
  c.e_error = stick ? 0 : error_of_e(e_squared, error);
}

Collision converge(const std::vector<Parameter>& scaled, const ContactScales& scales,
                   const CollisionSettings& settings, const MoveContact& move_contact) {
  Collision c;
  for (const Parameter& p : scaled)
    if (!std::isfinite(p.value)) {
      c.reason = "the parameters are too far apart for double precision";
      return c;
    }
  Convergence convergence(settings, scaled[0].value, scales.time.value, move_contact);
  convergence.run();
  const ContactMotion& motion = convergence.last;
  c.outcome = motion.outcome;
  c.reason = motion.reason;
  c.evaluations = convergence.evaluations;
  c.energy_residual = motion.residual;
  if (!resolved(motion)) return c;
  set_e(c, motion.e_squared, convergence.error);
  in_units(c, motion, scales);
  if (settings.sensitivities) c.sensitivities = sensitivities(motion, scales, scaled);
  return c;
}

}  // namespace

Collision collide_with_crack(const CrackContact& kind, const std::vector<Parameter>& scaled,
                             const ContactScales& scales, const CollisionSettings& settings) {
  CrackContact contact = kind;
  contact.w0 = scaled[0].value;
  contact.lam = scaled[1].value;
  contact.kap = scaled[2].value;
  contact.b = scaled[3].value;
  contact.zeta = scaled[4].value;
  return converge(scaled, scales, settings,
                  [&](const MotionSettings& s) { return move(contact, s); });
}

Collision collide_on_curve(const CurveContact& kind, const std::vector<Parameter>& scaled,
                           const ContactScales& scales, const CollisionSettings& settings) {
  CurveContact contact = kind;
  contact.adhesive = scales.adhesive;
  contact.w0 = scaled[0].value;
  for (std::size_t k = 0; k < contact.p.size(); ++k) contact.p[k] = scaled[k + 1].value;
  return converge(scaled, scales, settings,
                  [&](const MotionSettings& s) { return move(contact, s); });
}

void set_restitution(Collision& c, double e_squared, double error) {
  if (std::abs(e_squared) <= error) {
    c.outcome = CollisionOutcome::unresolved;
    c.reason = too_close;
  } else if (e_squared < 0) {
    c.outcome = CollisionOutcome::stick;
    c.contact_time = Collision::unknown;
  }
  set_e(c, e_squared, error);
}

}  // namespace mdana
