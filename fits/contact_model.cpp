// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/contact_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fits/predicted_motion.hpp"
#include "fits/usual_parameters.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

/// Elastic collision (P1 eqs 2-4, 15): delta_max and what follows from it.
struct Elastic {
  double delta, contact_radius, time, force, pressure;

  explicit Elastic(const Impact& i)
      : delta(i.radius * std::pow(15.0 / 16.0 * (i.mass / (i.radius * i.radius * i.radius)) *
                                      (i.velocity * (i.velocity / i.modulus)), 0.4)),
        contact_radius(std::sqrt(i.radius * delta)),
        time(2.943 * delta / i.velocity),
        force(4.0 / 3.0 * i.modulus * contact_radius * delta),
        pressure(2 * contact_radius / (std::numbers::pi * i.radius)) {}
};

/// Where the free part of an input is: a number of the impact, or of the law's own.
double* find(const CollisionLaw& law, CollisionInput& input, std::string_view name) {
  if (name == "E") return &input.impact.modulus;
  if (name == "R") return &input.impact.radius;
  if (const auto k = parameter_index(law, name)) return &input.values[*k];
  return nullptr;
}

/// Its column among CollisionSensitivities.
Eigen::Index column(const CollisionLaw& law, std::string_view name) {
  if (name == "R") return 0;
  if (name == "E") return 2;
  return static_cast<Eigen::Index>(4 + *parameter_index(law, name));
}

double mean_logarithm(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += std::log(v);
  return std::exp(sum / static_cast<double>(values.size()));
}

}  // namespace

std::string ContactModel::Target::name() const {
  return radius ? fmt::format("{}(R={:g})", parameter, *radius) : parameter;
}

ContactModel::ContactModel(const CollisionLaw& law, std::span<const ObservedCollision> seen,
                           const ContactFitSettings& settings)
    : law_(law), seen_(seen), free_(settings.free) {
  if (seen.empty()) throw InputError("there are no collisions to fit");
  std::vector<NamedNumber> constants = settings.constants;
  for (const FreeParameter& f : free_) constants.push_back({f.name, f.start.value_or(0.5)});
  for (const ObservedCollision& s : seen) {
    for (const FreeParameter& f : free_)
      if (s.find(f.name))
        throw InputError(fmt::format("{}: {} is given, so it cannot be free", s.place, f.name));
    inputs_.push_back(input_of(law, s, constants));
  }
  for (const FreeParameter& f : free_)
    if (!find(law, inputs_.front(), f.name))
      throw InputError(fmt::format("law {} has no parameter {} that can be free", law.name, f.name));
  add_targets(settings);
  add_terms();
  add_scales();
  predictions_.resize(seen.size());
}

void ContactModel::add_targets(const ContactFitSettings& settings) {
  std::set<double> radii;
  for (const ObservedCollision& s : seen_)
    if (const auto r = s.find("R")) radii.insert(*r);
  for (std::size_t k = 0; k < settings.free.size(); ++k) {
    const FreeParameter& f = settings.free[k];
    if (!f.per_radius) {
      targets_.push_back({k, f.name, {}});
      continue;
    }
    if (radii.empty()) throw InputError(fmt::format("{} per radius: the data have no R", f.name));
    for (const double r : radii) targets_.push_back({k, f.name, r});
  }
}

/// The error of a sticking collision that has none of its own: the median of the others.
double ContactModel::usual_error() const {
  std::vector<double> errors;
  for (const ObservedCollision& s : seen_)
    if (!s.stuck && s.e.error > 0) errors.push_back(s.e.error);
  if (errors.empty()) return 0;
  const auto middle = errors.begin() + static_cast<long>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle;
}

void ContactModel::add_term(std::size_t seen, Quantity quantity, const Measured& m, double unknown_error,
                            std::size_t sample) {
  if (!m.known()) return;
  known_errors_ = known_errors_ && m.error > 0;
  terms_.push_back({seen, quantity, sample, m.value, m.error, unknown_error,
                    seen_[seen].stuck && quantity == Quantity::e_squared});
}

/// Of a sticking collision, whatever its e.
void ContactModel::add_e_squared(std::size_t seen, double usual_error) {
  Measured e = seen_[seen].e;
  if (seen_[seen].stuck) e = {0, e.error > 0 ? e.error : usual_error};
  add_term(seen, Quantity::e_squared, {e.value * e.value, 2 * std::max(e.value, e.error) * e.error}, 1);
}

void ContactModel::add_motion(std::size_t seen) {
  const std::vector<MotionSample>& motion = seen_[seen].motion;
  for (const MotionSample& m : motion) times_[seen].push_back(m.time);
  for (const auto& [quantity, of] : {std::pair{Quantity::delta, &MotionSample::delta},
                                     {Quantity::velocity, &MotionSample::velocity},
                                     {Quantity::force, &MotionSample::force}}) {
    double greatest = 0;
    for (const MotionSample& m : motion)
      if ((m.*of).known()) greatest = std::max(greatest, std::abs((m.*of).value));
    for (std::size_t i = 0; i < motion.size(); ++i) add_term(seen, quantity, motion[i].*of, greatest, i);
  }
}

