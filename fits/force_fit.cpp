// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/force_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/SVD>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fits/weak_direction.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr double difference_step = 1e-6;  ///< of parameters of order one: right to about 1e-10
constexpr double wall = 100;              ///< residual of a parameter that is 1 beyond its range

/// What of the data is fitted, and what the parameters mean.
struct Problem {
  const ForceLaw& law;
  const ForceData& data;
  const ForceFitSettings& settings;
  std::vector<std::size_t> points;
  double delta_max = 0, force_max = 0;  ///< scales: of delta as of X, whichever is more
  bool known_errors = true;

  /// The contact, and what is added to R1 + R2 - X, for parameters q: logarithms over a start for
  /// the law's own, for R and offset what is added to the start, over delta_max.
  struct State {
    ElasticContact contact;
    double shift = 0;
  };
  State start;

  double delta(std::size_t frame, const State& s) const {
    return data.radius_sum - data.distance[frame] + s.shift;
  }
  double force(std::size_t frame, const State& s) const {
    const double d = delta(frame, s);
    return frame > data.turn ? unloading(law).force(d, s.contact) : law.force(d, s.contact);
  }
  double scale(std::size_t frame) const { return known_errors ? data.error[frame] : force_max; }
};

const ContactParameter* own_parameter(const ForceLaw& law, std::string_view name) {
  const auto at = std::ranges::find(law.parameters, name, &ContactParameter::name);
  return at == law.parameters.end() || name == "R*" ? nullptr : &*at;
}

bool is_shift(std::string_view name) { return name == "R" || name == "offset"; }

void check_free(const ForceLaw& law, const std::vector<std::string>& free) {
  if (free.empty()) throw InputError(fmt::format("law {}: no parameter is free", law.name));
  const auto has = [&](std::string_view n) { return std::ranges::find(free, n) != free.end(); };
  if (has("R") && has("offset"))
    throw InputError("R and offset cannot be free together: both shift delta, and the data cannot "
                     "tell them apart; fix one of them");
  std::vector<std::string_view> known{"R", "offset"};
  for (const ContactParameter& p : law.parameters)
    if (p.name != "R*") known.push_back(p.name);
  for (const std::string& n : free)
    if (std::ranges::find(known, n) == known.end())
      throw InputError(fmt::format("law {} has no free parameter {}; it has {}", law.name, n,
                                   fmt::join(known, ", ")));
}

/// Frames of contact: by the given radii, or with a force of note, since radii may be too small.
std::vector<std::size_t> choose(const ForceData& data, const ForceFitSettings& s) {
  constexpr double of_note = 0.02;
  double force_max = 0;
  for (const double f : data.force) force_max = std::max(force_max, f);
  std::vector<std::size_t> points;
  double greatest = 0;
  for (const double x : data.distance) greatest = std::max(greatest, data.radius_sum - x);
  const std::size_t end = s.part == ForcePart::loading ? data.turn + 1 : data.force.size();
  for (std::size_t i = 0; i < std::min(end, data.force.size()); ++i) {
    if (!std::isfinite(data.force[i]) || !std::isfinite(data.distance[i]))
      throw InputError(fmt::format("force fit: distance or force of frame {} is not finite", i));
    const double delta = data.radius_sum - data.distance[i];
    if (delta > s.min_delta_fraction * greatest ||
        (s.min_delta_fraction == 0 && data.force[i] > of_note * force_max))
      points.push_back(i);
  }
  return points;
}

/// Of order of what the data can mean: E* from the greatest force, gamma from the least.
ElasticContact first_guess(const Problem& p, const std::vector<std::string>& free) {
  ElasticContact c = p.settings.constants;
  c.radius = p.data.reduced_radius;
  const auto is_free = [&](std::string_view n) { return std::ranges::find(free, n) != free.end(); };
  const double root = std::sqrt(p.data.reduced_radius) * std::sqrt(p.delta_max);
  if (is_free("E*")) c.modulus = 0.75 * p.force_max / (root * p.delta_max);
  double least = -0.01 * p.force_max;
  for (const std::size_t i : p.points) least = std::min(least, p.data.force[i]);
  if (is_free("gamma")) c.surface_energy = -least / (3 * std::numbers::pi * c.radius);
  if (is_free("Y")) c.yield_strength = 0.2 * c.modulus;
  if (is_free("spacing")) c.spacing = 0.1 * p.delta_max;
  return c;
}

