// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/contact_intervals.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <Eigen/QR>
#include <fmt/format.h>

namespace mdana {
namespace {

constexpr std::size_t least_parts = 5;  ///< to draw from
constexpr double open = std::numeric_limits<double>::quiet_NaN();

/// How the least cost rises when one parameter is held.
class Profile {
 public:
  Profile(ContactProblem& problem, const ContactOptimum& best, const Eigen::MatrixXd& covariance,
          std::size_t parameter, double threshold)
      : problem_(problem), best_(best), parameter_(parameter), threshold_(threshold) {
    const auto k = static_cast<Eigen::Index>(parameter);
    sigma_ = std::sqrt(covariance(k, k));
    direction_ = covariance.col(k) / covariance(k, k);
    base_ = parameter_count() == 1 ? problem.cost(best.ln, rough)
                                   : problem.solve_fixed(best.ln, parameter, rough).cost;
  }

  /// The parameter's logarithm on one side (+1, -1) where the cost has risen by the threshold; NaN if
  /// it does not. sqrt of the rise is nearly straight, so the secant of it converges.
  double end(double side) {
    double inner = 0, rise_inner = 0, x = sigma_ * std::sqrt(threshold_);
    double outer = open, rise_outer = open;
    for (int i = 0; i < 24; ++i) {
      const double rise = rise_at(side * x);
      if (std::abs(rise - 1) < 0.01) return value(side * x);
      if (rise < 1) inner = x, rise_inner = rise;
      else outer = x, rise_outer = rise;
      if (!(rise >= 0) || (inner > 20 * sigma_ * std::sqrt(threshold_) && std::isnan(outer))) return open;
      if (!std::isnan(outer) && outer - inner < 1e-3 * sigma_) return value(side * (inner + outer) / 2);
      x = std::isnan(outer) ? inner * std::clamp(1 / std::max(rise_inner, 0.1), 1.1, 3.0)
          : std::isfinite(rise_outer)
              ? inner + (outer - inner) * std::clamp((1 - rise_inner) / (rise_outer - rise_inner), 0.05, 0.95)
              : (inner + outer) / 2;
    }
    return open;
  }

  bool better() const { return better_; }  ///< on the way there was a better optimum

 private:
  Eigen::Index parameter_count() const { return best_.ln.size(); }

  double value(double step) const { return best_.ln[static_cast<Eigen::Index>(parameter_)] + step; }

  /// sqrt(rise of the cost / threshold); infinite where the law cannot be computed.
  double rise_at(double step) {
    const Eigen::VectorXd ln = best_.ln + step * direction_;
    const double cost = problem_.solve_fixed(ln, parameter_, rough).cost;
    if (!std::isfinite(cost)) return std::numeric_limits<double>::infinity();
    if (cost < base_ - 0.05 * threshold_) better_ = true;
    return std::sqrt(std::max(0.0, cost - base_) / threshold_);
  }

  ContactProblem& problem_;
  const ContactOptimum& best_;
  std::size_t parameter_;
  double threshold_;
  double sigma_ = 0, base_ = 0;
  Eigen::VectorXd direction_;
  bool better_ = false;
};

Eigen::MatrixXd covariance_of(const ContactProblem& problem, const ContactOptimum& best) {
  const Eigen::MatrixXd by = problem.coordinates().derivatives(best.fit.values);
  return by * best.fit.covariance * by.transpose();
}

/// By how much the cost has to rise: the quantile squared, in units of the residuals' variance where
/// that is greater than the errors say, or if these are unknown.
double threshold_of(const ContactFit& fit, const ContactOptimum& best, double level) {
  const double freedom = std::max(1.0, static_cast<double>(fit.points.size()) -
                                           static_cast<double>(best.ln.size()));
  const double variance = best.cost / freedom;
  const double quantile = normal_quantile(level);
  return fit.residual_memory * quantile * quantile * (fit.known_errors ? std::max(1.0, variance) : variance);
}

void add_profiles(ContactFit& fit, ContactProblem& problem, const ContactOptimum& best, double level) {
  const Eigen::MatrixXd covariance = covariance_of(problem, best);
  const double threshold = threshold_of(fit, best, level);
  for (std::size_t k = 0; k < fit.parameters.size(); ++k) {
    Estimate& p = fit.parameters[k];
    Profile profile(problem, best, covariance, k, threshold);
    p.profile = {std::exp(profile.end(-1)), std::exp(profile.end(1))};
    for (const auto& [side, end] : {std::pair{"below", p.profile.low}, {"above", p.profile.high}})
      if (std::isnan(end))
        fit.notes.push_back(fmt::format("{}: the data set no limit {}", p.full_name(), side));
    if (profile.better())
      fit.notes.push_back(fmt::format("{}: the profile met a better optimum; use more starts", p.full_name()));
  }
}

/// What is drawn as one: the residuals of an observation, or those of so many samples of a motion that
/// the next ones do not remember them.
std::vector<std::vector<std::size_t>> parts_of(const ContactFit& fit) {
  const auto samples = static_cast<std::size_t>(std::ceil(2 * fit.residual_memory));
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> parts;
  for (std::size_t i = 0; i < fit.points.size(); ++i)
    parts[{fit.points[i].seen, fit.points[i].sample / samples}].push_back(i);
  std::vector<std::vector<std::size_t>> all;
  for (auto& [key, part] : parts) all.push_back(std::move(part));
  return all;
}

/// As many parts as there are, each any of them.
std::vector<std::size_t> draw(const std::vector<std::vector<std::size_t>>& parts, std::mt19937_64& random) {
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& points = parts[random() % parts.size()];  // the bias of % is below 1e-15
    drawn.insert(drawn.end(), points.begin(), points.end());
  }
  return drawn;
}

/// Where the drawn residuals would have their least sum of squares if they were linear.
class LinearDraw {
 public:
  LinearDraw(const ContactFit& fit, ContactProblem& problem, const ContactOptimum& best)
      : q_(best.fit.values) {
    problem.set(rough);
    jacobian_ = problem.model().jacobian(best.ln) * problem.coordinates().derivatives(q_);
    for (const FittedPoint& p : fit.points) residuals_.push_back(p.residual);
  }