void ContactModel::add_terms() {
  const double usual = usual_error();
  times_.resize(seen_.size());
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    add_e_squared(i, usual);
    add_term(i, Quantity::delta_max, seen_[i].delta_max, seen_[i].delta_max.value);
    add_term(i, Quantity::t_max, seen_[i].t_max, seen_[i].t_max.value);
    add_motion(i);
  }
  if (!known_errors_)
    for (Term& t : terms_) t.error = t.unknown_error;
}

/// What is known of the elastic collision; a modulus that is to be found, from the greatest compression.
Impact ContactModel::scales_of(std::size_t seen) const {
  Impact impact = inputs_[seen].impact;
  double greatest = seen_[seen].delta_max.known() ? seen_[seen].delta_max.value : 0;
  for (const MotionSample& m : seen_[seen].motion) greatest = std::max(greatest, m.delta.value);
  if (std::ranges::find(free_, "E", &FreeParameter::name) != free_.end() && greatest > 0)
    impact.modulus = 15.0 / 16.0 * impact.mass * impact.velocity * impact.velocity /
                     (std::pow(greatest, 2.5) * std::sqrt(impact.radius));
  return impact;
}

void ContactModel::add_scales() {
  std::vector<double> radius, velocity, modulus, mass;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Impact impact = scales_of(i);
    radius.push_back(impact.radius);
    velocity.push_back(impact.velocity);
    modulus.push_back(impact.modulus);
    mass.push_back(impact.mass);
  }
  const Impact mean{mean_logarithm(radius), mean_logarithm(mass), mean_logarithm(modulus),
                    mean_logarithm(velocity)};
  const Elastic elastic(mean);
  scales_ = {mean.radius, mean.velocity, mean.modulus, mean.mass, elastic.time,
             elastic.contact_radius, elastic.force, elastic.pressure};
}

/// v^alpha a^beta at the scales of the data.
double ContactModel::power_unit() const {
  CollisionInput in = inputs_.front();
  return std::pow(scales_.velocity, *find(law_, in, "alpha")) * std::pow(scales_.contact_radius, *find(law_, in, "beta"));
}

std::vector<Unknown> ContactModel::unknowns() const {
  std::vector<Unknown> unknowns;
  for (const Target& target : targets_) {
    const FreeParameter& f = free_[target.free];
    auto [least, greatest] = usual_range(target.parameter, scales_);
    if (f.name == "D") least /= power_unit(), greatest /= power_unit();
    Unknown u{target.name(), f.least.value_or(std::min(least, f.start ? *f.start / 10 : least)),
              f.greatest.value_or(std::max(greatest, f.start ? *f.start * 10 : greatest)),
              f.start.value_or(0), f.least || f.greatest};
    if (!(u.least > 0 && u.least < u.greatest && std::isfinite(u.greatest)))
      throw InputError(fmt::format("{}: bounds {:g} to {:g}: 0 < least < greatest is needed",
                                   target.name(), u.least, u.greatest));
    unknowns.push_back(std::move(u));
  }
  return unknowns;
}

bool ContactModel::only_sticking() const { return std::ranges::all_of(terms_, &Term::stuck); }

void ContactModel::set_tolerance(double tolerance) {
  if (tolerance == collision_settings_.tolerance) return;
  collision_settings_.tolerance = tolerance;
  predictions_.assign(seen_.size(), {});
}

std::optional<std::size_t> ContactModel::target_of(std::size_t seen, std::size_t free) const {
  for (std::size_t k = 0; k < targets_.size(); ++k)
    if (targets_[k].free == free && (!targets_[k].radius || targets_[k].radius == seen_[seen].find("R")))
      return k;
  return std::nullopt;
}

CollisionInput ContactModel::input(std::size_t seen, const Eigen::VectorXd& ln) const {
  CollisionInput in = inputs_[seen];
  for (std::size_t f = 0; f < free_.size(); ++f)
    if (const auto target = target_of(seen, f)) {
      const double value = std::exp(ln[static_cast<Eigen::Index>(*target)]);
      *find(law_, in, free_[f].name) = free_[f].name == "R" ? value / 2 : value;
    }
  return in;
}

Eigen::Index ContactModel::index_of(const Term& t) {
  const auto q = static_cast<Eigen::Index>(t.quantity);
  return q < 3 ? q : q + 3 * static_cast<Eigen::Index>(t.sample);
}

/// The values of a Prediction.
Eigen::VectorXd ContactModel::numbers(std::size_t seen, const Collision& c, const CollisionInput& in) const {
  const std::vector<double>& times = times_[seen];
  Eigen::VectorXd values(3 + 3 * static_cast<Eigen::Index>(times.size()));
  values.head<3>() << c.e_squared, c.delta_max, c.t_max;
  Eigen::Index row = 3;
  for (const CollisionPoint& p : predicted_motion(c, in.impact.velocity, times)) {
    values.segment<3>(row) << p.delta, p.velocity, p.force;
    row += 3;
  }
  return values;
}