Problem::State state(const Problem& p, std::span<const double> q) {
  Problem::State s = p.start;
  for (std::size_t k = 0; k < q.size(); ++k) {
    const std::string& name = p.settings.free[k];
    if (!is_shift(name)) {
      s.contact.*(own_parameter(p.law, name)->value) *= std::exp(q[k]);
      continue;
    }
    s.shift = p.start.shift + q[k] * p.delta_max;
    if (name == "R") s.contact.radius *= (p.data.radius_sum + s.shift) / p.data.radius_sum;
  }
  s.contact.delta_max = 0;
  for (const std::size_t i : p.points) s.contact.delta_max = std::max(s.contact.delta_max, p.delta(i, s));
  return s;
}

double residual_at(const Problem& p, std::size_t point, std::span<const double> q) {
  const std::size_t frame = p.points[point];
  return (p.force(frame, state(p, q)) - p.data.force[frame]) / p.scale(frame);
}

/// How far a parameter is out of its range, signed: a factor of 1000 about the guess, or twice the scale
/// of delta.
double beyond(const std::string& name, double q) {
  const double most = is_shift(name) ? 2 : 7;
  return q < -most ? q + most : std::max(0.0, q - most);
}

/// Of the data, then of the ranges of the parameters.
PointResidual residual_of(const Problem& p) {
  return [&p](std::size_t point, std::span<const double> q, double& r, std::span<double> g) {
    if (point >= p.points.size()) {
      const std::size_t k = point - p.points.size();
      r = wall * beyond(p.settings.free[k], q[k]);
      std::ranges::fill(g, 0.0);
      if (r != 0 && !g.empty()) g[k] = wall;
      return true;
    }
    r = residual_at(p, point, q);
    std::vector<double> moved(q.begin(), q.end());
    for (std::size_t k = 0; k < g.size(); ++k) {
      moved[k] = q[k] + difference_step;
      const double above = residual_at(p, point, moved);
      moved[k] = q[k] - difference_step;
      g[k] = (above - residual_at(p, point, moved)) / (2 * difference_step);
      moved[k] = q[k];
    }
    return std::isfinite(r);
  };
}

/// Of all starts the best optimum: the parameters of the law begin at their guess, and a factor away.
Fit best_fit(const Problem& p) {
  const std::size_t n = p.settings.free.size();
  const FitSettings solver{p.settings.loss, p.known_errors ? 1.0 : 0.01, p.known_errors, n};
  std::optional<Fit> best;
  double least = 0;
  for (std::size_t k = 0; k <= 2 * n; ++k) {
    std::vector<double> q(n, 0.0);
    if (k > 0 && !is_shift(p.settings.free[(k - 1) / 2])) q[(k - 1) / 2] = k % 2 ? 1.5 : -1.5;
    Fit fit = solve_least_squares(residual_of(p), p.points.size() + n, q, solver);
    double cost = 0;
    for (const double r : fit.residuals) cost += r * r;
    if (!std::isfinite(cost) || (best && !(cost < least))) continue;
    least = cost;
    best = std::move(fit);
  }
  if (!best) throw InputError("force fit: the law cannot be evaluated at these data");
  return *std::move(best);
}

ForceEstimate estimate(const Problem& p, const Problem::State& s, const std::string& name, double error) {
  if (name == "R")
    return {name, (p.data.radius_sum + s.shift) / 2, error * p.delta_max / 2, dimension::length};
  if (name == "offset") return {name, s.shift, error * p.delta_max, dimension::length};
  const ContactParameter& own = *own_parameter(p.law, name);
  const double value = s.contact.*own.value;
  return {name, value, error * value, own.dimension};
}

