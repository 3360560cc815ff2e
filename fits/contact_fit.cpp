// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/contact_fit.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include <Eigen/SVD>
#include <fmt/format.h>

#include "fits/contact_intervals.hpp"
#include "fits/contact_problem.hpp"
#include "fits/cross_validation.hpp"
#include "fits/repeats.hpp"
#include "fits/residual_memory.hpp"
#include "fits/weak_direction.hpp"

namespace mdana {
namespace {

constexpr double same = 1e-4;         ///< minima whose ln parameters differ by less are one
constexpr double nearly_same = 0.02;  ///< the same of soft ones
constexpr double hopeless = 10;       ///< a soft cost so many times the best is not worth more work
constexpr std::size_t candidates_per_start = 4;
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

/// Some of these, evenly out of their order.
void take(std::vector<std::size_t>& chosen, std::span<const std::size_t> from, std::size_t count) {
  constexpr double golden = 0.6180339887498949;
  std::set<std::size_t> taken;
  for (double x = 0.5; taken.size() < std::min(count, from.size()); x += golden, x -= std::floor(x))
    taken.insert(from[static_cast<std::size_t>(x * static_cast<double>(from.size()))]);
  chosen.insert(chosen.end(), taken.begin(), taken.end());
}

/// Some of the residuals, enough to find the valley: more of bounces, which tell more.
std::vector<std::size_t> sample(const ContactModel& model, std::span<const ObservedCollision> seen) {
  std::vector<std::size_t> bouncing, sticking, chosen;
  for (std::size_t k = 0; k < model.residuals(); ++k)
    (seen[model.seen_of(k)].stuck ? sticking : bouncing).push_back(k);
  const std::size_t p = model.targets().size();
  take(chosen, bouncing, std::max(2 * p + 4, bouncing.size() / 4));
  take(chosen, sticking, std::max(p + 1, sticking.size() / 4));
  return chosen;
}

/// The given start or the middle, and the best of candidates spread over the ranges.
std::vector<std::vector<double>> starts(ContactProblem& problem, std::size_t count,
                                        std::span<const std::size_t> points) {
  std::vector<std::pair<double, std::vector<double>>> candidates;
  for (std::size_t k = 1; k < candidates_per_start * count && count > 1; ++k) {
    std::vector<double> q = problem.coordinates().start(k);
    candidates.emplace_back(problem.cost(problem.coordinates().logarithms(q), soft, points), std::move(q));
  }
  std::ranges::stable_sort(candidates, {}, [](const auto& c) { return c.first; });
  std::vector<std::vector<double>> all{problem.coordinates().start(0)};
  for (std::size_t k = 0; k < candidates.size() && all.size() < count; ++k)
    all.push_back(std::move(candidates[k].second));
  return all;
}

/// Whether the cost, soft and of some of the data, only falls on the straight line from one place to
/// another: then the first lies in the other's valley.
bool leads_to(ContactProblem& problem, const ContactOptimum& from, const ContactOptimum& to,
              std::span<const std::size_t> points) {
  double last = problem.cost(from.ln, soft, points);
  for (const double part : {0.15, 0.4, 0.7, 1.0}) {
    std::vector<double> q;
    for (std::size_t k = 0; k < from.fit.values.size(); ++k)
      q.push_back((1 - part) * from.fit.values[k] + part * to.fit.values[k]);
    const double cost = problem.cost(problem.coordinates().logarithms(q), soft, points);
    if (!(cost <= last)) return false;
    last = cost;
  }
  return true;
}

/// Soft searches from all starts with some of the data, then exact ones from where those ended, if that
/// is neither hopeless nor in the valley of an optimum that is known.
std::vector<ContactOptimum> search(ContactProblem& problem, std::span<const ObservedCollision> seen,
                                   int wanted) {
  const std::vector<std::size_t> points = sample(problem.model(), seen);
  std::vector<ContactOptimum> ends, optima;
  for (std::vector<double>& q : starts(problem, static_cast<std::size_t>(std::max(1, wanted)), points))
    ends.push_back(problem.solve(std::move(q), soft, {{}, points}));
  ends = distinct(std::move(ends), nearly_same);
  const auto n = static_cast<double>(points.size());
  const double worth = ends.empty() ? 0 : hopeless * ends.front().cost + n / 4;
  for (ContactOptimum& end : ends) {
    const auto known = std::ranges::find_if(
        optima, [&](const ContactOptimum& o) { return leads_to(problem, end, o, points); });
    if (known != optima.end()) {
      known->starts += end.starts;
      continue;
    }
    const int count = end.starts;
    if (end.cost <= worth) {
      end = problem.solve(std::move(end.fit.values), rough);
      if (optima.empty() || end.cost <= hopeless * (optima.front().cost + n))
        end = problem.solve(std::move(end.fit.values), exact);
    } else {
      end.cost = problem.cost(end.ln, exact);
    }
    end.starts = count;
    optima.push_back(std::move(end));
  }
  return distinct(std::move(optima), same);
}

std::vector<double> plain(const Eigen::VectorXd& ln) {
  const Eigen::VectorXd values = ln.array().exp();
  return {values.begin(), values.end()};
}

/// What the optimum says of the parameters themselves.
void describe(ContactFit& result, const ContactProblem& problem, const ContactOptimum& best) {
  const ContactModel& model = problem.model();
  const Eigen::MatrixXd by = problem.coordinates().derivatives(best.fit.values);
  const Eigen::MatrixXd covariance = result.residual_memory * by * best.fit.covariance * by.transpose();
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

/// Residuals, chi2 and what follows from them.
void score(ContactFit& result, const ContactModel& model, const Eigen::VectorXd& ln) {
  for (std::size_t i = 0; i < model.residuals(); ++i) {
    const double r = model.residual(i, ln);
    result.points.push_back({model.seen_of(i), model.quantity_of(i), model.sample_of(i), model.predicted(i, ln), r});
    result.chi2 += r * r;
  }
  result.residual_memory = residual_memory(result.points);
  const double all = static_cast<double>(model.residuals()), n = all / result.residual_memory;
  const auto k = static_cast<double>(ln.size());
  const double deviance = result.known_errors ? result.chi2 / result.residual_memory : n * std::log(result.chi2 / all);
  result.aic = deviance + 2 * k;
  result.bic = deviance + k * std::log(n);
}

void cross_validate(ContactFit& result, ContactProblem& problem, const ContactOptimum* best,
                    std::span<const ObservedCollision> seen) {
  result.left_out_velocity = cross_validated(problem, best, seen, "v");
  if (std::ranges::none_of(problem.model().targets(), [](const auto& t) { return t.radius.has_value(); }))
    result.left_out_radius = cross_validated(problem, best, seen, "R");
}

/// The law without anything to be found.
void judge_as_it_stands(ContactFit& result, ContactProblem& problem, bool cross_validation,
                        std::span<const ObservedCollision> seen) {
  problem.set(exact);
  score(result, problem.model(), Eigen::VectorXd(0));
  if (!std::isfinite(result.chi2)) result.reason = "a collision is unresolved: " + problem.model().failure();
  if (cross_validation) cross_validate(result, problem, nullptr, seen);
}

/// The one velocity of all collisions, if there is only one and none was followed: elasticity and
/// dissipation that grow with the load are told apart by how they depend on it.
std::optional<double> only_velocity(std::span<const ObservedCollision> seen) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (const ObservedCollision& s : seen) {
    const auto v = s.find("v");
    if (!v || !s.motion.empty()) return std::nullopt;
    least = std::min(least, *v);
    greatest = std::max(greatest, *v);
  }
  if (greatest > (1 + same_velocity_of_runs) * least) return std::nullopt;
  return least;
}

/// A parameter of which an infinite value makes a simpler law, and what that is called.
struct Limit {
  std::string_view law, parameter, name;
};
constexpr Limit elastic{"andrews", "Y", "the elastic limit (Y infinite)"};
constexpr Limit rigid_plastic{"andrews", "E", "the rigid plastic limit (E infinite)"};

/// Whether a cost that is greater by one parameter less is so by less than two standard deviations.
bool as_good(double limit, double best, bool known_errors, std::size_t residuals, std::size_t parameters) {
  const auto n = static_cast<double>(residuals), freedom = n - static_cast<double>(parameters);
  if (known_errors) return limit - best < 4 * std::max(1.0, freedom > 0 ? best / freedom : 1);
  return limit <= best || n * std::log(limit / best) < 4;
}

/// That a limit describes the data as well, in words; empty if it does not.
std::string as_good_as(ContactProblem& problem, const ContactOptimum& best, const CollisionLaw& law, const Limit& limit) {
  constexpr double infinite = 1e6;  ///< times the greatest parameter, both being pressures
  const ContactModel& model = problem.model();
  if (limit.law != law.name || model.targets().size() != 2 || problem.has_priors()) return {};
  const auto k = std::ranges::find(model.targets(), limit.parameter, &ContactModel::Target::parameter);
  if (k == model.targets().end()) return {};
  Eigen::VectorXd ln = best.ln;
  const auto fixed = static_cast<std::size_t>(k - model.targets().begin());
  ln[static_cast<Eigen::Index>(fixed)] = best.ln.maxCoeff() + std::log(infinite);
  const double cost = problem.solve_fixed(ln, fixed, exact).cost;
  if (!as_good(cost, best.cost, model.known_errors(), model.residuals(), model.targets().size())) return {};
  return fmt::format("{} describes the collisions as well (cost {:.4g} against {:.4g}): {} is only bounded", limit.name,
                     cost, best.cost, limit.parameter);
}

/// The parameter whose best value is on or beyond a bound; empty if none is.
std::string on_bound(const ContactFit& result, const ContactProblem& problem, const ContactOptimum& best) {
  const FitCoordinates& coordinates = problem.coordinates();
  const Eigen::VectorXd beyond = coordinates.beyond(best.fit.values);
  for (Eigen::Index k = 0; k < beyond.size(); ++k)
    if (beyond[k] != 0) return result.parameters[static_cast<std::size_t>(k) % coordinates.size()].full_name();
  return {};
}

/// The parameter whose standard error is greater than itself; empty if none is.
std::string not_determined(const ContactFit& result) {
  for (const Estimate& p : result.parameters)
    if (!(p.error < least_known * p.value)) return p.full_name();
  return {};
}

/// Why the parameters cannot be believed; empty if they can.
std::string doubt(ContactFit& result, ContactProblem& problem, const ContactOptimum& best, const CollisionLaw& law,
                  std::span<const ObservedCollision> seen, std::size_t free) {
  const std::string weak = result.weak_direction.empty() ? "" : "; " + result.weak_direction;
  if (const auto v = only_velocity(seen); v && free > 1 && !problem.has_priors())
    return fmt::format("all collisions have v = {:g}: one velocity does not determine {} parameters{}", *v, free, weak);
  const auto& s = result.singular_values;
  const bool singular = s.size() < result.parameters.size() || !(s.back() > 1e-6 * s.front());
  const std::string bound = on_bound(result, problem, best);
  if (singular && bound.empty() && !problem.has_priors())
    return "the data do not determine all parameters: " + result.weak_direction;
  if (const std::string limit = singular ? "" : as_good_as(problem, best, law, elastic); !limit.empty())
    return limit + weak;
  const std::string limit = as_good_as(problem, best, law, rigid_plastic);
  const std::string but = limit.empty() ? "" : limit + "; ";
  if (!bound.empty()) return fmt::format("{}the best {} lies on its bound", but, bound);
  if (!best.fit.usable) return but + best.fit.reason;
  if (const std::string name = not_determined(result); !name.empty())
    return fmt::format("{}{} is not determined (its standard error is greater than itself){}", but, name, weak);
  if (!limit.empty()) result.notes.push_back(limit);
  return {};
}

void fit_all(ContactFit& result, ContactProblem& problem, const CollisionLaw& law,
             std::span<const ObservedCollision> seen, const ContactFitSettings& settings) {
  if (settings.free.empty()) return judge_as_it_stands(result, problem, settings.cross_validation, seen);
  if (problem.model().only_sticking()) {
    result.reason = "every collision sticks: that bounds the parameters, but determines none";
    return;
  }
  const std::vector<ContactOptimum> optima = search(problem, seen, settings.starts);
  if (optima.empty()) {
    result.reason = "no start led to an optimum: " + problem.model().failure();
    return;
  }
  problem.set(exact);
  const ContactOptimum& best = optima.front();
  for (const ContactOptimum& o : optima) result.minima.push_back({plain(o.ln), o.cost, o.starts});
  score(result, problem.model(), best.ln);
  describe(result, problem, best);
  result.digits = best.fit.digits;
  result.reason = doubt(result, problem, best, law, seen, settings.free.size());
  if (result.reason.empty()) add_intervals(result, problem, best, settings.intervals);
  if (settings.cross_validation) cross_validate(result, problem, &best, seen);
}

}  // namespace

std::string Estimate::full_name() const {
  return radius ? fmt::format("{}(R={:g})", name, *radius) : name;
}

ContactFit fit_contact(const CollisionLaw& law, std::span<const ObservedCollision> seen,
                       const ContactFitSettings& settings) {
  const auto begin = std::chrono::steady_clock::now();
  ContactProblem problem(law, seen, settings);
  ContactFit result;
  result.known_errors = problem.model().known_errors();
  fit_all(result, problem, law, seen, settings);
  result.usable = result.reason.empty();
  result.collisions = problem.model().collisions();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace mdana