  /// The optimum itself if the step is large: of outliers or too few points.
  std::vector<double> start(std::span<const std::size_t> drawn) const {
    constexpr double longest = 0.5;
    const auto rows = static_cast<Eigen::Index>(drawn.size());
    Eigen::MatrixXd j(rows, jacobian_.cols());
    Eigen::VectorXd r(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const std::size_t k = drawn[static_cast<std::size_t>(i)];
      j.row(i) = jacobian_.row(static_cast<Eigen::Index>(k));
      r[i] = residuals_[k];
    }
    const Eigen::VectorXd step = -j.colPivHouseholderQr().solve(r);
    std::vector<double> q = q_;
    if (!step.allFinite() || !(step.cwiseAbs().maxCoeff() < longest)) return q;
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += step[static_cast<Eigen::Index>(k)];
    return q;
  }

 private:
  std::vector<double> q_;
  Eigen::MatrixXd jacobian_;
  std::vector<double> residuals_;
};

/// The quantile q of sorted values.
double quantile(const std::vector<double>& sorted, double q) {
  const double at = q * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - std::floor(at)) * (sorted[above] - sorted[below]);
}

void add_bootstrap(ContactFit& fit, ContactProblem& problem, const ContactOptimum& best,
                   const IntervalSettings& settings) {
  std::mt19937_64 random(settings.seed);
  const LinearDraw linear(fit, problem, best);
  const auto parts = parts_of(fit);
  if (parts.size() < least_parts) {
    fit.notes.push_back(fmt::format("bootstrap: left out, the residuals fall into {} independent parts only", parts.size()));
    return;
  }
  std::vector<std::vector<double>> found(fit.parameters.size());
  for (std::size_t i = 0; i < settings.draws; ++i) {
    std::vector<std::size_t> drawn = draw(parts, random);
    std::vector<double> start = linear.start(drawn);
    const ContactOptimum o = problem.solve(std::move(start), rough, {{}, std::move(drawn)});
    if (!std::isfinite(o.cost) || !o.ln.allFinite()) continue;
    ++fit.draws;
    for (std::size_t k = 0; k < found.size(); ++k)
      found[k].push_back(std::exp(o.ln[static_cast<Eigen::Index>(k)]));
  }
  if (fit.draws * 10 < settings.draws * 9)
    fit.notes.push_back(fmt::format("bootstrap: only {} of {} draws led to an optimum", fit.draws, settings.draws));
  if (fit.draws < 10) return;
  for (std::size_t k = 0; k < found.size(); ++k) {
    std::ranges::sort(found[k]);
    fit.parameters[k].bootstrap = {quantile(found[k], (1 - settings.level) / 2),
                                   quantile(found[k], (1 + settings.level) / 2)};
  }
}

}  // namespace

double normal_quantile(double level) {
  double low = 0, high = 40;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (std::erfc(middle / std::sqrt(2.0)) > 1 - level ? low : high) = middle;
  }
  return (low + high) / 2;
}

void add_intervals(ContactFit& fit, ContactProblem& problem, const ContactOptimum& best,
                   const IntervalSettings& settings) {
  if (settings.profile) add_profiles(fit, problem, best, settings.level);
  if (settings.draws > 0) add_bootstrap(fit, problem, best, settings);
}

}  // namespace mdana