void describe(ForceFit& f, const Problem& p) {
  const Problem::State s = state(p, f.fit.values);
  f.contact = s.contact;
  const bool r = std::ranges::find(p.settings.free, "R") != p.settings.free.end();
  f.radius_sum = p.data.radius_sum + (r ? s.shift : 0);
  f.offset = r ? 0 : s.shift;
  const Eigen::VectorXd error = f.fit.covariance.diagonal().cwiseMax(0).cwiseSqrt();
  for (std::size_t k = 0; k < p.settings.free.size(); ++k)
    f.parameters.push_back(estimate(p, s, p.settings.free[k], error[static_cast<Eigen::Index>(k)]));
  f.correlation = error.cwiseInverse().asDiagonal() * f.fit.covariance * error.cwiseInverse().asDiagonal();
  f.singular_values = f.fit.singular_values;
  double squares = 0;
  for (const std::size_t i : p.points) {
    f.model.push_back(p.force(i, s));
    squares += std::pow((f.model.back() - p.data.force[i]) / p.force_max, 2);
  }
  f.fit.residuals.resize(p.points.size());
  for (const double x : f.fit.residuals) f.chi2 += x * x;
  f.rms_residual = std::sqrt(squares / static_cast<double>(p.points.size()));
}

/// The Jacobian's right singular vectors, from the covariance.
void name_weak_direction(ForceFit& f, const Problem& p) {
  const auto n = static_cast<Eigen::Index>(p.settings.free.size());
  Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(p.points.size()), n);
  const PointResidual residual = residual_of(p);
  std::vector<double> row(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    double r = 0;
    residual(i, f.fit.values, r, row);
    jacobian.row(static_cast<Eigen::Index>(i)) = Eigen::Map<Eigen::VectorXd>(row.data(), n);
  }
  if (!jacobian.allFinite()) return;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullV);
  f.weak_direction = describe_weak_direction(p.settings.free, svd.matrixV(), svd.singularValues());
}

void judge(ForceFit& f, const Problem& p) {
  for (std::size_t k = 0; k < p.settings.free.size(); ++k)
    if (beyond(p.settings.free[k], f.fit.values[k]) != 0) {
      f.fit.usable = false;
      f.fit.reason = fmt::format("{} ran out of its range: the law does not describe these data",
                                 p.settings.free[k]);
      return;
    }
  if (!f.fit.usable) {
    if (!f.weak_direction.empty()) f.fit.reason += ": " + f.weak_direction;
    return;
  }
  for (const ForceEstimate& e : f.parameters)
    if (e.name != "offset" && !(e.error < std::abs(e.value)))
      f.fit.reason = fmt::format("{} is not determined (its standard error is greater than itself)", e.name);
  f.fit.usable = f.fit.reason.empty();
}

}  // namespace

std::string_view name(ForcePart part) { return part == ForcePart::loading ? "loading" : "loop"; }

std::vector<std::string> usual_free_parameters(const ForceLaw& law) {
  std::vector<std::string> free;
  for (const ContactParameter& p : law.parameters)
    if (p.name != "R*") free.emplace_back(p.name);
  free.push_back("R");
  return free;
}

ForceFit fit_force(const ForceLaw& law, const ForceData& data, const ForceFitSettings& settings) {
  check_free(law, settings.free);
  Problem p{law, data, settings, choose(data, settings), 0, 0, true, {}};
  if (p.points.size() <= settings.free.size())
    throw InputError(fmt::format("force fit: {} frames of contact in {}; at least {} are needed for {} "
                                 "parameters. Dump more often, or fit the loop", p.points.size(),
                                 name(settings.part), settings.free.size() + 1, settings.free.size()));
  for (const std::size_t i : p.points) {
    p.delta_max = std::max({p.delta_max, data.radius_sum - data.distance[i],
                            data.distance[p.points.front()] - data.distance[i]});
    p.force_max = std::max(p.force_max, std::abs(data.force[i]));
    p.known_errors = p.known_errors && i < data.error.size() && data.error[i] > 0;
  }
  if (!(p.force_max > 0)) throw InputError("force fit: all forces are zero");
  p.start.contact = first_guess(p, settings.free);
  if (std::ranges::any_of(settings.free, is_shift))  // bodies may touch before the radii given say so
    p.start.shift = std::max(0.0, data.distance[p.points.front()] - data.radius_sum);
  require_parameters(law, p.start.contact);
  ForceFit f;
  f.points = p.points;
  f.known_errors = p.known_errors;
  f.fit = best_fit(p);
  describe(f, p);
  name_weak_direction(f, p);
  judge(f, p);
  return f;
}

}  // namespace mdana
