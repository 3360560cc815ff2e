// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/contact_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// From the scales of an elastic collision: where a parameter may be looked for. Wide, since it is
/// only where starts are drawn from.
std::pair<double, double> usual_range(std::string_view name, const CollisionScales& s) {
  const double energy = s.mass * s.velocity * s.velocity / 2;
  if (name == "T_vis" || name == "T_crack" || name == "T") return {1e-4 * s.time, s.time};
  if (name == "C") return {1e-5 * s.time / s.radius, s.time / s.radius};
  if (name == "B") return {0.1 / s.pressure, 4 / s.pressure};
  if (name == "zeta" || name == "alpha" || name == "beta") return {0.5, 6};
  if (name == "D") return {1e-3 * s.force, 10 * s.force};
  if (name == "E") return {0.03 * s.modulus, 30 * s.modulus};
  if (name == "R") return {0.5 * s.radius, 8 * s.radius};
  if (name == "Y") return {1e-3 * s.modulus, s.modulus};
  if (name == "v_Y") return {0.01 * s.velocity, 10 * s.velocity};
  if (name == "nu") return {0.05, 0.5};
  if (name == "spacing") return {0.1 * s.contact_radius, s.contact_radius};
  if (name == "gamma") {  // JKR: the loss 0.7722 F_c delta0 is the energy at about the upper end
    const double r = s.radius;
    const double loss_of_one = 0.7722 * std::pow(9 * std::numbers::pi, 2.0 / 3.0) * std::numbers::pi *
                               std::pow(r, 4.0 / 3.0) * std::pow(s.modulus, -2.0 / 3.0);
    const double most = std::pow(energy / loss_of_one, 0.6);
    return {1e-4 * most, 10 * most};
  }
  return {1e-3, 1e3};
}

double mean_logarithm(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += std::log(v);
  return std::exp(sum / static_cast<double>(values.size()));
}

}  // namespace

std::vector<FreeParameter> usual_free_parameters(const CollisionLaw& law) {
  std::vector<std::string> names;
  if (law.name == "stress") names = {"C", "B", "zeta"};
  else if (law.name == "power") names = {"D", "alpha", "beta"};
  else if (law.name == "jkr") names = {"gamma"};
  else if (law.name == "andrews") names = {"E", "Y"};
  else if (law.name == "krijt-plastic") names = {"T_vis", "v_Y"};
  else if (parameter_index(law, "T_vis")) names = {"T_vis"};
  else if (parameter_index(law, "v_Y")) names = {"v_Y"};
  std::vector<FreeParameter> free;
  for (std::string& name : names) free.push_back({std::move(name), {}, {}, {}, {}, false});
  return free;
}

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

void ContactModel::add_terms() {
  const auto add = [&](std::size_t i, Quantity quantity, const Measured& m, bool stuck) {
    if (!m.known() && !stuck) return;
    const bool error = m.error > 0;
    known_errors_ = known_errors_ && error;
    terms_.push_back({i, quantity, stuck ? 0 : m.value, error ? m.error : 0, stuck});
  };
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    Measured e = seen_[i].e;
    if (seen_[i].stuck && !(e.error > 0)) e.error = usual_error();
    add(i, Quantity::e_squared, e, seen_[i].stuck);
    add(i, Quantity::delta_max, seen_[i].delta_max, false);
    add(i, Quantity::t_max, seen_[i].t_max, false);
  }
  for (Term& t : terms_) {  // the scale of each residual
    const double error = known_errors_ ? t.error : 0;
    if (t.quantity != Quantity::e_squared)
      t.error = known_errors_ ? error : t.value;
    else
      t.error = known_errors_ ? 2 * std::max(t.value, error) * error : 1;
    if (t.quantity == Quantity::e_squared) t.value *= t.value;
  }
}

