// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/contact_fit.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <fmt/format.h>

#include "fits/contact_model.hpp"
#include "fits/weak_direction.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr double wall = 100;        ///< residual of a q that is 1 beyond its range
constexpr double same = 1e-4;       ///< minima whose ln parameters differ by less are one
constexpr double least_known = 1.0; ///< greatest standard error of a ln parameter that is determined

/// All residuals of one fit: of the data, of priors, and those that keep q within its range.
class Residuals {
 public:
  Residuals(const ContactModel& model, const FitCoordinates& coordinates,
            std::vector<std::pair<std::size_t, Measured>> priors)
      : model_(model), coordinates_(coordinates), priors_(std::move(priors)) {}

  std::size_t count() const { return model_.residuals() + undamped(); }
  std::size_t undamped() const { return priors_.size() + 2 * coordinates_.size(); }

  bool operator()(std::size_t point, std::span<const double> q, double& r, std::span<double> g) const {
    const Eigen::VectorXd ln = coordinates_.logarithms(q);
    if (!ln.allFinite()) return false;
    Eigen::VectorXd by_ln;
    bool defined = true;
    if (point < model_.residuals())
      defined = model_.residual(point, ln, r, g.empty() ? nullptr : &by_ln);
    else if (point < model_.residuals() + priors_.size())
      prior(point - model_.residuals(), ln, r, by_ln);
    else
      return range(static_cast<Eigen::Index>(point - model_.residuals() - priors_.size()), q, r, g);
    if (defined && !g.empty())
      Eigen::Map<Eigen::VectorXd>(g.data(), by_ln.size()) =
          coordinates_.derivatives(q).transpose() * by_ln;
    return defined;
  }

 private:
  void prior(std::size_t k, const Eigen::VectorXd& ln, double& r, Eigen::VectorXd& by_ln) const {
    const auto& [unknown, known] = priors_[k];
    const auto i = static_cast<Eigen::Index>(unknown);
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
  std::vector<std::pair<std::size_t, Measured>> priors_;  ///< of which unknown
};

struct Optimum {
  Fit fit;
  Eigen::VectorXd ln;
  double cost = 0;
  int starts = 1;
};

double cost_of(const Fit& fit, Loss loss) {
  double cost = 0;
  for (const double r : fit.residuals) {
    const double s = r * r;
    if (loss == Loss::huber) cost += s > 1 ? 2 * std::sqrt(s) - 1 : s;
    else if (loss == Loss::cauchy) cost += std::log1p(s);
    else cost += s;
  }
  return cost;
}

/// The distinct optima that the starts led to, best first.
std::vector<Optimum> distinct(std::vector<Optimum> all) {
  std::ranges::sort(all, {}, &Optimum::cost);
  std::vector<Optimum> optima;
  for (Optimum& o : all) {
    if (!std::isfinite(o.cost) || !o.ln.allFinite()) continue;
    const auto known = std::ranges::find_if(
        optima, [&](const Optimum& k) { return (k.ln - o.ln).cwiseAbs().maxCoeff() < same; });
    if (known == optima.end())
      optima.push_back(std::move(o));
    else
      ++known->starts;
  }
  return optima;
}

std::vector<double> plain(const Eigen::VectorXd& ln) {
  const Eigen::VectorXd values = ln.array().exp();
  return {values.begin(), values.end()};
}

/// What the optimum says of the parameters themselves.
void describe(ContactFit& result, const ContactModel& model, const FitCoordinates& coordinates,
              const Optimum& best) {
  const Eigen::MatrixXd by = coordinates.derivatives(best.fit.values);
  const Eigen::MatrixXd covariance = by * best.fit.covariance * by.transpose();
  const Eigen::VectorXd error = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  const auto values = plain(best.ln);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const ContactModel::Target& target = model.targets()[k];
    result.parameters.push_back(
        {target.parameter, target.radius, values[k], values[k] * error[static_cast<Eigen::Index>(k)]});
  }
  result.correlation =
      error.cwiseInverse().asDiagonal() * covariance * error.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd jacobian = model.jacobian(best.ln);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullV);
  result.singular_values.assign(svd.singularValues().begin(), svd.singularValues().end());
  std::vector<std::string> names;
  for (const auto& target : model.targets()) names.push_back(target.name());
  result.weak_direction = describe_weak_direction(names, svd.matrixV(), svd.singularValues());
}