/// The same for a law without sensitivities, and for motions, which have none: central differences, right
/// to about 1e-6.
void ContactModel::difference(std::size_t seen, Prediction& p) const {
  constexpr double step = 1e-3;
  CollisionSettings settings = settings_for(seen);
  settings.tolerance = std::min(settings.tolerance, 1e-10);
  for (std::size_t f = 0; f < free_.size(); ++f) {
    const auto target = target_of(seen, f);
    if (!target) continue;
    const auto k = static_cast<Eigen::Index>(*target);
    for (const double side : {step, -step}) {
      Eigen::VectorXd ln = p.ln;
      ln[k] += side;
      const CollisionInput in = input(seen, ln);
      p.by_ln.col(k) += numbers(seen, collide(law_, in, settings), in) / (2 * side);
      ++collisions_;
    }
  }
}

/// d/d ln p of what is predicted.
void ContactModel::differentiate(const Collision& c, const CollisionInput& in, std::size_t seen,
                                 Prediction& p) const {
  p.by_ln = Eigen::MatrixXd::Zero(p.values.size(), static_cast<Eigen::Index>(targets_.size()));
  if (!c.sensitivities) return difference(seen, p);
  const Eigen::VectorXd* by_value[3] = {&c.sensitivities->e_squared, &c.sensitivities->delta_max,
                                        &c.sensitivities->t_max};
  CollisionInput copy = in;
  for (std::size_t f = 0; f < free_.size(); ++f) {
    const auto target = target_of(seen, f);
    if (!target) continue;
    const double value = *find(law_, copy, free_[f].name);
    for (Eigen::Index q = 0; q < 3; ++q)
      if (by_value[q]->size() > 0)
        p.by_ln(q, static_cast<Eigen::Index>(*target)) = value * (*by_value[q])[column(law_, free_[f].name)];
  }
}

CollisionSettings ContactModel::settings_for(std::size_t seen) const {
  CollisionSettings settings = collision_settings_;
  settings.trajectory = !times_[seen].empty();
  for (const double t : times_[seen])
    if (t >= 0) settings.times.push_back(t);
  return settings;
}

const ContactModel::Prediction& ContactModel::predict(std::size_t seen, const Eigen::VectorXd& ln,
                                                      Derivatives wanted) const {
  Prediction& p = predictions_[seen];
  const bool needed = wanted == Derivatives::all;
  if (ln.size() > 0 && p.ln.size() == ln.size() && p.ln == ln && (p.with_derivatives || !needed)) return p;
  p.ln = ln;
  const CollisionInput in = input(seen, ln);
  CollisionSettings settings = settings_for(seen);
  settings.sensitivities = wanted != Derivatives::none && !settings.trajectory;
  Collision c;
  try {
    c = collide(law_, in, settings);
  } catch (const InputError& error) {  // a start or a step beyond what the law can take
    c.reason = error.what();
  }
  ++collisions_;
  p.values = numbers(seen, c, in);
  p.resolved = c.outcome != CollisionOutcome::unresolved;
  if (!p.resolved) failure_ = c.reason;
  p.with_derivatives = needed || c.sensitivities.has_value();
  if (p.resolved && p.with_derivatives) differentiate(c, in, seen, p);
  return p;
}

double ContactModel::predicted(std::size_t k, const Eigen::VectorXd& ln) const {
  const Prediction& p = predict(terms_[k].seen, ln, Derivatives::none);
  return p.resolved ? p.values[index_of(terms_[k])] : Collision::unknown;
}

/// What one unit of a residual is in its quantity.
double ContactModel::scale_of(const Term& t) const {
  return std::max(t.error, least_error_ * t.unknown_error);
}

bool ContactModel::residual(std::size_t k, const Eigen::VectorXd& ln, double& r,
                            Eigen::VectorXd* by_ln) const {
  const Term& t = terms_[k];
  const Prediction& p = predict(t.seen, ln, by_ln ? Derivatives::all : Derivatives::if_cheap);
  const Eigen::Index q = index_of(t);
  const double value = p.values[q];
  if (!p.resolved || !std::isfinite(value)) return false;
  const bool satisfied = t.stuck && value <= 0;
  const double scale = scale_of(t);
  r = satisfied ? 0 : (value - t.value) / scale;
  if (by_ln && !p.by_ln.row(q).allFinite()) return false;
  if (by_ln)
    *by_ln = satisfied ? Eigen::VectorXd::Zero(ln.size()) : Eigen::VectorXd(p.by_ln.row(q) / scale);
  return true;
}

double ContactModel::residual(std::size_t k, const Eigen::VectorXd& ln) const {
  const Term& t = terms_[k];
  const double value = predicted(k, ln);
  return t.stuck && value <= 0 ? 0 : (value - t.value) / scale_of(t);
}

Eigen::MatrixXd ContactModel::jacobian(const Eigen::VectorXd& ln) const {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(residuals()), ln.size());
  for (std::size_t k = 0; k < residuals(); ++k) {
    double r = 0;
    Eigen::VectorXd row;
    if (residual(k, ln, r, &row)) all.row(static_cast<Eigen::Index>(k)) = row;
  }
  return all;
}

}  // namespace mdana
