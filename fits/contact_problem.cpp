// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/contact_problem.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace mdana {
namespace {

constexpr double wall = 100;    ///< residual of a q that is 1 beyond its range
constexpr double outside = 0.5; ///< a trial step farther beyond is not even looked at

/// All residuals of one search: of the data, of priors, and those that keep q within its range.
class Residuals {
 public:
  Residuals(const ContactModel& model, const FitCoordinates& coordinates,
            std::span<const std::pair<std::size_t, Measured>> priors, const ContactPart& part,
            double fixed_ln)
      : model_(model), coordinates_(coordinates), priors_(priors), points_(part.points),
        fixed_(part.fixed), fixed_ln_(fixed_ln) {
    if (!points_.empty()) return;
    points_.resize(model.residuals());
    std::iota(points_.begin(), points_.end(), 0);
  }

  std::size_t count() const { return points_.size() + undamped(); }
  std::size_t undamped() const { return priors_.size() + 2 * coordinates_.size(); }

  /// ln of all parameters.
  Eigen::VectorXd logarithms(std::span<const double> q) const {
    const Eigen::VectorXd some = coordinates_.logarithms(q);
    if (!fixed_) return some;
    const auto k = static_cast<Eigen::Index>(*fixed_), n = some.size();
    Eigen::VectorXd all(n + 1);
    all << some.head(k), fixed_ln_, some.tail(n - k);
    return all;
  }

  bool operator()(std::size_t point, std::span<const double> q, double& r, std::span<double> g) const {
    const Eigen::VectorXd ln = logarithms(q);
    if (!ln.allFinite() || !(coordinates_.beyond(q).cwiseAbs().maxCoeff() <= outside)) return false;
    Eigen::VectorXd by_ln;
    bool defined = true;
    if (point < points_.size())
      defined = model_.residual(points_[point], ln, r, g.empty() ? nullptr : &by_ln);
    else if (point < points_.size() + priors_.size())
      prior(point - points_.size(), ln, r, by_ln);
    else
      return range(static_cast<Eigen::Index>(point - points_.size() - priors_.size()), q, r, g);
    if (defined && !g.empty())
      Eigen::Map<Eigen::VectorXd>(g.data(), static_cast<Eigen::Index>(g.size())) =
          coordinates_.derivatives(q).transpose() * without_fixed(by_ln);
    return defined;
  }

 private:
  Eigen::VectorXd without_fixed(const Eigen::VectorXd& all) const {
    if (!fixed_) return all;
    const auto k = static_cast<Eigen::Index>(*fixed_), n = all.size();
    Eigen::VectorXd some(n - 1);
    some << all.head(k), all.tail(n - 1 - k);
    return some;
  }

  void prior(std::size_t k, const Eigen::VectorXd& ln, double& r, Eigen::VectorXd& by_ln) const {
    const auto& [parameter, known] = priors_[k];
    const auto i = static_cast<Eigen::Index>(parameter);
    r = (std::exp(ln[i]) - known.value) / known.error;
    by_ln = Eigen::VectorXd::Zero(ln.size());
    by_ln[i] = std::exp(ln[i]) / known.error;
  }

  bool range(Eigen::Index k, std::span<const double> q, double& r, std::span<double> g) const {
    const double beyond = coordinates_.beyond(q)[k];
    r = wall * beyond;
    std::ranges::fill(g, 0.0);
    if (beyond == 0 || g.empty()) return true;
    const auto n = static_cast<Eigen::Index>(q.size());
    const Eigen::MatrixXd by = coordinates_.derivatives(q);
    for (Eigen::Index j = 0; j < n; ++j)
      g[static_cast<std::size_t>(j)] = wall * (k < n ? (j == k ? 1.0 : 0.0) : by(k - n, j));
    return true;
  }