void ContactModel::add_scales() {
  std::vector<double> radius, velocity, modulus, mass;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    Impact impact = inputs_[i].impact;
    if (std::ranges::find(free_, "E", &FreeParameter::name) != free_.end() && seen_[i].delta_max.known())
      impact.modulus = 15.0 / 16.0 * impact.mass * impact.velocity * impact.velocity /
                       (std::pow(seen_[i].delta_max.value, 2.5) * std::sqrt(impact.radius));
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

std::vector<Unknown> ContactModel::unknowns() const {
  std::vector<Unknown> unknowns;
  for (const Target& target : targets_) {
    const FreeParameter& f = free_[target.free];
    const auto [least, greatest] = usual_range(target.parameter, scales_);
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

/// The same for a law without sensitivities: central differences, right to about 1e-6.
void ContactModel::difference(std::size_t seen, Prediction& p) const {
  constexpr double step = 1e-3;
  CollisionSettings settings = collision_settings_;
  settings.tolerance = std::min(settings.tolerance, 1e-10);
  for (std::size_t f = 0; f < free_.size(); ++f) {
    const auto target = target_of(seen, f);
    if (!target) continue;
    const auto k = static_cast<Eigen::Index>(*target);
    for (const double side : {step, -step}) {
      Eigen::VectorXd ln = p.ln;
      ln[k] += side;
      const Collision c = collide(law_, input(seen, ln), settings);
      ++collisions_;
      p.by_ln[0][k] += c.e_squared / (2 * side);
      p.by_ln[1][k] += c.delta_max / (2 * side);
      p.by_ln[2][k] += c.t_max / (2 * side);
    }
  }
}

/// d/d ln p of the three quantities.
void ContactModel::differentiate(const Collision& c, const CollisionInput& in, std::size_t seen,
                                 Prediction& p) const {
  for (Eigen::VectorXd& by : p.by_ln) by = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(targets_.size()));
  if (!c.sensitivities) return difference(seen, p);
  const Eigen::VectorXd* by_value[3] = {&c.sensitivities->e_squared, &c.sensitivities->delta_max,
                                        &c.sensitivities->t_max};
  CollisionInput copy = in;
  for (std::size_t f = 0; f < free_.size(); ++f) {
    const auto target = target_of(seen, f);
    if (!target) continue;
    const double value = *find(law_, copy, free_[f].name);
    for (std::size_t q = 0; q < 3; ++q)
      if (by_value[q]->size() > 0)
        p.by_ln[q][static_cast<Eigen::Index>(*target)] = value * (*by_value[q])[column(law_, free_[f].name)];
  }
}

const ContactModel::Prediction& ContactModel::predict(std::size_t seen, const Eigen::VectorXd& ln,
                                                      Derivatives wanted) const {
  Prediction& p = predictions_[seen];
  const bool needed = wanted == Derivatives::all;
  if (ln.size() > 0 && p.ln.size() == ln.size() && p.ln == ln && (p.with_derivatives || !needed)) return p;
  p.ln = ln;
  const CollisionInput in = input(seen, ln);
  CollisionSettings settings = collision_settings_;
  settings.sensitivities = wanted != Derivatives::none;
  Collision c;
  try {
    c = collide(law_, in, settings);
  } catch (const InputError& error) {  // a start or a step beyond what the law can take
    c.reason = error.what();
  }
  ++collisions_;
  p.values[0] = c.e_squared;
  p.values[1] = c.delta_max;
  p.values[2] = c.t_max;
  p.resolved = c.outcome != CollisionOutcome::unresolved;
  if (!p.resolved) failure_ = c.reason;
  p.with_derivatives = needed || c.sensitivities.has_value();
  if (p.resolved && p.with_derivatives) differentiate(c, in, seen, p);
  return p;
}

double ContactModel::predicted(std::size_t k, const Eigen::VectorXd& ln) const {
  const Prediction& p = predict(terms_[k].seen, ln, Derivatives::none);
  return p.resolved ? p.values[static_cast<std::size_t>(terms_[k].quantity)] : Collision::unknown;
}

/// What one unit of a residual is in its quantity.
double ContactModel::scale_of(const Term& t) const {
  return std::max(t.error, least_error_ * (t.quantity == Quantity::e_squared ? 1 : t.value));
}

bool ContactModel::residual(std::size_t k, const Eigen::VectorXd& ln, double& r,
                            Eigen::VectorXd* by_ln) const {
  const Term& t = terms_[k];
  const Prediction& p = predict(t.seen, ln, by_ln ? Derivatives::all : Derivatives::if_cheap);
  const auto q = static_cast<std::size_t>(t.quantity);
  const double value = p.values[q];
  if (!p.resolved || !std::isfinite(value)) return false;
  const bool satisfied = t.stuck && value <= 0;
  const double scale = scale_of(t);
  r = satisfied ? 0 : (value - t.value) / scale;
  if (by_ln && !p.by_ln[q].allFinite()) return false;
  if (by_ln)
    *by_ln = satisfied ? Eigen::VectorXd::Zero(ln.size()) : Eigen::VectorXd(p.by_ln[q] / scale);
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