void score(ContactFit& result, const Optimum& best, std::size_t data) {
  result.residuals.assign(best.fit.residuals.begin(), best.fit.residuals.begin() + static_cast<long>(data));
  for (const double r : result.residuals) result.chi2 += r * r;
  const auto n = static_cast<double>(data), k = static_cast<double>(best.ln.size());
  const double deviance = result.known_errors ? result.chi2 : n * std::log(result.chi2 / n);
  result.aic = deviance + 2 * k;
  result.bic = deviance + k * std::log(n);
  result.digits = best.fit.digits;
}

/// Why the parameters cannot be believed; empty if they can.
std::string doubt(const ContactFit& result, const FitCoordinates& coordinates, const Optimum& best,
                  bool priors) {
  const Eigen::VectorXd beyond = coordinates.beyond(best.fit.values);
  for (Eigen::Index k = 0; k < beyond.size(); ++k)
    if (beyond[k] != 0)
      return fmt::format("the best {} lies on its bound",
                         result.parameters[static_cast<std::size_t>(k) % coordinates.size()].name);
  const auto& s = result.singular_values;
  const bool singular = s.size() < coordinates.size() || !(s.back() > 1e-6 * s.front());
  if (singular && !priors) return "the data do not determine all parameters: " + result.weak_direction;
  if (!best.fit.usable) return best.fit.reason;
  for (const Estimate& p : result.parameters)
    if (!(p.error < least_known * p.value))
      return fmt::format("{} is not determined (its standard error is greater than itself): {}", p.name,
                         result.weak_direction);
  return {};
}

}  // namespace

ContactFit fit_contact(const CollisionLaw& law, std::span<const ObservedCollision> seen,
                       const ContactFitSettings& settings) {
  const auto begin = std::chrono::steady_clock::now();
  const ContactModel model(law, seen, settings);
  const FitCoordinates coordinates(model.unknowns(), model.scales());
  std::vector<std::pair<std::size_t, Measured>> priors;
  for (std::size_t k = 0; k < model.targets().size(); ++k)
    if (const auto& prior = settings.free[model.targets()[k].free].prior) priors.push_back({k, *prior});
  const Residuals residuals(model, coordinates, priors);
  const FitSettings solver{settings.loss, 1, model.known_errors(), residuals.undamped()};

  std::vector<Optimum> all;
  for (int k = 0; k < std::max(1, settings.starts); ++k) {
    Optimum o;
    o.fit = solve_least_squares(std::cref(residuals), residuals.count(),
                                coordinates.start(static_cast<std::size_t>(k)), solver);
    o.ln = coordinates.logarithms(o.fit.values);
    o.cost = cost_of(o.fit, settings.loss);
    all.push_back(std::move(o));
  }
  const std::vector<Optimum> optima = distinct(std::move(all));
  ContactFit result;
  result.known_errors = model.known_errors();
  for (std::size_t i = 0; i < model.residuals(); ++i) result.seen.push_back(model.seen_of(i));
  if (optima.empty()) {
    result.reason = "no start led to an optimum: " + model.failure();
  } else {
    for (const Optimum& o : optima) result.minima.push_back({plain(o.ln), o.cost, o.starts});
    describe(result, model, coordinates, optima.front());
    score(result, optima.front(), model.residuals());
    result.reason = doubt(result, coordinates, optima.front(), !priors.empty());
  }
  result.usable = result.reason.empty();
  result.collisions = model.collisions();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace mdana
