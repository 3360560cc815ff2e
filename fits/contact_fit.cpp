// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/contact_fit.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <Eigen/SVD>
#include <fmt/format.h>

#include "fits/contact_intervals.hpp"
#include "fits/contact_problem.hpp"
#include "fits/weak_direction.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr double same = 1e-4;         ///< minima whose ln parameters differ by less are one
constexpr double nearly_same = 0.02;  ///< the same of rough ones
constexpr double hopeless = 1e3;      ///< a rough cost so many times the best is not refined
constexpr double least_known = 1.0;   ///< greatest standard error of a ln parameter that is determined

/// The distinct optima of some, best first.
std::vector<ContactOptimum> distinct(std::vector<ContactOptimum> all, double difference) {
  std::ranges::sort(all, {}, &ContactOptimum::cost);
  std::vector<ContactOptimum> optima;
  for (ContactOptimum& o : all) {
    if (!std::isfinite(o.cost) || !o.ln.allFinite()) continue;
    const auto known = std::ranges::find_if(optima, [&](const ContactOptimum& k) {
      return (k.ln - o.ln).cwiseAbs().maxCoeff() < difference;
    });
    if (known == optima.end())
      optima.push_back(std::move(o));
    else
      known->starts += o.starts;
  }
  return optima;
}

/// Rough searches from all starts, then exact ones from where those ended that are not hopeless.
std::vector<ContactOptimum> search(ContactProblem& problem, const ContactFitSettings& settings) {
  std::vector<ContactOptimum> all;
  for (int k = 0; k < std::max(1, settings.starts); ++k)
    all.push_back(problem.solve(problem.coordinates().start(static_cast<std::size_t>(k)), rough));
  all = distinct(std::move(all), nearly_same);
  const double scale = all.empty() ? 0 : all.front().cost;
  const auto worth = [&](const ContactOptimum& o) {
    return o.cost <= hopeless * (scale + static_cast<double>(problem.model().residuals()));
  };
  for (ContactOptimum& o : all) {
    if (&o != &all.front() && !worth(o)) continue;
    const int starts = o.starts;
    o = problem.solve(std::move(o.fit.values), {settings.tolerance, 1e-16, 200});
    o.starts = starts;
  }
  return distinct(std::move(all), same);
}

std::vector<double> plain(const Eigen::VectorXd& ln) {
  const Eigen::VectorXd values = ln.array().exp();
  return {values.begin(), values.end()};
}

/// What the optimum says of the parameters themselves.
void describe(ContactFit& result, const ContactProblem& problem, const ContactOptimum& best) {
  const ContactModel& model = problem.model();
  const Eigen::MatrixXd by = problem.coordinates().derivatives(best.fit.values);
  const Eigen::MatrixXd covariance = by * best.fit.covariance * by.transpose();
  const Eigen::VectorXd error = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  const auto values = plain(best.ln);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const ContactModel::Target& target = model.targets()[k];
    result.parameters.push_back(
        {target.parameter, target.radius, values[k], values[k] * error[static_cast<Eigen::Index>(k)]});
    names.push_back(target.name());
  }
  result.correlation =
      error.cwiseInverse().asDiagonal() * covariance * error.cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(model.jacobian(best.ln), Eigen::ComputeFullV);
  result.singular_values.assign(svd.singularValues().begin(), svd.singularValues().end());
  result.weak_direction = describe_weak_direction(names, svd.matrixV(), svd.singularValues());
}

void score(ContactFit& result, const ContactProblem& problem, const ContactOptimum& best) {
  const ContactModel& model = problem.model();
  for (std::size_t i = 0; i < model.residuals(); ++i) {
    const double r = best.fit.residuals[i];
    result.points.push_back({model.seen_of(i), model.quantity_of(i), model.predicted(i, best.ln), r});
    result.chi2 += r * r;
  }
  const auto n = static_cast<double>(model.residuals()), k = static_cast<double>(best.ln.size());
  const double deviance = result.known_errors ? result.chi2 : n * std::log(result.chi2 / n);
  result.aic = deviance + 2 * k;
  result.bic = deviance + k * std::log(n);
  result.digits = best.fit.digits;
}

/// Why the parameters cannot be believed; empty if they can.
std::string doubt(const ContactFit& result, const ContactProblem& problem, const ContactOptimum& best) {
  const FitCoordinates& coordinates = problem.coordinates();
  const Eigen::VectorXd beyond = coordinates.beyond(best.fit.values);
  for (Eigen::Index k = 0; k < beyond.size(); ++k)
    if (beyond[k] != 0)
      return fmt::format("the best {} lies on its bound",
                         result.parameters[static_cast<std::size_t>(k) % coordinates.size()].full_name());
  const auto& s = result.singular_values;
  const bool singular = s.size() < coordinates.size() || !(s.back() > 1e-6 * s.front());
  if (singular && !problem.has_priors())
    return "the data do not determine all parameters: " + result.weak_direction;
  if (!best.fit.usable) return best.fit.reason;
  for (const Estimate& p : result.parameters)
    if (!(p.error < least_known * p.value))
      return fmt::format("{} is not determined (its standard error is greater than itself){}{}",
                         p.full_name(), result.weak_direction.empty() ? "" : ": ", result.weak_direction);
  return {};
}

void fit_all(ContactFit& result, ContactProblem& problem, const ContactFitSettings& settings) {
  if (problem.model().only_sticking()) {
    result.reason = "every collision sticks: that bounds the parameters, but determines none";
    return;
  }
  const std::vector<ContactOptimum> optima = search(problem, settings);
  if (optima.empty()) {
    result.reason = "no start led to an optimum: " + problem.model().failure();
    return;
  }
  const ContactOptimum& best = optima.front();
  for (const ContactOptimum& o : optima) result.minima.push_back({plain(o.ln), o.cost, o.starts});
  describe(result, problem, best);
  score(result, problem, best);
  result.reason = doubt(result, problem, best);
  if (result.reason.empty()) add_intervals(result, problem, best, settings.intervals);
}

}  // namespace

std::string Estimate::full_name() const {
  return radius ? fmt::format("{}(R={:g})", name, *radius) : name;
}

ContactFit fit_contact(const CollisionLaw& law, std::span<const ObservedCollision> seen,
                       const ContactFitSettings& settings) {
  const auto begin = std::chrono::steady_clock::now();
  if (settings.free.empty())
    throw InputError(fmt::format("law {}: no parameter is free, so there is nothing to fit", law.name));
  ContactProblem problem(law, seen, settings);
  ContactFit result;
  result.known_errors = problem.model().known_errors();
  fit_all(result, problem, settings);
  result.usable = result.reason.empty();
  result.collisions = problem.model().collisions();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace mdana