  const ContactModel& model_;
  const FitCoordinates& coordinates_;
  std::span<const std::pair<std::size_t, Measured>> priors_;
  std::vector<std::size_t> points_;
  std::optional<std::size_t> fixed_;
  double fixed_ln_;
};

double damped(double r, Loss loss) {
  const double s = r * r;
  if (loss == Loss::huber) return s > 1 ? 2 * std::sqrt(s) - 1 : s;
  return loss == Loss::cauchy ? std::log1p(s) : s;
}

/// The data and priors count; walls are no part of it unless a bound holds the optimum.
double cost_of(const Fit& fit, std::size_t data, Loss loss) {
  double cost = 0;
  for (std::size_t i = 0; i < fit.residuals.size(); ++i)
    cost += i < data ? damped(fit.residuals[i], loss) : fit.residuals[i] * fit.residuals[i];
  return cost;
}

std::vector<std::pair<std::size_t, Measured>> priors_of(const ContactModel& model,
                                                        const ContactFitSettings& settings) {
  std::vector<std::pair<std::size_t, Measured>> priors;
  for (std::size_t k = 0; k < model.targets().size(); ++k)
    if (const auto& prior = settings.free[model.targets()[k].free].prior) priors.push_back({k, *prior});
  return priors;
}

ContactOptimum search(const Residuals& residuals, std::vector<double> q, const FitSettings& settings) {
  ContactOptimum o;
  o.fit = solve_least_squares(std::cref(residuals), residuals.count(), std::move(q), settings);
  o.ln = residuals.logarithms(o.fit.values);
  o.cost = cost_of(o.fit, residuals.count() - residuals.undamped(), settings.loss);
  return o;
}

}  // namespace

ContactProblem::ContactProblem(const CollisionLaw& law, std::span<const ObservedCollision> seen,
                               const ContactFitSettings& settings)
    : model_(law, seen, settings),
      coordinates_(model_.unknowns(), model_.scales()),
      priors_(priors_of(model_, settings)),
      loss_(settings.loss) {}

void ContactProblem::set(const ContactPrecision& precision) {
  model_.set_tolerance(precision.collision);
  model_.set_least_error(precision.least_error);
}

ContactOptimum ContactProblem::solve(std::vector<double> q, const ContactPrecision& precision,
                                     const ContactPart& part) {
  set(precision);
  const Residuals residuals(model_, coordinates_, priors_, part, 0);
  return search(residuals, std::move(q),
                {loss_, 1, model_.known_errors(), residuals.undamped(), precision.solver,
                 std::min(1e-3, std::sqrt(precision.solver)), precision.iterations});
}

ContactOptimum ContactProblem::solve_fixed(const Eigen::VectorXd& ln, std::size_t fixed,
                                           const ContactPrecision& precision) {
  set(precision);
  std::vector<Unknown> others = model_.unknowns();
  std::vector<double> q;
  others.erase(others.begin() + static_cast<long>(fixed));
  for (std::size_t k = 0, i = 0; k < parameters(); ++k) {
    if (k == fixed) continue;
    Unknown& u = others[i++];
    q.push_back(ln[static_cast<Eigen::Index>(k)]);
    u.parameter += " of a profile";  // so that all are logarithms
    u.start = std::exp(q.back());
    u.least = u.bounded ? u.least : std::min(u.least, u.start / 10);
    u.greatest = u.bounded ? u.greatest : std::max(u.greatest, u.start * 10);
  }
  const double fixed_ln = ln[static_cast<Eigen::Index>(fixed)];
  if (others.empty()) return {{}, ln, cost(ln, precision), 1};
  const FitCoordinates logarithms(std::move(others), model_.scales());
  const Residuals residuals(model_, logarithms, priors_, {fixed, {}}, fixed_ln);
  return search(residuals, std::move(q),
                {loss_, 1, model_.known_errors(), residuals.undamped(), precision.solver,
                 std::min(1e-3, std::sqrt(precision.solver)), precision.iterations});
}

double ContactProblem::cost(const Eigen::VectorXd& ln, const ContactPrecision& precision,
                            std::span<const std::size_t> points) {
  set(precision);
  double sum = 0;
  const std::size_t n = points.empty() ? model_.residuals() : points.size();
  for (std::size_t k = 0; k < n; ++k) sum += damped(model_.residual(points.empty() ? k : points[k], ln), loss_);
  for (const auto& [parameter, known] : priors_) {
    const double r = (std::exp(ln[static_cast<Eigen::Index>(parameter)]) - known.value) / known.error;
    sum += r * r;
  }
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

}  // namespace mdana
